#pragma once
/// The plain results: a triangle surface and a tetrahedral solid, in input units.

#include <array>
#include <cstdint>
#include <vector>

#include "../geom/vec3.h"

namespace crossloft {

/// Triangles counter-clockwise seen from outside. Points with equal coordinates and different indices are
/// different vertices (copies of a pinched vertex).
struct Surface {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Tetrahedra a, b, c, d with det(b-a, c-a, d-a) > 0 before coordinates were rounded.
struct Solid {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 4>> tets;
};

}  // namespace crossloft
