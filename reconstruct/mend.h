#pragma once
/// Mending: triangles of a written surface that cross because their vertices are rounded come apart again.
///
/// Exact points of lines of two planes and of three planes have no double coordinates, and far from the
/// origin no lattice point has: rounding moves them by half a unit in the last place, which may push a thin
/// piece through another.

#include <cstdint>
#include <span>
#include <vector>

#include "../geom/context.h"
#include "glue.h"
#include "surface.h"

namespace crossloft {

struct Mending {
  std::uint64_t found = 0;  ///< pairs of triangles that crossed or overlapped, as inspect/check.h counts them
  std::uint64_t left = 0;   ///< those that no move to a place nearby could mend; unless cancelled, merged
  std::uint32_t moved = 0;  ///< vertices
  std::uint32_t merged = 0;  ///< vertices at places of others, which leaves triangles without area
  double largest = 0;        ///< longest move
};

/// By vertex of the surface. Where the grid is finer than doubles any point may be moved to a place nearby,
/// but many are exact all the same, as what came in were doubles, too.
struct Rounding {
  std::vector<std::uint8_t> rounded;  ///< may have been, and may move
  std::vector<std::uint8_t> exact;    ///< is where it should be: merging keeps it there if it can
};

/// Finds pairs of triangles that cross or overlap and have a rounded vertex, and moves rounded vertices of
/// them, copies of one point together or, where that does not help, one by one, to one of 26 places around
/// where fewer pairs do: a unit in the last place of the largest coordinate away, twice as far where no move
/// helps any more, and so on up to a millionth of the diagonal (or 8 units). What still crosses then, or
/// after a bounded number of pairs has been asked, is merged (merge_places.h). All exact on the double
/// coordinates. Triangles without a rounded vertex are as exact as the solid, and do not cross.
///
/// `origins` as in GluedSurface. Expected O(n log n) for n triangles if few pairs cross;
/// where many do, each round asks all triangles again. Stops early if cancelled. Source: our own.
Mending mend_crossings(Surface& surface, std::span<const SurfaceVertex> origins, const Rounding& rounding,
                       const Context& context = {});

}  // namespace crossloft
