#include "face_diagram.h"

#include <bit>
#include <cmath>
#include <tuple>

#include "../geom/plane_line.h"
#include "tangent_spheres.h"

namespace crossloft {
namespace {

/// Calls visit(f) for each bit of the set.
template <class Visit>
void for_each(std::uint64_t set, Visit&& visit) {
  for (; set != 0; set &= set - 1) visit(static_cast<std::uint32_t>(std::countr_zero(set)));
}

/// The centre of the sphere through four points, seen from the first: offset / denominator.
struct SphereCentre {
  Vec3 offset;
  double denominator;  ///< > 0; near 0 for a sliver
};

SphereCentre sphere_centre(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  const Vec3 vw = cross(v, w), wu = cross(w, u), uv = cross(u, v);
  const Vec3 offset = dot(u, u) * vw + dot(v, v) * wu + dot(w, w) * uv;
  const double volume = dot(u, vw);
  return volume < 0 ? SphereCentre{-offset, -2 * volume} : SphereCentre{offset, 2 * volume};
}

template <std::size_t N>
std::array<std::uint32_t, N> ascending(std::array<std::uint32_t, N> v) {
  for (std::size_t end = N - 1; end > 0; --end)
    for (std::size_t k = 0; k < end; ++k)
      if (v[k] > v[k + 1]) std::swap(v[k], v[k + 1]);
  return v;
}

}  // namespace

bool before(const FaceArc& a, const FaceArc& b) {
  return std::tie(a.sites, a.from, a.to) < std::tie(b.sites, b.from, b.to);
}

CellDiagrams::CellDiagrams(const CellSites& sites, std::uint32_t word) : sites_(sites), word_(word) {
  const std::size_t faces = sites.faces.size() - std::min(sites.faces.size(), 64 * std::size_t{word});
  face_count_ = static_cast<std::uint32_t>(std::min<std::size_t>(faces, 64));
  all_ = face_count_ == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << face_count_) - 1;
  measure_heights();
  inside_.reserve(sites.mesh->size());
  for (std::uint32_t t = 0; t < sites.mesh->size(); ++t) inside_.push_back(inside_of(t));
}

/// All points of a parallel face get the same height, whatever their kind rounds to: their arcs are lines
/// then.
void CellDiagrams::measure_heights() {
  heights_.assign(sites_.points.size() * face_count_, 0);
  for (std::uint32_t f = 0; f < face_count_; ++f) {
    std::uint64_t parallel = 0;
    double parallel_height = 0;
    for (std::uint32_t g = 0; g < face_count_; ++g)
      if (g != f && line_axis(frame(f).plane(), frame(g).plane()) < 0) {
        parallel |= std::uint64_t{1} << g;
        parallel_height = frame(f).height(make_point(frame(g).plane().origin));
      }
    for (std::uint32_t v = 0; v < sites_.points.size(); ++v)
      if (!is_on(v, f))
        heights_[std::size_t{v} * face_count_ + f] =
            (on(v) & parallel) != 0 ? parallel_height : frame(f).height(sites_.points[v]);
  }
}

/// Inside the surface: the centre is higher over the face than it is far from the vertices. A sphere through
/// a vertex on the face reaches its plane: outside.
std::uint64_t CellDiagrams::inside_of(std::uint32_t tet) const {
  const auto v = ascending(sites_.mesh->vertices[tet]);
  const std::uint64_t faces = all_ & ~(on(v[0]) | on(v[1]) | on(v[2]) | on(v[3]));
  if (faces == 0) return 0;
  const SphereCentre centre = sphere_centre(point(v[0]), point(v[1]), point(v[2]), point(v[3]));
  const double distance = norm(centre.offset);
  std::uint64_t inside = 0;
  for_each(faces, [&](std::uint32_t f) {
    const double rise = centre.denominator * height(v[0], f) + dot(frame(f).up(), centre.offset);
    inside |= std::uint64_t{rise > distance} << f;
  });
  return inside;
}

/// At infinity all is outside, but for one direction.
std::uint64_t CellDiagrams::open_faces(std::uint32_t tet, std::size_t edge) const {
  const auto &v = sites_.mesh->vertices[tet], &neighbour = sites_.mesh->neighbours[tet];
  const auto &ends = kEdgeSlots[edge], &others = kEdgeSlots[5 - edge];
  const std::uint64_t faces = all_ & ~(on(v[ends[0]]) | on(v[ends[1]]));
  const bool on_hull = neighbour[others[0]] == kNone || neighbour[others[1]] == kNone;
  return on_hull ? faces : faces & ~inside_[tet];
}

void CellDiagrams::edge_arcs(std::uint32_t tet, std::size_t edge, std::uint64_t wanted, Arcs arcs) {
  facet_.walk(*sites_.mesh, tet, edge);
  std::uint64_t all_inside = facet_.on_hull ? 0 : ~std::uint64_t{0};
  for (const EdgeWedge& wedge : facet_.wedges) {
    all_inside &= inside_[wedge.tet];
    done_[wedge.tet] = static_cast<std::uint8_t>(done_[wedge.tet] | 1u << wedge.edge);
  }
  const std::uint64_t faces = all_ & wanted & ~all_inside & ~(on(facet_.i) | on(facet_.j));
  for_each(faces, [&](std::uint32_t f) { face_arcs(f, arcs[f]); });
}

void CellDiagrams::face_arcs(std::uint32_t face, std::vector<FaceArc>& arcs) {
  find_passages(face);
  cut_.clear();
  cut_facet(passages_, cut_);
  if (cut_.empty()) return whole_circle(face, arcs);
  const MoebiusCurve curve = tangent_curve(site(facet_.i, face), site(facet_.j, face));
  for (const FacetArc& piece : cut_) {
    FaceArc arc{{facet_.i, facet_.j}, curve, {}, {}, false, false, false};
    arc.from_infinite = piece.from.side == facet_.sides.size();
    arc.to_infinite = piece.to.side == facet_.sides.size();
    if (!arc.from_infinite) arc.from = crossing(piece.from, face);
    if (!arc.to_infinite) arc.to = crossing(piece.to, face);
    arcs.push_back(arc);
  }
}

/// Without a crossing the circle lies within the facet or outside it, as any one of its points does.
void CellDiagrams::whole_circle(std::uint32_t face, std::vector<FaceArc>& arcs) const {
  const FaceSite i = site(facet_.i, face), j = site(facet_.j, face);
  if (i.height == j.height) return;
  for (const EdgeWedge& wedge : facet_.wedges)
    if ((inside_[wedge.tet] >> face & 1) != 0) return;  // all are: the circle would be beyond
  const Vec2 at = near_point_of_circle(i, j);
  const Vec3 centre = frame(face).to_space(at) + tangent_radius(i, at) * frame(face).up();
  const Vec3 to_centre = centre - point(facet_.i);
  for (const VoronoiSide& side : facet_.sides) {
    const Vec3 w = point(side.apex) - point(facet_.i);
    if (!is_on(side.apex, face) && dot(w, w) < 2 * dot(w, to_centre)) return;
  }
  arcs.push_back({{facet_.i, facet_.j}, tangent_curve(i, j), at, at, true, false, false});
}

void CellDiagrams::find_passages(std::uint32_t face) {
  passages_.clear();
  for (const VoronoiSide& side : facet_.sides) passages_.push_back(passage(side, face));
  if (facet_.on_hull) passages_.push_back(passage_at_infinity(face));
}

Passage CellDiagrams::passage(const VoronoiSide& side, std::uint32_t face) const {
  if (is_on(side.apex, face)) return Passage::outside;
  const bool from = inside_at(side.from, side, -1, face), to = inside_at(side.to, side, 1, face);
  if (from) return to ? Passage::inside : Passage::leaves;
  if (to) return Passage::enters;
  return dips(side, face) ? Passage::dips : Passage::outside;
}

/// At an end of a side; `way` is -1 for its begin, 1 for its end. At infinity: inside straight up only, where
/// the three sites are the highest.
bool CellDiagrams::inside_at(std::uint32_t tet, const VoronoiSide& side, int way, std::uint32_t face) const {
  if (tet != kNone) return (inside_[tet] >> face & 1) != 0;
  const double top = height(facet_.i, face);
  if (height(facet_.j, face) != top || height(side.apex, face) != top) return false;
  const Vec3 i = point(facet_.i);
  const Vec3 along = cross(point(facet_.j) - i, point(side.apex) - i);
  return way * dot(along, frame(face).up()) > 0;
}

/// The gap from the last side's end to the first one's begin.
Passage CellDiagrams::passage_at_infinity(std::uint32_t face) const {
  const VoronoiSide &last = facet_.sides.back(), &first = facet_.sides.front();
  const bool from = inside_at(kNone, last, 1, face), to = inside_at(kNone, first, -1, face);
  if (from) return to ? Passage::inside : Passage::leaves;
  if (to) return Passage::enters;
  const double top = height(facet_.i, face);
  const bool highest =
      height(facet_.j, face) == top && height(last.apex, face) < top && height(first.apex, face) < top;
  return highest ? Passage::dips : Passage::outside;
}

/// Both ends outside: inside in between iff the middle of the two tangent spheres' centres is between the
/// ends, where neither fourth vertex is nearer.
bool CellDiagrams::dips(const VoronoiSide& side, std::uint32_t face) const {
  const auto v = ascending(std::array{facet_.i, facet_.j, side.apex});
  const TriangleAxis axis(point(v[0]), point(v[1]), point(v[2]));
  const TangentSpheres spheres(axis, frame(face), height(v[0], face));
  const auto farther = [&](std::uint32_t w) { return w == kNone || spheres.farther_from_middle(point(w)); };
  return spheres.exist() && farther(side.from_vertex) && farther(side.to_vertex);
}

Vec2 CellDiagrams::crossing(const FacetCrossing& at, std::uint32_t face) const {
  const std::uint32_t i = facet_.i, j = facet_.j, apex = facet_.sides[at.side].apex;
  const auto v = ascending(std::array{i, j, apex});
  const TriangleAxis axis(point(v[0]), point(v[1]), point(v[2]));
  const TangentSpheres spheres(axis, frame(face), height(v[0], face));
  // The surface is left at the second root along the side, which runs along the normal of (i, j, apex).
  const Passage passage = passages_[at.side];
  const bool second = passage == Passage::leaves || (passage == Passage::dips && at.root == 1);
  const bool along_axis = apex < i || apex > j;
  return spheres.touch(second == along_axis);
}

}  // namespace crossloft
