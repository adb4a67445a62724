#include "slice.h"
#include "../geom/failing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "contour_tracing.h"
#include "unit_scale.h"

namespace crossloft {
namespace {

constexpr std::uint32_t next(std::uint32_t k) { return k == 2 ? 0 : k + 1; }

/// 0 counts as above.
bool above(double height) { return height >= 0; }

/// Point at which the height is 0 between heights hp and hq of different side.
Vec3 zero_point(const Vec3& p, double hp, const Vec3& q, double hq) {
  if (hp == 0) return p;
  if (hq == 0) return q;
  return p + hp / (hp - hq) * (q - p);
}

/// REQUIRES: unit vectors.
bool parallel(const Vec3& a, const Vec3& b) { return norm(cross(a, b)) <= 1e-12; }

Error error(ErrorCode code, const char* message, std::uint32_t plane = kNone) {
  Error e;
  e.code = code;
  e.message = message;
  e.plane = plane;
  return e;
}

Result<Done> validate(const Surface& mesh, std::span<const CuttingPlane> planes) {
  if (mesh.triangles.empty()) return error(ErrorCode::not_closed, "the mesh has no triangle to be cut");
  if (planes.empty()) return error(ErrorCode::no_plane, "no cutting plane given");
  for (const Vec3& p : mesh.points)
    if (!is_finite(p)) return error(ErrorCode::not_finite, "a point of the mesh is not finite");
  for (const auto& t : mesh.triangles)
    if (std::max({t[0], t[1], t[2]}) >= mesh.points.size())
      return error(ErrorCode::index_out_of_range, "a triangle of the mesh names a point that is not there");
  for (std::uint32_t i = 0; i < planes.size(); ++i) {
    const auto& [n, offset] = planes[i];
    if (!is_finite(n) || !std::isfinite(offset))
      return error(ErrorCode::not_finite, "the plane is not finite", i);
    if (n == Vec3{}) return error(ErrorCode::zero_normal, "the plane's normal is zero", i);
  }
  return Done{};
}

/// A mesh edge cut by a plane.
struct EdgeCut {
  std::uint32_t edge = 0, plane = 0;
  double place = 0;  // 0 at the edge's lower vertex, 1 at the other
  Vec3 point;
};

/// A triangle cut by a plane: a chord from side `enter` to side `leave` of the triangle.
struct Chord {
  std::uint32_t triangle = 0, plane = 0;
  std::uint32_t enter = 0, leave = 0;
  Vec3 p, q;                // on enter and leave
  std::vector<Vec3> inner;  // where other planes cross it
};

/// Crossings of chords in one triangle, in the order of their finding.
class KnownPoints {
 public:
  explicit KnownPoints(double close) : close_(close) {}

  /// The first known point this near, or the point itself, which then is known.
  Vec3 known_or_new(const Vec3& point) {
    const double place = dot(kAlong, point);
    std::uint32_t first = kNone;
    const auto end = by_place_.upper_bound(place + 2 * close_);  // twice, to be sure in spite of rounding
    for (auto near = by_place_.lower_bound(place - 2 * close_); near != end; ++near)
      if (near->second < first && norm(points_[near->second] - point) <= close_) first = near->second;
    if (first != kNone) return points_[first];
    by_place_.emplace(place, static_cast<std::uint32_t>(points_.size()));
    points_.push_back(point);
    return point;
  }

 private:
  /// Of length 1, and across no face that meshes often have: of that all points would be in one place.
  static constexpr Vec3 kAlong{0.6, 0.48, 0.64};

  double close_;
  std::vector<Vec3> points_;
  std::multimap<double, std::uint32_t> by_place_;
};

/// The steps, in the order of run(). All that is decided on a mesh edge is decided from the heights of its
/// two ends in one way, so the triangles on both its sides and all planes agree. All at size 1, from the
/// mesh's points and planes up to the segments that are traced.
class Slicer {
 public:
  Slicer(const Surface& mesh, std::span<const CuttingPlane> planes)
      : given_(planes),
        scale_(bounds_of_triangles(mesh)),
        mesh_(scale_.to_unit(mesh)),
        close_(1e-13 * bounds_of_triangles(mesh_).diagonal()) {}

  Result<Sections> run() {
    for (const CuttingPlane& plane : given_) planes_.push_back(scale_.to_unit(plane.normal, plane.offset));
    number_directions();
    number_edges();
    if (!closed_) return error(ErrorCode::not_closed, "the mesh is not closed, so it bounds no solid");
    cut_edges();
    merge_close_cuts();
    cut_triangles();
    cross_chords();
    return trace();
  }

 private:
  /// Equal ones for planes of the same or the opposite normal, which have no line.
  void number_directions() {
    const auto upward = [](const Vec3& n) { return n < -n ? -n : n; };
    std::vector<Vec3> directions;
    for (const UnitPlane& plane : planes_) directions.push_back(upward(plane.normal));
    std::sort(directions.begin(), directions.end());
    for (const UnitPlane& plane : planes_) {
      const auto first = std::lower_bound(directions.begin(), directions.end(), upward(plane.normal));
      direction_.push_back(static_cast<std::uint32_t>(first - directions.begin()));
    }
  }

  /// Edge numbers of all triangle sides, and whether every edge has an even number of triangles.
  void number_edges() {
    struct Side {
      std::uint32_t low, high, place;
    };
    std::vector<Side> sides;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t a = mesh_.triangles[t][k], b = mesh_.triangles[t][next(k)];
        sides.push_back({std::min(a, b), std::max(a, b), 3 * t + k});
      }
    std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
      return std::tie(x.low, x.high, x.place) < std::tie(y.low, y.high, y.place);
    });
    edge_of_side_.resize(sides.size());
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const bool same = i > 0 && sides[i].low == sides[i - 1].low && sides[i].high == sides[i - 1].high;
      if (!same) {
        closed_ = closed_ && count % 2 == 0;
        count = 0;
        edges_.push_back({sides[i].low, sides[i].high});
      }
      count += sides[i].low != sides[i].high;  // a side from a vertex to itself bounds nothing
      edge_of_side_[sides[i].place] = static_cast<std::uint32_t>(edges_.size() - 1);
    }
    closed_ = closed_ && count % 2 == 0;
  }

  /// Over the plane; 0 if close to it or within the rounding error (three products, three sums: 4 * 2^-53 of
  /// the sum of magnitudes, doubled). So a vertex that is meant to lie on the plane does.
  double height(std::uint32_t plane, const Vec3& p) const {
    const auto& [n, offset] = planes_[plane];
    const double x = n.x * p.x, y = n.y * p.y, z = n.z * p.z, value = x + y + z + offset;
    const double rounding = 0x1p-50 * (std::abs(x) + std::abs(y) + std::abs(z) + std::abs(offset));
    return std::abs(value) <= close_ + rounding ? 0 : value;
  }
  double height_of(std::uint32_t plane, std::uint32_t vertex) const {
    return height(plane, mesh_.points[vertex]);
  }

  void cut_edges() {
    std::vector<double> h(mesh_.points.size());
    for (std::uint32_t i = 0; i < planes_.size(); ++i) {
      for (std::uint32_t v = 0; v < h.size(); ++v) h[v] = height_of(i, v);
      for (std::uint32_t e = 0; e < edges_.size(); ++e) {
        const auto [a, b] = edges_[e];
        if (above(h[a]) == above(h[b])) continue;
        const Vec3 point = zero_point(mesh_.points[a], h[a], mesh_.points[b], h[b]);
        cuts_.push_back({e, i, h[a] / (h[a] - h[b]), point});
      }
    }
  }

  /// Where planes meet an edge in one point up to rounding, all take the point of the first of them: twins a
  /// hair apart would be two vertices of the reconstruction.
  void merge_close_cuts() {
    std::sort(cuts_.begin(), cuts_.end(), [](const EdgeCut& a, const EdgeCut& b) {
      return std::tie(a.edge, a.place, a.plane) < std::tie(b.edge, b.place, b.plane);
    });
    for (std::size_t i = 1; i < cuts_.size(); ++i) {
      const auto [a, b] = edges_[cuts_[i].edge];
      const double length = norm(mesh_.points[b] - mesh_.points[a]);
      if (cuts_[i].edge == cuts_[i - 1].edge && (cuts_[i].place - cuts_[i - 1].place) * length <= close_)
        cuts_[i].point = cuts_[i - 1].point;
    }
    std::sort(cuts_.begin(), cuts_.end(), [](const EdgeCut& a, const EdgeCut& b) {
      return std::tie(a.edge, a.plane) < std::tie(b.edge, b.plane);
    });
    first_cut_.assign(edges_.size() + 1, 0);
    for (const EdgeCut& c : cuts_) ++first_cut_[c.edge + 1];
    for (std::size_t e = 0; e < edges_.size(); ++e) first_cut_[e + 1] += first_cut_[e];
  }

  std::span<const EdgeCut> cuts_of_side(std::uint32_t triangle, std::uint32_t side) const {
    const std::uint32_t e = edge_of_side_[3 * triangle + side];
    return {cuts_.data() + first_cut_[e], first_cut_[e + 1] - first_cut_[e]};
  }

  /// The chords of each triangle, by plane. A plane cuts none or two sides.
  void cut_triangles() {
    chord_of_plane_.assign(planes_.size(), kNoChord);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      const std::size_t begin = chords_.size();
      for (std::uint32_t k = 0; k < 3; ++k)
        for (const EdgeCut& cut : cuts_of_side(t, k)) add_cut(t, k, cut, begin);
      std::sort(chords_.begin() + static_cast<std::ptrdiff_t>(begin), chords_.end(),
                [](const Chord& a, const Chord& b) { return a.plane < b.plane; });
    }
  }

  void add_cut(std::uint32_t triangle, std::uint32_t side, const EdgeCut& cut, std::size_t begin) {
    const std::size_t known = chord_of_plane_[cut.plane];
    if (known == kNoChord || known < begin) {  // none yet but of earlier triangles
      chord_of_plane_[cut.plane] = chords_.size();
      chords_.push_back({triangle, cut.plane, side, 0, cut.point, {}, {}});
    } else {
      chords_[known].leave = side;
      chords_[known].q = cut.point;
    }
  }

  void cross_chords() {
    for (std::size_t begin = 0, end = 0; begin < chords_.size(); begin = end) {
      while (end < chords_.size() && chords_[end].triangle == chords_[begin].triangle) ++end;
      cross_chords_of_triangle({&chords_[begin], end - begin});
    }
  }

  /// Planes of a pencil cross in one point up to rounding: all take the point of the first two.
  void cross_chords_of_triangle(std::span<Chord> chords) const {
    KnownPoints points(close_);
    const std::vector<std::size_t> run_end = ends_of_runs(chords);
    for (std::size_t i = 0; i < chords.size(); ++i)
      for (std::size_t j = i + 1; j < chords.size(); ++j) {
        if (direction_[chords[i].plane] == direction_[chords[j].plane]) {
          j = run_end[j] - 1;
          continue;
        }
        if (parallel(planes_[chords[i].plane].normal, planes_[chords[j].plane].normal)) continue;
        if (!interleave(chords[i], chords[j])) continue;
        const Vec3 point = points.known_or_new(crossing_point(chords[i], chords[j]));
        chords[i].inner.push_back(point);
        chords[j].inner.push_back(point);
      }
  }

  /// Per chord the first one after it of a plane in another direction: a stack of parallel planes is passed
  /// by at once.
  std::vector<std::size_t> ends_of_runs(std::span<const Chord> chords) const {
    std::vector<std::size_t> ends(chords.size());
    for (std::size_t i = chords.size(); i-- > 0;) {
      const bool goes_on =
          i + 1 < chords.size() && direction_[chords[i].plane] == direction_[chords[i + 1].plane];
      ends[i] = goes_on ? ends[i + 1] : i + 1;
    }
    return ends;
  }

  /// Two chords of a triangle cross iff their four ends alternate around it. Two of three sides each: they
  /// share one side or both.
  bool interleave(const Chord& i, const Chord& j) const {
    if (i.enter == j.enter && i.leave == j.leave) return before(i, j, i.enter) == before(i, j, i.leave);
    const std::uint32_t common = i.enter == j.enter || i.enter == j.leave ? i.enter : i.leave;
    const std::uint32_t other = i.enter == common ? i.leave : i.enter;
    return before(i, j, common) == (other == next(common));
  }

  /// Whether plane i meets the side before plane j does, from its first vertex on. The places are compared
  /// as a / (a + b) with c / (c + d); the same product difference decides for both planes and both triangles
  /// of the edge, and a tie goes to the lower plane in the direction of the edge.
  bool before(const Chord& i, const Chord& j, std::uint32_t side) const {
    const auto& t = mesh_.triangles[i.triangle];
    const std::uint32_t u = t[side], v = t[next(side)];
    const double a = std::abs(height_of(i.plane, u)), b = std::abs(height_of(i.plane, v));
    const double c = std::abs(height_of(j.plane, u)), d = std::abs(height_of(j.plane, v));
    const double difference = a * d - c * b;
    return difference != 0 ? difference < 0 : (u < v) == (i.plane < j.plane);
  }

  /// REQUIRES: i.plane < j.plane, so that the point is computed once and in one way.
  Vec3 crossing_point(const Chord& i, const Chord& j) const {
    for (const Vec3& p : {i.p, i.q})
      if (p == j.p || p == j.q) return p;
    for (const Vec3& p : {j.p, j.q})
      if (height(i.plane, p) == 0) return p;
    const double hp = height(j.plane, i.p), hq = height(j.plane, i.q);
    if (above(hp) != above(hq)) return zero_point(i.p, hp, i.q, hq);
    return std::abs(hp) <= std::abs(hq) ? i.p : i.q;  // they differ by rounding only
  }

  Sections trace() {
    std::vector<std::vector<std::array<Vec3, 2>>> segments(planes_.size());
    for (Chord& c : chords_) append_pieces(c, segments[c.plane]);
    Sections sections;
    sections.planes.resize(planes_.size());
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      sections.planes[i].normal = given_[i].normal;
      sections.planes[i].offset = given_[i].offset;
      trace_contours(segments[i], sections.planes[i]);
    }
    return sections;
  }

  void append_pieces(Chord& c, std::vector<std::array<Vec3, 2>>& segments) const {
    const Vec3 direction = c.q - c.p;
    std::sort(c.inner.begin(), c.inner.end(), [&](const Vec3& a, const Vec3& b) {
      const double x = dot(a - c.p, direction), y = dot(b - c.p, direction);
      return x != y ? x < y : a < b;
    });
    c.inner.push_back(c.q);
    Vec3 from = scale_.point(c.p);
    for (const Vec3& inner : c.inner) {
      const Vec3 to = scale_.point(inner);
      segments.push_back({from, to});
      from = to;
    }
  }

  std::span<const CuttingPlane> given_;
  UnitScale scale_;
  Surface mesh_;
  std::vector<UnitPlane> planes_;                    // those given, with unit normals
  std::vector<std::uint32_t> direction_;             // of the planes
  double close_;                                     // points this near are one point up to rounding
  std::vector<std::array<std::uint32_t, 2>> edges_;  // lower vertex first
  std::vector<std::uint32_t> edge_of_side_;          // of side k of triangle t at 3 t + k
  bool closed_ = true;
  static constexpr std::size_t kNoChord = ~std::size_t{0};
  std::vector<std::size_t> chord_of_plane_;  // while cutting, the last one of each plane
  std::vector<EdgeCut> cuts_;           // by edge, then plane
  std::vector<std::size_t> first_cut_;  // per edge
  std::vector<Chord> chords_;           // by triangle, then plane
};

}  // namespace

Result<Sections> slice(const Surface& closed_mesh, std::span<const CuttingPlane> planes) {
  return or_out_of_memory([&]() -> Result<Sections> {
    Result<Done> valid = validate(closed_mesh, planes);
    if (!valid) return valid.error();
    return Slicer(closed_mesh, planes).run();
  });
}

}  // namespace crossloft
