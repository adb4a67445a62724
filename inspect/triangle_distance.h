#pragma once
/// Distances from points to segments and triangles, of sizes up to about 1: the formulas are of degree 6 in
/// the size.

#include <algorithm>

#include "../geom/triangle_meeting.h"

namespace crossloft {

inline double squared_distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  const double length2 = dot(d, d);
  const double t = length2 > 0 ? std::clamp(dot(p - a, d) / length2, 0.0, 1.0) : 0.0;
  const Vec3 gap = p - (a + t * d);
  return dot(gap, gap);
}

/// The foot of the perpendicular if it is inside, else the nearest side. Degenerate triangles are their
/// sides, and so are those whose squared area is so small that its products would underflow.
inline double squared_distance(const Vec3& p, const Corners& t) {
  const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
  bool over = dot(n, n) >= 0x1p-500;
  for (int k = 0; k < 3 && over; ++k) {
    const Vec3 &a = t[k], &b = t[k == 2 ? 0 : k + 1];
    over = dot(cross(b - a, p - a), n) >= 0;
  }
  if (over) {
    const double height = dot(p - t[0], n);
    return height * height / dot(n, n);
  }
  return std::min(
      {squared_distance(p, t[0], t[1]), squared_distance(p, t[1], t[2]), squared_distance(p, t[2], t[0])});
}

}  // namespace crossloft
