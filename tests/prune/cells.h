#pragma once
// Cells to prune: hand-made from their tetrahedra, and random ones with a Delaunay triangulation by brute
// force.

#include <array>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

#include "prune/cell_complex.h"

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

/// The same cell with its tetrahedra in another order and each with its vertices in another even order.
/// from[t] = the number that tetrahedron t had.
CellComplex shuffled(const CellComplex& cell, std::mt19937& random, std::vector<std::uint32_t>& from);

}  // namespace crossloft::test
