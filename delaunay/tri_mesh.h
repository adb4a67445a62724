#pragma once
/// The finished planar triangulation as plain arrays.

#include <array>
#include <cstdint>
#include <vector>

#include "../geom/ids.h"

namespace crossloft {

/// Finite triangles of a planar Delaunay triangulation.
///   vertices[t] = a, b, c counter-clockwise: orient2d(a, b, c) > 0;
///   neighbours[t][i] = triangle across the edge opposite vertex i, kNone on the hull.
struct TriMesh {
  std::vector<std::array<std::uint32_t, 3>> vertices;
  std::vector<std::array<std::uint32_t, 3>> neighbours;

  std::uint32_t size() const { return static_cast<std::uint32_t>(vertices.size()); }
};

}  // namespace crossloft
