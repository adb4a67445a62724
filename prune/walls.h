#pragma once
/// Walls that a cell's solid lacks.
///
/// Where the sections go all the way around a cell they leave several parts of its hull outside. What is
/// between two of these is a wall of the solid, or a tunnel leads through it. Of a tunnel between two parts
/// that several faces show, none of their planes has met anything: it is there only where it is surely open.

#include <cstdint>
#include <functional>
#include <vector>

#include "cell_complex.h"

namespace crossloft {

/// Less sure than this is only what is surely open (docs/natural.md).
inline constexpr double kWallConfidence = -0.3;

struct Walls {
  std::uint32_t hull_parts = 0;  ///< of the hull outside of the sections, wide or not
  std::vector<std::uint32_t> lacking;
};

/// Where walls are to be: tetrahedra outside of the solid, of at least `least`, that part the others so that
/// no two *wide* parts of the hull (Opening::wide) are connected by them, but by those of less. They are on
/// the watershed of the confidence: the least confident comes first, to the parts of the hull that it
/// touches, unless it would connect two wide ones; equals by their sorted vertices. Tetrahedra hang together
/// at edges, as gluing leaves the outside connected there. None where the solid has all walls. In the order
/// of their confidence. `confidence`: of a tetrahedron. O(n) where there is one wide part or no wall is
/// lacking, and the degrees of edges outside; else O(n log n), and the confidences of all that is outside.
Walls find_walls(const CellComplex& complex, const std::vector<std::uint8_t>& solid, std::int32_t least,
                 const std::function<std::int32_t(std::uint32_t)>& confidence);

}  // namespace crossloft
