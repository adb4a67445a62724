#pragma once
/// A plane with a normal of length 1, from a normal of any length.

#include <algorithm>
#include <cmath>

#include "vec3.h"

namespace crossloft {

/// { x : normal.x + offset = 0 }, the normal of unit length.
struct UnitPlane {
  Vec3 normal;
  double offset = 0;

  double height(Vec3 p) const { return dot(normal, p) + offset; }
};

/// Scaled by the largest component first, whose square might over- or underflow. REQUIRES: finite, not 0.
inline UnitPlane unit_plane(Vec3 normal, double offset) {
  const double largest = std::max({std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)});
  const Vec3 m{normal.x / largest, normal.y / largest, normal.z / largest};
  const double length = norm(m);
  return {{m.x / length, m.y / length, m.z / length}, offset / largest / length};
}

}  // namespace crossloft
