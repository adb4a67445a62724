#pragma once
/// How two triangles meet, decided exactly on their double coordinates.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "vec3.h"

namespace crossloft {

using Corners = std::array<Vec3, 3>;

enum class Meeting : std::uint8_t {
  none,      ///< apart or touching
  crossing,  ///< in two planes, with common interior points; or an edge of one that is degenerate passes
             ///< transversally through the interior of the other
  overlap,   ///< in one plane, with common interior points
};

/// How a segment meets a triangle.
enum class Piercing : std::uint8_t {
  misses,
  pierces,  ///< ends strictly on both sides, through the interior
  touches,  ///< anything else that has a common point, or both in one plane
};

/// Of three points, on which side of a triangle's plane: side_of(t, p) is orient3d(t[0], t[1], t[2], p).
using Sides = std::array<int, 3>;
int side_of(const Corners& triangle, const Vec3& p);
/// False if the triangle of these corners can't cross or overlap the one whose plane it is.
bool may_meet(const Sides& sides);
/// As below, for who knows the sides of a's corners of b's plane, and of b's of a's.
Meeting meeting(const Corners& a, const Sides& a_side, const Corners& b, const Sides& b_side);

/// Symmetric. Degenerate triangles have no interior: they can pierce and can't be pierced.
Meeting meeting(const Corners& a, const Corners& b);
Piercing piercing(const Vec3& p, const Vec3& q, const Corners& triangle);
/// Whether the closed triangles have common points beside the corners that they share, which stand first in
/// both and in the same order, and the edge between two of these. `shared` is 0, 1 or 2; other corners with
/// equal coordinates are common points like any. With a degenerate triangle the answer may be true where they
/// are apart.
bool touch(const Corners& a, const Corners& b, int shared);
/// All points but those that are corners of the triangle are strictly on one side of its plane, and there are
/// some. The triangle then has nothing in common with their convex hull but corners, and edges between these.
/// side(i) is side_of(triangle, points[i]), for who keeps what has been asked.
template <class Side>
bool beside(const Corners& triangle, std::span<const Vec3> points, Side&& side) {
  int sign = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& p = points[i];
    if (p == triangle[0] || p == triangle[1] || p == triangle[2]) continue;
    const int s = side(i);
    if (s == 0 || s * sign < 0) return false;
    sign = s;
  }
  return sign != 0;
}
/// All corners exactly on one line.
bool collinear(const Corners& triangle);
/// p is on the closed triangle. A degenerate one contains its corners only.
bool contains(const Corners& triangle, const Vec3& p);

}  // namespace crossloft
