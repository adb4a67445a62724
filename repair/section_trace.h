#pragma once
/// A section seen from a line in its plane: where the line is inside, and how far the contour is.

#include <cstdint>
#include <memory>
#include <vector>

#include "../arrangement/sections.h"
#include "../geom/box_tree.h"
#include "common_lines.h"
#include "planar_lattice.h"

namespace crossloft {

/// Where a contour runs along the line, inside and outside are as good as each other.
enum class Inside : std::uint8_t { no, yes, either };

/// The line cut at the contour.
struct Trace {
  std::vector<double> cuts;    ///< ascending
  std::vector<Inside> states;  ///< [0] before the first cut, [k] between cuts k - 1 and k

  Inside between(double t0, double t1) const;  ///< of an interval that holds no cut
};

/// The boundary of a section for questions of distance.
class SectionBoundary {
 public:
  SectionBoundary(const PlaneSection& section, const UnitPlane& plane, const PlaneChart& chart);

  bool empty() const { return walls_.empty(); }
  const UnitPlane& plane() const { return plane_; }

  /// Contour vertices within `on` of the line are on it, and cut it where they are. O(n).
  Trace trace(const CommonLine& line, double on) const;
  /// Distance of a point of the plane from the contour, infinite without any. O(log n) if it is near.
  double distance(Vec3 p) const;
  /// True iff the section holds the point, exact on the grid of the chart. O(n).
  bool inside(Vec3 p) const;
  /// Below 0 inside. Without a contour it is infinite.
  double signed_distance(Vec3 p) const { return inside(p) ? -distance(p) : distance(p); }
  /// The largest distance of one of its vertices from the other contour; infinite if that is empty and this
  /// is not. O(n log m).
  double largest_distance_from(const SectionBoundary& other, Vec3* where = nullptr) const;
  /// The point of the contour nearest to p and its contour. REQUIRES: not empty. O(n).
  Vec3 nearest(Vec3 p, std::uint32_t& contour) const;

 private:
  struct WallSegment {
    Vec3 a, b;
    PlanarPoint ga, gb;
    std::uint32_t contour = 0;
  };

  UnitPlane plane_;
  PlaneChart chart_;
  std::vector<WallSegment> walls_;
  std::unique_ptr<BoxTree> tree_;
};

/// Of a vertex of one contour from the other, both ways; 0 if one is empty.
double largest_distance(const SectionBoundary& a, const SectionBoundary& b, Vec3* where = nullptr);

}  // namespace crossloft
