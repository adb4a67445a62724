#pragma once
/// The finished 3D triangulation as plain arrays: what pruning and gluing read.

#include <array>
#include <cstdint>
#include <vector>

#include "../geom/ids.h"

namespace crossloft {

/// Finite tetrahedra of a Delaunay triangulation of points 0..n-1.
///   vertices[t] = a, b, c, d with orient3d(a, b, c, d) > 0;
///   neighbours[t][i] = tetrahedron across the facet opposite vertex i, kNone on the hull.
struct TetMesh {
  std::vector<std::array<std::uint32_t, 4>> vertices;
  std::vector<std::array<std::uint32_t, 4>> neighbours;

  std::uint32_t size() const { return static_cast<std::uint32_t>(vertices.size()); }
};

/// Vertices (slots 0..3) of the facet opposite slot i, counter-clockwise seen from outside the tetrahedron.
inline constexpr std::array<std::array<std::uint8_t, 3>, 4> kFacetSlots{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
/// Vertex slots of the six edges; edge e is opposite edge 5 - e.
inline constexpr std::array<std::array<std::uint8_t, 2>, 6> kEdgeSlots{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

}  // namespace crossloft
