#pragma once
/// Integer coordinates in one plane, and the exact tests that repairs decide by.
///
/// A chart puts a square grid on a plane: |x|, |y| <= 2^28 for points within one diagonal of the middle of
/// the data, so that a step is 2^-28 of the diagonal and orientations of doubled coordinates fit 64 bits.

#include <compare>
#include <cstdint>

#include "../geom/vec3.h"

namespace crossloft {

struct PlanarPoint {
  std::int64_t x = 0, y = 0;
  friend constexpr auto operator<=>(const PlanarPoint&, const PlanarPoint&) = default;
};

inline constexpr std::int64_t kPlanarLimit = std::int64_t{1} << 28;

/// The grid on the plane { x : normal.x + offset = 0 }. It depends on the plane as a set of points and on the
/// data's middle and diagonal alone.
class PlaneChart {
 public:
  /// REQUIRES: a unit normal, a diagonal above 0.
  PlaneChart(Vec3 normal, double offset, Vec3 middle, double diagonal);

  /// The grid point nearest to the foot of p; beyond the grid the nearest on its border.
  PlanarPoint to_grid(Vec3 p) const;
  Vec3 to_space(PlanarPoint p) const;
  /// Input units of a step.
  double step() const { return step_; }

 private:
  Vec3 origin_, u_, v_;
  double step_ = 1;
};

/// Twice the signed area of a, b, c, exact: above 0 if they turn left. REQUIRES: coordinates within twice the
/// limit.
constexpr std::int64_t turn(PlanarPoint a, PlanarPoint b, PlanarPoint c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// True iff the open segments have exactly one common point.
bool cross(PlanarPoint a, PlanarPoint b, PlanarPoint c, PlanarPoint d);

/// True iff the segment ab meets the unit square around h, which has its left and lower side and not the
/// others: the points that are rounded to h.
bool passes(PlanarPoint a, PlanarPoint b, PlanarPoint h);

/// True iff the ray upwards from a point in doubled coordinates meets the segment ab, its lower end in x
/// included: an odd number of the walls of a section does if the point is inside.
bool is_above(PlanarPoint a, PlanarPoint b, PlanarPoint doubled);

/// The grid point nearest to the crossing of ab and cd, exactly rounded, half way upwards.
/// REQUIRES: cross(a, b, c, d).
PlanarPoint crossing_point(PlanarPoint a, PlanarPoint b, PlanarPoint c, PlanarPoint d);

}  // namespace crossloft
