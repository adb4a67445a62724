#pragma once
// Cells to prune: hand-made from their tetrahedra, and random ones with a Delaunay triangulation by brute
// force.

#include <array>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

#include "prune/cell_complex.h"
#include "prune/cell_shape.h"

namespace crossloft::test {

using Tet = std::array<std::uint32_t, 4>;
using Triangle = std::array<std::uint32_t, 3>;  ///< sorted

/// Neighbours, masks and kinds from tetrahedra, the faces (bits) of each vertex, and the grounded hull
/// triangles that are inside the sections. A grounded edge is external unless an internal triangle has it, a
/// contour edge if an external one has it too.
CellComplex make_cell(const std::vector<Tet>& tets, const std::vector<std::uint64_t>& masks,
                      const std::set<Triangle>& internal);

/// 8 to 18 points on the faces of a box, a wedge, or a slab; their Delaunay tetrahedra; internal
/// triangles by the toss of a coin or by a ball.
CellComplex random_cell(std::uint32_t seed);

/// A cell and where it is.
struct PlacedCell {
  CellComplex complex;
  CellShape shape;
};

/// random_cell(seed) with its points and planes; a wedge and a slab are closed by four faces without
/// vertices.
PlacedCell placed_cell(std::uint32_t seed);

/// A random cell whose tetrahedra may have any shape of solid: up to 10 of its points are within the cell. No
/// section gives such a cell, but what is combinatorial must not care.
CellComplex deep_cell(std::uint32_t seed);

/// The shape turned by a random rotation, so that no face is parallel to an axis.
CellShape turned(const CellShape& shape, std::mt19937& random);
/// A random cell, turned.
PlacedCell turned_cell(std::uint32_t seed, std::mt19937& random);

/// The same cell with 70 faces more, the first ones, that nothing is on: two words of face masks.
PlacedCell with_many_faces(const PlacedCell& cell);

/// The tetrahedra of R1: without external facet and edge.
std::vector<std::uint8_t> r1_of(const CellComplex& cell);

/// The same cell with its tetrahedra in another order and each with its vertices in another even order.
/// from[t] = the number that tetrahedron t had.
CellComplex shuffled(const CellComplex& cell, std::mt19937& random, std::vector<std::uint32_t>& from);

}  // namespace crossloft::test
