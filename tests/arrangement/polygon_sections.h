#pragma once
/// Sections of regular polygons on planes, for the tests of what precedes the arrangement.

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "../../arrangement/sections.h"

namespace crossloft::test {

inline Vec3 unit(Vec3 v) { return (1 / norm(v)) * v; }

/// -1..1, the same with every standard library.
inline double uniform(std::mt19937_64& random) {
  return static_cast<double>(static_cast<std::int64_t>(random() >> 10)) * 0x1p-53 - 1;
}
inline Vec3 random_vector(std::mt19937_64& random) {
  return {uniform(random), uniform(random), uniform(random)};
}

/// The plane through a point, without contour.
inline PlaneSection plane_at(Vec3 normal, Vec3 point) { return {normal, -dot(normal, point), {}, {}, 0}; }

/// Adds a closed contour through the points.
inline void add_contour(PlaneSection& plane, const std::vector<Vec3>& points, std::uint32_t contour = 0) {
  const auto first = static_cast<std::uint32_t>(plane.vertices.size()),
             n = static_cast<std::uint32_t>(points.size());
  plane.vertices.insert(plane.vertices.end(), points.begin(), points.end());
  for (std::uint32_t i = 0; i < n; ++i)
    plane.edges.push_back({first + i, first + (i + 1) % n, 1, 0, contour, 100 + first + i});
}

/// A regular polygon around the centre.
inline std::vector<Vec3> polygon(Vec3 normal, Vec3 centre, double radius, int corners) {
  const Vec3 n = unit(normal);
  const Vec3 other = std::fabs(n.z) < 0.75 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 u = unit(cross(other, n)), v = cross(n, u);
  std::vector<Vec3> points;
  for (int i = 0; i < corners; ++i) {
    const double t = 6.283185307179586 * i / corners;
    points.push_back(centre + (radius * std::cos(t)) * u + (radius * std::sin(t)) * v);
  }
  return points;
}

/// A plane with one polygon.
inline PlaneSection disk(Vec3 normal, Vec3 centre, double radius = 1, int corners = 12) {
  PlaneSection plane = plane_at(normal, centre);
  add_contour(plane, polygon(normal, centre, radius, corners));
  return plane;
}

/// The square of half side `half` in the plane z = `z`, its centre at (x, y).
inline std::vector<Vec3> square(double x, double y, double z, double half) {
  return {{x - half, y - half, z}, {x + half, y - half, z}, {x + half, y + half, z}, {x - half, y + half, z}};
}

}  // namespace crossloft::test
