#include "face_diagram.h"

#include <bit>
#include <cmath>
#include <limits>
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

void order(std::uint32_t& a, std::uint32_t& b) {
  const std::uint32_t low = std::min(a, b);
  b = std::max(a, b);
  a = low;
}

std::array<std::uint32_t, 3> ascending(std::array<std::uint32_t, 3> v) {
  order(v[0], v[1]);
  order(v[1], v[2]);
  order(v[0], v[1]);
  return v;
}

std::array<std::uint32_t, 4> ascending(std::array<std::uint32_t, 4> v) {
  order(v[0], v[1]);
  order(v[2], v[3]);
  order(v[0], v[2]);
  order(v[1], v[3]);
  order(v[1], v[2]);
  return v;
}

bool is_empty(const Box2& box) { return box.low.x > box.high.x || box.low.y > box.high.y; }

struct NumberedPoint {
  std::uint32_t vertex;
  HighPoint point;
};

/// Drops the sites whose spheres are larger than those of another one all over the disk.
void drop_undercut(const Disk& disk, std::vector<NumberedPoint>& sites) {
  constexpr double kSlack = 1 + 1e-9;  // more than all rounding
  std::vector<double> lows(sites.size());
  double bound = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < sites.size(); ++k) {
    const DiameterRange range = diameters_over(disk, sites[k].point);
    lows[k] = range.low;
    bound = std::min(bound, range.high * kSlack);
  }
  std::size_t kept = 0;
  for (std::size_t k = 0; k < sites.size(); ++k)
    if (lows[k] <= bound) sites[kept++] = sites[k];
  sites.resize(kept);
}

}  // namespace

bool before(const FaceArc& a, const FaceArc& b) {
  return std::tie(a.sites, a.from, a.to) < std::tie(b.sites, b.from, b.to);
}

CellDiagrams::CellDiagrams(const CellSites& sites, std::uint32_t word) : sites_(sites), word_(word) {
  const std::size_t faces = sites.faces.size() - std::min(sites.faces.size(), 64 * std::size_t{word});
  face_count_ = static_cast<std::uint32_t>(std::min<std::size_t>(faces, 64));
  all_ = face_count_ == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << face_count_) - 1;
  wanted_ = all_;
  for (std::uint32_t f = 0; f < face_count_ && !sites.regions.empty(); ++f)
    if (is_empty(region(f))) wanted_ ^= std::uint64_t{1} << f;
  heights_.resize(sites.points.size() * face_count_);
  for_each(wanted_, [&](std::uint32_t f) { measure_heights(f); });
  for (std::uint32_t v = 0; v < sites.points.size(); ++v) near_.push_back(wanted_ & ~on(v));
  if (!sites.regions.empty()) {
    disks_.resize(face_count_);
    for_each(wanted_, [&](std::uint32_t f) { find_near(f); });
  }
  inside_.resize(sites.mesh->size());
  state_.resize(sites.mesh->size());
}

/// All points of the parallel face get the same height, whatever their kind rounds to: their arcs are lines
/// then. A convex cell has one such face at most, of any word.
void CellDiagrams::measure_heights(std::uint32_t face) {
  const LatticePlane& plane = frame(face).plane();
  std::size_t opposite = 0;
  while (opposite < sites_.faces.size() && (opposite == 64 * std::size_t{word_} + face ||
                                            line_axis(plane, sites_.faces[opposite].plane()) >= 0))
    ++opposite;
  const bool has_opposite = opposite < sites_.faces.size();
  const double opposite_height =
      has_opposite ? frame(face).height(make_point(sites_.faces[opposite].plane().origin)) : 0;
  for (std::uint32_t v = 0; v < sites_.points.size(); ++v) {
    if ((on(v) >> face & 1) != 0) continue;
    const bool is_opposite =
        has_opposite &&
        (sites_.on_faces[std::size_t{v} * sites_.words + opposite / 64] >> opposite % 64 & 1) != 0;
    heights_[std::size_t{v} * face_count_ + face] =
        is_opposite ? opposite_height : frame(face).height(sites_.points[v]);
  }
}

/// Nearest nowhere in the region is a site that another one undercuts in each of its parts.
void CellDiagrams::find_near(std::uint32_t face) {
  disks_[face] = disk_around(frame(face), region(face));
  const std::uint64_t bit = std::uint64_t{1} << face;
  std::vector<NumberedPoint> sites;
  for (std::uint32_t v = 0; v < near_.size(); ++v)
    if ((near_[v] & bit) != 0) {
      near_[v] ^= bit;
      sites.push_back({v, {point(v), height(v, face)}});
    }
  drop_undercut(disks_[face], sites);
  for (const Disk& disk : disks_over(frame(face), region(face))) {
    std::vector<NumberedPoint> left = sites;
    drop_undercut(disk, left);
    for (const NumberedPoint& site : left) near_[site.vertex] |= bit;
  }
}

std::uint64_t CellDiagrams::inside(std::uint32_t tet) {
  if ((state_[tet] & kKnown) == 0) {
    inside_[tet] = inside_of(tet);
    state_[tet] |= kKnown;
  }
  return inside_[tet];
}

/// Inside the surface: the centre is higher over the face than it is far from the vertices. A sphere through
/// a vertex on the face reaches its plane: outside.
std::uint64_t CellDiagrams::inside_of(std::uint32_t tet) const {
  const auto& given = sites_.mesh->vertices[tet];
  const std::uint64_t faces = wanted_ & ~(on(given[0]) | on(given[1]) | on(given[2]) | on(given[3]));
  if (faces == 0) return 0;
  const auto v = ascending(given);
  const SphereCentre centre = sphere_centre(point(v[0]), point(v[1]), point(v[2]), point(v[3]));
  const double distance = norm(centre.offset);
  std::uint64_t inside = 0;
  for_each(faces, [&](std::uint32_t f) {
    const double rise = centre.denominator * height(v[0], f) + dot(frame(f).up(), centre.offset);
    inside |= std::uint64_t{rise > distance} << f;
  });
  return inside;
}

/// All of the faces within reach, or none if there is no arc to be found from here: if the facet's corner is
/// inside a surface, what crosses that is seen from another corner. At infinity all is outside, but for one
/// direction.
std::uint64_t CellDiagrams::may_have_arcs(const TetEdge& edge, std::uint64_t faces) {
  const auto& neighbour = sites_.mesh->neighbours[edge.tet];
  const auto [c, d] = kEdgeSlots[5 - edge.edge];
  const bool on_hull = neighbour[c] == kNone || neighbour[d] == kNone;
  const std::uint64_t inside_here = on_hull ? 0 : inside(edge.tet);
  const std::uint64_t open = within_reach(edge, faces & ~inside_here);
  return open == 0 ? 0 : open | within_reach(edge, faces & inside_here);
}

/// Faces in whose region there may be arcs between i and j.
std::uint64_t CellDiagrams::within_reach(const TetEdge& edge, std::uint64_t faces) const {
  if (disks_.empty()) return faces;
  std::uint64_t set = 0;
  for_each(faces, [&](std::uint32_t f) {
    const HighPoint i{point(edge.i), height(edge.i, f)}, j{point(edge.j), height(edge.j, f)};
    set |= std::uint64_t{change_ranks(disks_[f], i, j)} << f;
  });
  return set;
}

void CellDiagrams::edge_arcs(const TetEdge& edge, std::uint64_t faces, Arcs arcs) {
  facet_.walk(*sites_.mesh, edge.tet, edge.edge);
  for (const EdgeWedge& wedge : facet_.wedges)
    state_[wedge.tet] |= static_cast<std::uint8_t>(1u << wedge.edge);
  cut_sides(faces);
  std::uint64_t crossed = 0, inside_somewhere = 0;
  for (const SideCut& cut : cuts_) {
    crossed |= cut.enters | cut.leaves | cut.dips;
    inside_somewhere |= cut.inside;
  }
  for_each(faces & crossed, [&](std::uint32_t f) { face_arcs(f, arcs[f]); });
  for_each(faces & ~crossed & ~inside_somewhere, [&](std::uint32_t f) { whole_circle(f, arcs[f]); });
}

void CellDiagrams::cut_sides(std::uint64_t faces) {
  cuts_.clear();
  const auto add = [&](std::uint64_t from, std::uint64_t to) {
    cuts_.push_back({faces & ~from & to, faces & from & ~to, 0, faces & from & to, std::nullopt});
  };
  const auto at_infinity = [&](const VoronoiSide& side, int way) { return straight_up(side, way, faces); };
  for (const VoronoiSide& side : facet_.sides) {
    const std::uint64_t from = side.from == kNone ? at_infinity(side, -1) : inside(side.from);
    const std::uint64_t to = side.to == kNone ? at_infinity(side, 1) : inside(side.to);
    add(from, to);
    const std::uint64_t quiet = faces & ~from & ~to & ~on(side.apex);
    if (quiet != 0) cuts_.back().dips = dips(cuts_.size() - 1, quiet);
  }
  if (!facet_.on_hull) return;
  const std::uint64_t from = at_infinity(facet_.sides.back(), 1), to = at_infinity(facet_.sides.front(), -1);
  add(from, to);
  cuts_.back().dips = highest(faces & ~from & ~to);
}

/// Faces over which the end at infinity of a side is inside: it goes straight up, from the three highest
/// sites. `way` is -1 for the begin of the side, 1 for its end.
std::uint64_t CellDiagrams::straight_up(const VoronoiSide& side, int way, std::uint64_t faces) const {
  std::uint64_t up = 0;
  for_each(faces, [&](std::uint32_t f) {
    const double top = height(facet_.i, f);
    if (height(facet_.j, f) != top || height(side.apex, f) != top) return;
    const Vec3 i = point(facet_.i);
    const Vec3 along = cross(point(facet_.j) - i, point(side.apex) - i);
    up |= std::uint64_t{way * dot(along, frame(f).up()) > 0} << f;
  });
  return up;
}

/// Faces over which i and j alone are the highest sites: the gap at infinity is inside in between.
std::uint64_t CellDiagrams::highest(std::uint64_t faces) const {
  const std::uint32_t first = facet_.sides.front().apex, last = facet_.sides.back().apex;
  std::uint64_t set = 0;
  for_each(faces, [&](std::uint32_t f) {
    const double top = height(facet_.i, f);
    set |= std::uint64_t{height(facet_.j, f) == top && height(first, f) < top && height(last, f) < top} << f;
  });
  return set;
}

const TriangleAxis& CellDiagrams::axis(std::size_t side) {
  std::optional<TriangleAxis>& axis = cuts_[side].axis;
  if (!axis) {
    const auto v = ascending(std::array{facet_.i, facet_.j, facet_.sides[side].apex});
    axis.emplace(point(v[0]), point(v[1]), point(v[2]));
  }
  return *axis;
}

/// Faces whose surface a side with both ends outside dips into: the middle of the centres of the two tangent
/// spheres is between the ends, where neither fourth vertex is nearer.
std::uint64_t CellDiagrams::dips(std::size_t side, std::uint64_t faces) {
  const TriangleAxis& line = axis(side);
  const VoronoiSide& ends = facet_.sides[side];
  const std::uint32_t base = std::min(facet_.i, ends.apex);
  std::uint64_t set = 0;
  for_each(faces, [&](std::uint32_t f) {
    const TangentSpheres spheres(line, frame(f), height(base, f));
    const auto farther = [&](std::uint32_t w) { return w == kNone || spheres.farther_from_middle(point(w)); };
    set |= std::uint64_t{spheres.exist() && farther(ends.from_vertex) && farther(ends.to_vertex)} << f;
  });
  return set;
}

void CellDiagrams::face_arcs(std::uint32_t face, std::vector<FaceArc>& arcs) {
  passages_.clear();
  for (const SideCut& cut : cuts_) {
    const auto has = [&](std::uint64_t faces) { return (faces >> face & 1) != 0; };
    passages_.push_back(has(cut.enters)   ? Passage::enters
                        : has(cut.leaves) ? Passage::leaves
                        : has(cut.dips)   ? Passage::dips
                        : has(cut.inside) ? Passage::inside
                                          : Passage::outside);
  }
  pieces_.clear();
  cut_facet(passages_, pieces_);
  const FaceSite i = site(facet_.i, face), j = site(facet_.j, face);
  const MoebiusCurve curve = tangent_curve(i, j);
  const std::size_t first = arcs.size();
  for (const FacetArc& piece : pieces_) {
    FaceArc arc{{facet_.i, facet_.j}, curve, {}, {}, i.height > j.height, false, false, false, false};
    arc.from_infinite = piece.from.side == facet_.sides.size();
    arc.to_infinite = piece.to.side == facet_.sides.size();
    if (!arc.from_infinite) arc.from = crossing(piece.from, face);
    if (!arc.to_infinite) arc.to = crossing(piece.to, face);
    // Three sites on a line within rounding may have no crossing that a double can hold; NaN must not be sorted.
    if (is_finite(arc.from) && is_finite(arc.to)) arcs.push_back(arc);
  }
  if (curve.is_line) return;
  const std::span<FaceArc> ours = std::span(arcs).subspan(first);
  for (FaceArc& arc : ours) arc.over_half = is_over_half(arc, ours, face);
}

/// The side of the chord that the centre is on tells, but where the ends are so close that rounding may have
/// swapped them. There the place across the circle is in the facet, and no other arc's, or the arc is a short
/// one.
bool CellDiagrams::is_over_half(const FaceArc& arc, std::span<const FaceArc> of_facet,
                                std::uint32_t face) const {
  const auto is_closed = [](const FaceArc& a) {
    const Vec2 chord = a.to - a.from, to_centre = a.curve.centre - a.from;
    return dot(chord, chord) <= 1e-16 * dot(to_centre, to_centre) + 1e-24 * dot(a.from, a.from);
  };
  const Vec2 to_centre = arc.curve.centre - arc.from;
  const bool turns_back = (cross(arc.to - arc.from, to_centre) < 0) != arc.clockwise;
  if (!is_closed(arc)) return turns_back;
  return (turns_back || of_facet.size() == 1) && std::all_of(of_facet.begin(), of_facet.end(), is_closed) &&
         facet_holds(site(facet_.i, face), arc.curve.centre + to_centre, face, 1e-9);
}

/// A root of the side. Where the surface passes through a corner, rounding may have put the corner on the
/// wrong side and the root that was chosen may be far away: the nearest place on the side is right then.
Vec2 CellDiagrams::crossing(const FacetCrossing& at, std::uint32_t face) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const VoronoiSide& side = facet_.sides[at.side];
  const TriangleAxis& line = axis(at.side);
  const TangentSpheres spheres(line, frame(face), height(std::min(facet_.i, side.apex), face));
  // The surface is left at the second root along the side, which runs along the normal of (i, j, apex).
  const Passage passage = passages_[at.side];
  const bool second = passage == Passage::leaves || (passage == Passage::dips && at.root == 1);
  const bool along_axis = side.apex < facet_.i || side.apex > facet_.j;
  const double way = along_axis ? kInfinity : -kInfinity;
  const double from = side.from == kNone ? -way : line.place_of(point(side.from_vertex));
  const double to = side.to == kNone ? way : line.place_of(point(side.to_vertex));
  return spheres.touch(second == along_axis, std::min(from, to), std::max(from, to));
}

/// All corners and sides are outside, so the circle lies within the facet or misses it, as any one of its
/// points does. Two are asked, since one may be a tie.
void CellDiagrams::whole_circle(std::uint32_t face, std::vector<FaceArc>& arcs) const {
  const FaceSite i = site(facet_.i, face), j = site(facet_.j, face);
  if (i.height == j.height) return;
  const Vec2 at = near_point_of_circle(i, j);
  if (!facet_holds(i, at, face, 0)) return;
  const MoebiusCurve curve = tangent_curve(i, j);
  if (!facet_holds(i, 2 * curve.centre - at, face, 0)) return;
  arcs.push_back({{facet_.i, facet_.j}, curve, at, at, i.height > j.height, false, true, false, false});
}

/// True iff no site around is nearer at a point of the curve of i and j, all of them farther by the margin.
bool CellDiagrams::facet_holds(const FaceSite& i, Vec2 at, std::uint32_t face, double margin) const {
  const Vec3 centre = frame(face).to_space(at) + tangent_radius(i, at) * frame(face).up();
  const Vec3 to_centre = centre - point(facet_.i);
  return std::none_of(facet_.sides.begin(), facet_.sides.end(), [&](const VoronoiSide& side) {
    const Vec3 w = point(side.apex) - point(facet_.i);
    return (on(side.apex) >> face & 1) == 0 && dot(w, w) < 2 * dot(w, to_centre) * (1 + margin);
  });
}

}  // namespace crossloft
