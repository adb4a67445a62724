#pragma once
/// Where a section is solid in one cell's count only.
///
/// The tetrahedra of a cell around an edge inside a section form a *fan* from one ground triangle at the edge
/// to the other one. The count of a cell takes the two as connected by the section itself (ground.h), but a
/// section has no thickness: the solid is connected there only if the fan of one of the cells at the edge is
/// kept as a whole. A fan with a gap is *broken*.

#include <array>
#include <cstdint>
#include <vector>

#include "cell_complex.h"
#include "ground.h"

namespace crossloft {

/// A tetrahedron of a gap, by the two facets at the edge.
struct GapTet {
  std::uint32_t tet = kNone;
  std::uint8_t from = 0, to = 0;           ///< towards the fan's first and last ground triangle
  bool is_first = false, is_last = false;  ///< of its gap: on that side is what is kept, or the ground
};

struct BrokenFan {
  std::array<std::uint32_t, 2> edge{};    ///< vertices, ascending
  std::array<std::uint32_t, 2> ground{};  ///< ground triangles at its ends, the smaller number first
  /// All that is not kept, from the first ground triangle to the last one: one gap, or several with kept
  /// tetrahedra in between.
  std::vector<GapTet> gaps;
};

/// The broken fans of all edges with two ground triangles. O(n + degrees of these edges).
std::vector<BrokenFan> broken_fans(const CellComplex& complex, const Ground& ground,
                                   const std::vector<std::uint8_t>& kept);

}  // namespace crossloft
