#include "check.h"

#include <algorithm>

#include "../geom/box_tree.h"
#include "../geom/ids.h"
#include "../geom/triangle_meeting.h"
#include "surface_topology.h"

namespace crossloft {
namespace {

constexpr std::size_t kListedPairs = 16;
/// Of six times one triangle's volume, and of one step of their sum, by the product of the three lengths that
/// it comes from.
constexpr double kTermRounding = 0x1p-50;

std::vector<Bounds> triangle_boxes(const Surface& surface, std::span<const std::uint32_t> triangles) {
  std::vector<Bounds> boxes;
  boxes.reserve(triangles.size());
  for (const std::uint32_t t : triangles) boxes.push_back(bounds_of(corners(surface, t)));
  return boxes;
}

/// Geometric judgements; everything here reads coordinates and trusts indices.
class Geometry {
 public:
  Geometry(const Surface& surface, const SurfaceTopology& topology, CheckReport& report)
      : surface_(surface),
        topology_(topology),
        report_(report),
        box_(bounds_of(surface.points)),
        tree_(triangle_boxes(surface, topology.triangles)) {}

  void run() {
    measure();
    find_largest();
    count_degenerate();
    count_meetings();
    nest_components();
  }

 private:
  Corners corners_of(std::uint32_t listed) const { return corners(surface_, topology_.triangles[listed]); }

  double area_of(std::uint32_t listed) const {
    const Corners t = corners_of(listed);
    return 0.5 * norm(cross(t[1] - t[0], t[2] - t[0]));
  }

  /// Volumes relative to a corner of the component: further away the terms would cancel.
  void measure() {
    for (std::uint32_t i = 0; i < topology_.triangles.size(); ++i) {
      ComponentReport& c = report_.components[topology_.component[i]];
      const Vec3 base = corners(surface_, c.first_triangle)[0];
      const Corners t = corners_of(i);
      const Vec3 p = t[0] - base, e = t[1] - t[0], f = t[2] - t[0];
      c.volume += dot(p, cross(e, f));
      c.volume_rounding += kTermRounding * norm(p) * norm(e) * norm(f);
      report_.area += area_of(i);
    }
    for (ComponentReport& c : report_.components) {
      c.volume /= 6;
      c.volume_rounding *= c.triangles / 6.0;
      report_.volume += c.volume;
    }
  }

  void find_largest() {
    largest_.resize(report_.components.size(), kNone);
    for (std::uint32_t i = 0; i < topology_.triangles.size(); ++i) {
      std::uint32_t& largest = largest_[topology_.component[i]];
      if (largest == kNone || area_of(i) > area_of(largest)) largest = i;
    }
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
      for (std::uint32_t c = 0; c < report_.components.size(); ++c) report_.components[c].depth = depth_of(c);
    for (const ComponentReport& c : report_.components) {
      report_.cavities += c.cavity();
      report_.inverted += c.inverted();
    }
  }

  /// Number of other components that a ray from this one leaves an odd number of times. Rays that touch an
  /// edge or vertex say nothing exact; then another direction is tried. They start from the largest triangle:
  /// within a needle rounding might bring the start through a neighbour.
  std::uint32_t depth_of(std::uint32_t component) const {
    const Corners t = corners_of(largest_[component]);
    const Vec3 from = (1.0 / 3) * (t[0] + t[1] + t[2]);
    std::vector<std::uint32_t> left;
    for (int attempt = 0; attempt < 16; ++attempt)
      if (components_left(from, far_point(from, attempt), component, left)) break;
    std::sort(left.begin(), left.end());
    return odd_runs(left);
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
  std::vector<std::uint32_t> largest_;  // by component: the triangle of the largest area, as listed
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
