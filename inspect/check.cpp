#include "check.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "../geom/box_tree.h"
#include "../geom/ids.h"
#include "../geom/triangle_meeting.h"
#include "surface_topology.h"
#include "unit_scale.h"

namespace crossloft {
namespace {

constexpr std::size_t kListedPairs = 16;
/// Of six times one triangle's volume, and of one step of their sum, by the product of the three lengths that
/// it comes from.
constexpr double kTermRounding = 0x1p-50;
/// Rays that ask for a component's depth start from so many triangles, from each of them at so many points.
constexpr std::size_t kRayTriangles = 4;
constexpr int kRaysPerTriangle = 8;
/// Of the start of such a ray, by the largest coordinate that it comes from: at most eight roundings of
/// 2^-53, doubled.
constexpr double kStartRounding = 0x1p-49;

std::vector<Bounds> triangle_boxes(const Surface& surface, std::span<const std::uint32_t> triangles) {
  std::vector<Bounds> boxes;
  boxes.reserve(triangles.size());
  for (const std::uint32_t t : triangles) boxes.push_back(bounds_of(corners(surface, t)));
  return boxes;
}

/// The triangles of largest area in a component, as listed, the largest first; of equal ones the first.
class LargestTriangles {
 public:
  void offer(double area, std::uint32_t triangle) {
    for (std::size_t k = 0; k < kRayTriangles && triangle != kNone; ++k) {
      if (triangles_[k] != kNone && area <= areas_[k]) continue;
      std::swap(area, areas_[k]);
      std::swap(triangle, triangles_[k]);
    }
  }
  std::span<const std::uint32_t> list() const {
    const auto end = std::find(triangles_.begin(), triangles_.end(), kNone);
    return {triangles_.data(), static_cast<std::size_t>(end - triangles_.begin())};
  }

 private:
  std::array<double, kRayTriangles> areas_{};
  std::array<std::uint32_t, kRayTriangles> triangles_{kNone, kNone, kNone, kNone};
};

/// Geometric judgements; everything here reads coordinates and trusts indices.
class Geometry {
 public:
  Geometry(const Surface& surface, const SurfaceTopology& topology, CheckReport& report)
      : surface_(surface),
        topology_(topology),
        report_(report),
        box_(bounds_of_triangles(surface)),
        tree_(triangle_boxes(surface, topology.triangles)) {}

  void run() {
    measure();
    count_degenerate();
    count_meetings();
    nest_components();
  }

 private:
  Corners corners_of(std::uint32_t listed) const { return corners(surface_, topology_.triangles[listed]); }

  /// Each component by its own scale: the sign of a small one's volume must not get lost beside a large one.
  std::vector<UnitScale> scales() const {
    std::vector<Bounds> boxes(report_.components.size());
    for (std::uint32_t i = 0; i < topology_.triangles.size(); ++i)
      boxes[topology_.component[i]].join(bounds_of(corners_of(i)));
    return {boxes.begin(), boxes.end()};
  }

  /// Volumes relative to a corner of the component: further away the terms would cancel.
  void measure() {
    const std::vector<UnitScale> scale = scales();
    largest_.resize(report_.components.size());
    for (std::uint32_t i = 0; i < topology_.triangles.size(); ++i) {
      const std::uint32_t component = topology_.component[i];
      ComponentReport& c = report_.components[component];
      const auto at_unit = [&unit = scale[component]](const Vec3& v) { return unit.to_unit(v); };
      const Vec3 base = at_unit(corners(surface_, c.first_triangle)[0]);
      const Corners t = corners_of(i);
      const Vec3 p = at_unit(t[0]), e = at_unit(t[1]) - p, f = at_unit(t[2]) - p, from_base = p - base;
      c.volume += dot(from_base, cross(e, f));
      c.volume_rounding += kTermRounding * norm(from_base) * norm(e) * norm(f);
      const double area = 0.5 * norm(cross(e, f));
      largest_[component].offer(area, i);
      report_.area += scale[component].area(area);
    }
    for (std::size_t k = 0; k < largest_.size(); ++k) finish_volume(report_.components[k], scale[k]);
  }

  void finish_volume(ComponentReport& c, const UnitScale& scale) {
    c.volume /= 6;
    c.volume_rounding *= c.triangles / 6.0;
    c.volume_sign_known = c.volume > c.volume_rounding || c.volume < -c.volume_rounding;
    c.volume = scale.volume(c.volume);
    c.volume_rounding = scale.volume(c.volume_rounding);
    report_.volume += c.volume;
  }

  void count_degenerate() {
    for (std::uint32_t i = 0; i < topology_.triangles.size(); ++i) {
      const Corners t = corners_of(i);
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
        ++report_.repeated_points;
      else if (collinear(t))
        ++report_.flat_triangles;
    }
  }

  void count_meetings() {
    tree_.for_pairs([this](std::uint32_t i, std::uint32_t j) {
      const Meeting m = meeting(corners_of(i), corners_of(j));
      report_.overlaps += m == Meeting::overlap;
      if (m != Meeting::crossing) return;
      ++report_.crossings;
      list_pair(topology_.triangles[std::min(i, j)], topology_.triangles[std::max(i, j)]);
    });
  }

  /// Keeps the smallest pairs, whatever the order in which the tree finds them.
  void list_pair(std::uint32_t a, std::uint32_t b) {
    auto& pairs = report_.crossing_pairs;
    const std::array<std::uint32_t, 2> pair{a, b};
    pairs.insert(std::upper_bound(pairs.begin(), pairs.end(), pair), pair);
    if (pairs.size() > kListedPairs) pairs.pop_back();
  }

  void nest_components() {
    const bool all_closed = std::all_of(report_.components.begin(), report_.components.end(),
                                        [](const ComponentReport& c) { return c.manifold; });
    if (!all_closed) return;
    if (report_.components.size() > 1)
      for (std::uint32_t c = 0; c < report_.components.size(); ++c) find_depth(c);
    for (const ComponentReport& c : report_.components) {
      report_.cavities += c.cavity();
      report_.inverted += c.inverted();
      report_.unknown_depths += !c.depth_known;
    }
  }

  /// Number of other components that a ray from this one leaves an odd number of times. Rays that touch an
  /// edge or vertex, or start where another component is, say nothing exact; then another point and direction
  /// is tried. The largest triangles come first: around them is most room.
  void find_depth(std::uint32_t component) {
    std::vector<std::uint32_t> left;
    int attempt = 0;
    for (const std::uint32_t triangle : largest_[component].list())
      for (int k = 0; k < kRaysPerTriangle; ++k, ++attempt) {
        const Corners t = corners_of(triangle);
        const Vec3 from = inner_point(t, k);
        if (meets_others(box_of_start(from, t), component)) continue;
        if (!components_left(from, far_point(from, attempt), component, left)) continue;
        std::sort(left.begin(), left.end());
        report_.components[component].depth = odd_runs(left);
        return;
      }
    report_.components[component].depth_known = false;
  }

  /// The centroid, then points around it after the additive recurrence of the plastic number (Roberts 2018).
  static Vec3 inner_point(const Corners& t, int k) {
    const Vec3 centroid = (1.0 / 3) * (t[0] + t[1] + t[2]);
    if (k == 0) return centroid;
    double u = k * 0.75487766624669276, v = k * 0.56984029099805327;
    u -= std::floor(u), v -= std::floor(v);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    return 0.5 * centroid + 0.5 * (t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]));
  }

  /// Around an inner point as it was rounded, so large that the exact one is in it.
  static Bounds box_of_start(const Vec3& from, const Corners& t) {
    const auto rounding = [](double a, double b, double c) {
      return kStartRounding * std::max({std::abs(a), std::abs(b), std::abs(c)}) + 0x1p-1070;
    };
    const Vec3 margin{rounding(t[0].x, t[1].x, t[2].x), rounding(t[0].y, t[1].y, t[2].y),
                      rounding(t[0].z, t[1].z, t[2].z)};
    return {from - margin, from + margin};
  }

  /// False only if no triangle of another component meets the box.
  bool meets_others(const Bounds& box, std::uint32_t self) const {
    bool meets = false;
    tree_.for_overlaps(box, [&](std::uint32_t i) {
      meets = meets || (topology_.component[i] != self && !beside(corners_of(i), box));
    });
    return meets;
  }

  /// The box is strictly on one side of the triangle's plane.
  static bool beside(const Corners& triangle, const Bounds& box) {
    const int side = side_of(triangle, box.low);
    if (side == 0) return false;
    for (unsigned k = 1; k < 8; ++k) {
      const Vec3 corner{k & 1 ? box.high.x : box.low.x, k & 2 ? box.high.y : box.low.y,
                        k & 4 ? box.high.z : box.low.z};
      if (side_of(triangle, corner) != side) return false;
    }
    return true;
  }

  Vec3 far_point(const Vec3& from, int attempt) const {
    const double d = box_.diagonal();
    return {box_.high.x + d, from.y + 0.013 * attempt * d, from.z + 0.007 * attempt * d};
  }

  /// The component of every triangle that the segment passes; false if it touches one.
  bool components_left(const Vec3& from, const Vec3& to, std::uint32_t self,
                       std::vector<std::uint32_t>& left) const {
    bool clean = true;
    left.clear();
    const std::array<Vec3, 2> ends{from, to};
    tree_.for_overlaps(bounds_of(ends), [&](std::uint32_t i) {
      if (topology_.component[i] == self) return;
      const Piercing p = piercing(from, to, corners_of(i));
      if (p == Piercing::touches) clean = false;
      if (p == Piercing::pierces) left.push_back(topology_.component[i]);
    });
    return clean;
  }

  static std::uint32_t odd_runs(const std::vector<std::uint32_t>& sorted) {
    std::uint32_t count = 0;
    for (std::size_t i = 0, j = 0; i < sorted.size(); i = j) {
      while (j < sorted.size() && sorted[j] == sorted[i]) ++j;
      count += (j - i) % 2;
    }
    return count;
  }

  const Surface& surface_;
  const SurfaceTopology& topology_;
  CheckReport& report_;
  Bounds box_;
  BoxTree tree_;
  std::vector<LargestTriangles> largest_;  // by component
};

}  // namespace

CheckReport check_surface(const Surface& surface) {
  CheckReport report;
  const SurfaceTopology topology = check_topology(surface, report);
  for (const Vec3& p : surface.points) report.bad_coordinates += !is_finite(p);
  if (report.bad_coordinates == 0) Geometry(surface, topology, report).run();
  return report;
}

}  // namespace crossloft
