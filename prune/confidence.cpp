#include "confidence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "pair.h"
#include "star.h"

namespace crossloft {
namespace {

/// The points of a tetrahedron where it is measured: its centroid, then the middles from there to its
/// vertices. By twos, with the centroid a second time as the last one. What can't be predicted is decided
/// without branches.
constexpr std::size_t kPoints = 5, kPairs = 3;
constexpr std::array<double, kPoints> kWeights{0.4, 0.15, 0.15, 0.15, 0.15};
constexpr double kNowhere = std::numeric_limits<double>::infinity();

/// A number for each point.
class Lanes {
 public:
  Pair& operator[](std::size_t pair) { return pairs_[pair]; }
  const Pair& operator[](std::size_t pair) const { return pairs_[pair]; }
  double of(std::size_t point) const { return pairs_[point / 2][point % 2]; }
  void fill_last() { lower(kPoints, of(0)); }
  void lower(std::size_t point, double to) { pairs_[point / 2][point % 2] = std::min(to, of(point)); }

 private:
  std::array<Pair, kPairs> pairs_;
};

struct Points {
  Lanes x, y, z;

  Points(Vec3 centroid, const std::array<Vec3, 4>& middles) {
    const std::array<Vec3, 6> all{centroid, middles[0], middles[1], middles[2], middles[3], centroid};
    for (std::size_t k = 0; k < kPairs; ++k) {
      const Vec3 &p = all[2 * k], &q = all[2 * k + 1];
      x[k] = Pair{p.x, q.x}, y[k] = Pair{p.y, q.y}, z[k] = Pair{p.z, q.z};
    }
  }
  Vec3 at(std::size_t k) const { return {x.of(k), y.of(k), z.of(k)}; }
};

/// Squared distances to the two parts of the cell's boundary.
struct Distances {
  Lanes in, out;
};

/// To a vertex, which is in both parts.
void take_vertex(const Points& p, Vec3 a, Lanes& least) {
  for (std::size_t k = 0; k < kPairs; ++k) {
    const Pair x = p.x[k] - a.x, y = p.y[k] - a.y, z = p.z[k] - a.z;
    least[k] = least_of(x * x + y * y + z * z, least[k]);
  }
}

void take_edge(const Points& p, Vec3 a, Vec3 b, bool is_contour, Distances& d) {
  const Vec3 along = b - a;
  const double length = dot(along, along);
  const Pair if_not_contour = both(is_contour ? 0 : kNowhere);
  for (std::size_t k = 0; k < kPairs; ++k) {
    const Pair x = p.x[k] - a.x, y = p.y[k] - a.y, z = p.z[k] - a.z;
    Pair t = (x * along.x + y * along.y + z * along.z) / length;
    t = t < both(0) ? both(0) : t;
    t = least_of(both(1), t);
    const Pair u = x - t * along.x, v = y - t * along.y, w = z - t * along.z;
    const Pair square = u * u + v * v + w * w;
    d.in[k] = least_of(square, d.in[k]);
    d.out[k] = least_of(square + if_not_contour, d.out[k]);
  }
}

/// To the vertices and the grounded edges of t. `all_grounded`: no vertex of it is inside the cell.
Distances to_contours(const CellComplex& complex, const CellShape& shape, std::uint32_t t, const Points& p,
                      bool all_grounded) {
  const auto& v = complex.mesh.vertices[t];
  Distances d;
  for (std::size_t k = 0; k < kPairs; ++k) d.in[k] = both(kNowhere);
  for (const std::uint32_t corner : v)
    if (all_grounded || !complex.is_interior(corner)) take_vertex(p, shape.points[corner], d.in);
  d.out = d.in;
  unsigned grounded = 0;
  for (unsigned e = 0; e < 6; ++e) grounded |= (complex.edges[t][e] != EdgeKind::free ? 1U : 0U) << e;
  for (; grounded != 0; grounded &= grounded - 1) {
    const auto e = static_cast<unsigned>(__builtin_ctz(grounded));
    // From the smaller one, as rounding depends on where it starts.
    const auto [a, b] = std::minmax({v[kEdgeSlots[e][0]], v[kEdgeSlots[e][1]]});
    take_edge(p, shape.points[a], shape.points[b], complex.edges[t][e] == EdgeKind::contour, d);
  }
  return d;
}

bool has_interior_vertex(const CellComplex& complex, std::uint32_t t) {
  for (const std::uint32_t v : complex.mesh.vertices[t])
    if (complex.is_interior(v)) return true;
  return false;
}

double squared_distance_to(const std::array<Vec3, 2>& edge, Vec3 p) {
  const Vec3 along = edge[1] - edge[0], x = p - edge[0];
  const double t = std::clamp(dot(x, along) / dot(along, along), 0.0, 1.0);
  const Vec3 away = x - t * along;
  return dot(away, away);
}

/// The nearest contours need not be at a tetrahedron with vertices inside the cell. Sections are in reach of
/// their faces.
void take_contours(const ContourEdges& contours, const Points& p, Distances& d) {
  for (std::size_t k = 0; k < kPoints; ++k) {
    const double square = contours.squared_distance(p.at(k), d.in.of(k));
    d.in.lower(k, square);
    d.out.lower(k, square);
  }
  d.in.fill_last();
  d.out.fill_last();
}

/// Asks the section only where the face is nearer than what was found before.
void take_face(const FacePlane& face, const SectionRows& section, const Points& p, Distances& d) {
  Lanes height, square, known;
  for (std::size_t k = 0; k < kPairs; ++k) {
    height[k] = face.normal.x * p.x[k] + face.normal.y * p.y[k] + face.normal.z * p.z[k] + face.offset;
    square[k] = height[k] * height[k];
    known[k] = largest_of(d.in[k], d.out[k]);
  }
  if (section.empty()) {
    for (std::size_t k = 0; k < kPairs; ++k) d.out[k] = least_of(square[k], d.out[k]);
    return;
  }
  std::array<std::uint8_t, kPoints> asked;
  std::size_t count = 0;
  for (std::uint8_t k = 0; k < kPoints; ++k) {
    asked[count] = k;
    count += square.of(k) < known.of(k) ? 1 : 0;
  }
  if (count == 0) return;
  const int axis = section.dropped_axis();
  const Lanes &at_u = axis == 0   ? p.y
                      : axis == 1 ? p.z
                                  : p.x,
              &at_v = axis == 0   ? p.z
                      : axis == 1 ? p.x
                                  : p.y;
  const Vec3 n = face.normal;
  const double n_u = axis == 0 ? n.y : axis == 1 ? n.z : n.x, n_v = axis == 0 ? n.z : axis == 1 ? n.x : n.y;
  Lanes u, v;  // the feet
  for (std::size_t k = 0; k < kPairs; ++k) {
    u[k] = at_u[k] - height[k] * n_u;
    v[k] = at_v[k] - height[k] * n_v;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t k = asked[i];
    const bool in = section.contains(u.of(k), v.of(k));
    const std::array<double, 3> pick{kNowhere, square.of(k), kNowhere};
    d.in.lower(k, pick[in ? 1 : 0]);
    d.out.lower(k, pick[in ? 2 : 1]);
  }
}

/// No point is farther from the sections or the rest than this.
double reach_of(const Distances& d) {
  Pair largest = d.out[0];  // not below d.in: contour edges are in both parts
  for (std::size_t k = 1; k < kPairs; ++k) largest = largest_of(d.out[k], largest);
  return std::sqrt(std::max(largest[0], largest[1]));
}

/// (out - in) / (out + in), also where there is nothing of one or the other: a vertex is in both, so that is
/// asked of points inside the cell only.
double share_of(double in, double out, bool all_grounded) {
  if (!all_grounded && (in == kNowhere || out == kNowhere))
    return in != kNowhere ? 1 : out != kNowhere ? -1 : 0;
  return in + out > 0 ? (out - in) / (out + in) : 0;
}

/// The mean share.
std::int32_t mean_of(const Distances& d, bool all_grounded) {
  double sum = 0;
  for (std::size_t k = 0; k < kPoints; ++k) {
    const double in = std::sqrt(d.in.of(k)), out = std::sqrt(d.out.of(k));
    sum += kWeights[k] * share_of(in, out, all_grounded);
  }
  return static_cast<std::int32_t>(std::floor(sum * kCertain + 0.5));
}

}  // namespace

ConfidenceMeter::ConfidenceMeter(const CellComplex& complex, const Ground& ground, const CellShape& shape)
    : complex_(complex), shape_(shape), memory_(shape.memory != nullptr ? *shape.memory : own_) {
  if (memory_.sections.empty()) memory_.sections = section_rows(complex, ground, shape);
  double scale = 0;
  for (const Vec3& p : shape.points)
    scale = std::max(scale, std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z));
  for (const FacePlane& face : shape.faces) scale = std::max(scale, std::fabs(face.offset));
  slack_ = scale * 0x1p-44;
  has_interior_ = complex.has_interior_vertices();
}

/// Faces that come nearer to some point than `reach`, the nearest one first: it answers for most points.
/// `radius`: of the points around the centroid. A height is off by less than 8 units of 2^-53 of `scale`, far
/// less than the slack.
void ConfidenceMeter::find_near_faces(Vec3 centroid, double radius, double reach) {
  const double limit = (radius + reach) * (1 + 0x1p-40) + slack_;
  near_.clear();
  for (std::uint32_t f = 0; f < memory_.sections.size(); ++f) {
    const double height = shape_.faces[f].height(centroid);
    if (height > limit) continue;
    near_.push_back({height, f});
    for (std::size_t k = near_.size() - 1; k > 0 && near_[k].height < near_[k - 1].height; --k)
      std::swap(near_[k], near_[k - 1]);
  }
}

/// They are on the hull.
ContourEdges::ContourEdges(const CellComplex& complex, const CellShape& shape) : tree_({}) {
  std::vector<std::array<std::uint32_t, 2>> list;
  const auto list_sides = [&](std::uint32_t t, unsigned i) {
    const auto& slots = kFacetSlots[i];
    for (unsigned k = 0; k < 3; ++k) {
      const unsigned from = slots[k], to = slots[(k + 1) % 3];
      if (complex.edges[t][kEdgeCorner[from][to] - 4U] != EdgeKind::contour) continue;
      const auto [a, b] = std::minmax({complex.mesh.vertices[t][from], complex.mesh.vertices[t][to]});
      list.push_back({a, b});
    }
  };
  for (std::uint32_t t = 0; t < complex.mesh.size(); ++t)
    for (unsigned i = 0; i < 4; ++i)
      if (complex.mesh.neighbours[t][i] == kNone) list_sides(t, i);
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  std::vector<Bounds> boxes;
  for (const auto& [a, b] : list) {
    ends_.push_back({shape.points[a], shape.points[b]});
    boxes.emplace_back().add(shape.points[a]);
    boxes.back().add(shape.points[b]);
  }
  tree_ = BoxTree(boxes);
}

double ContourEdges::squared_distance(Vec3 p, double bound) const {
  return tree_.nearest(
      p, [&](std::uint32_t i) { return squared_distance_to(ends_[i], p); }, bound);
}

std::size_t KnownConfidences::place_of(const TetName& name) const {
  const std::uint64_t low = std::uint64_t{name[0]} << 32 | name[1];
  const std::uint64_t high = std::uint64_t{name[2]} << 32 | name[3];
  const std::uint64_t mixed = low * 0x9E3779B97F4A7C15 ^ high * 0xC2B2AE3D27D4EB4F;
  const std::size_t mask = entries_.size() - 1;
  std::size_t at = (mixed ^ mixed >> 32) & mask;
  while (entries_[at].name[0] != kNone && entries_[at].name != name) at = (at + 1) & mask;
  return at;
}

void KnownConfidences::grow() {
  constexpr std::size_t kFirst = 512;
  std::vector<Entry> old(std::max(kFirst, 2 * entries_.size()));
  std::swap(old, entries_);
  for (const Entry& entry : old)
    if (entry.name[0] != kNone) entries_[place_of(entry.name)] = entry;
}

/// By sorted vertices, so that rounding does not depend on their order.
Vec3 ConfidenceMeter::centroid_of(const TetName& v) const {
  const auto& at = shape_.points;
  return 0.25 * ((at[v[0]] + at[v[1]]) + (at[v[2]] + at[v[3]]));
}

std::int32_t ConfidenceMeter::measure(std::uint32_t t) {
  const TetName name = sorted_vertices(complex_.mesh, t);
  if (shape_.memory == nullptr) return measure_new(t, name);
  return memory_.known.get(name, [&] { return measure_new(t, name); });
}

std::int32_t ConfidenceMeter::measure_new(std::uint32_t t, const TetName& v) {
  const auto& at = shape_.points;
  const Vec3 centroid = centroid_of(v);
  std::array<Vec3, 4> middles;
  double farthest = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    middles[k] = 0.5 * (centroid + at[v[k]]);
    const Vec3 away = middles[k] - centroid;
    farthest = std::max(farthest, dot(away, away));
  }
  const Points p(centroid, middles);
  const bool all_grounded = !has_interior_ || !has_interior_vertex(complex_, t);
  Distances d = to_contours(complex_, shape_, t, p, all_grounded);
  if (!all_grounded) {
    if (!memory_.contours) memory_.contours.emplace(complex_, shape_);
    take_contours(*memory_.contours, p, d);
  }
  find_near_faces(centroid, std::sqrt(farthest), reach_of(d));
  for (const NearFace& near : near_) take_face(shape_.faces[near.face], memory_.sections[near.face], p, d);
  return mean_of(d, all_grounded);
}

/// No part of the boundary is nearer than the nearest face, so its side has the nearest point, and the share
/// is not below or not above 0. It is off by less than 2^-22 for all that is off in distances, where that
/// face is 2^22 slacks away.
ConfidenceBounds ConfidenceMeter::bounds(std::uint32_t t) const {
  const TetName name = sorted_vertices(complex_.mesh, t);
  if (const std::int32_t* known = memory_.known.find(name)) return {*known, *known};
  const Vec3 centroid = centroid_of(name);
  double height = kNowhere;
  std::size_t face = 0;
  for (std::size_t f = 0; f < shape_.faces.size(); ++f)
    if (const double h = shape_.faces[f].height(centroid); h < height) height = h, face = f;
  if (!(height > slack_ * 0x1p22 && height < kNowhere)) return {};
  const SectionRows& section = memory_.sections[face];
  const bool in = !section.empty() && section.contains(centroid - height * shape_.faces[face].normal);
  constexpr std::int32_t kSpare = 2;
  const std::int32_t rest = as_integer(1 - kWeights[0]) + kSpare;
  return in ? ConfidenceBounds{-rest, kCertain} : ConfidenceBounds{-kCertain, rest};
}

std::vector<std::int32_t> confidences(const CellComplex& complex, const CellShape& shape,
                                      const std::vector<std::uint8_t>& wanted) {
  ConfidenceMeter meter(complex, Ground(complex), shape);
  std::vector<std::int32_t> confidence(complex.mesh.size(), -kCertain);
  for (std::uint32_t t = 0; t < complex.mesh.size(); ++t)
    if (wanted[t] != 0) confidence[t] = meter.measure(t);
  return confidence;
}

}  // namespace crossloft
