#pragma once
/// Points and segments in space.

#include "../geom/vec3.h"

namespace crossloft {

/// The point of the segment ab nearest to p.
inline Vec3 nearest_on_segment(Vec3 a, Vec3 b, Vec3 p) {
  const Vec3 d = b - a;
  const double along = dot(p - a, d), length2 = dot(d, d);
  return along <= 0 || length2 == 0 ? a : along >= length2 ? b : a + (along / length2) * d;
}

inline double distance_to_segment(Vec3 a, Vec3 b, Vec3 p) { return norm(nearest_on_segment(a, b, p) - p); }

}  // namespace crossloft
