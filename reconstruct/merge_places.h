#pragma once
/// Merging: the last resort of mending (mend.h). What still crosses when moving vertices to places nearby has
/// not helped comes apart by giving one corner's place to another.

#include <cstdint>

#include "../geom/context.h"
#include "surface.h"

namespace crossloft {

struct Merging {
  std::uint64_t pairs = 0;   ///< that crossed or overlapped
  std::uint32_t merged = 0;  ///< vertices that took another one's place
};

/// For each pair of triangles that cross or overlap, as inspect/check.h counts them, one of their corners and
/// all vertices at its place take the place of another of the six: a near one after which
/// fewer pairs cross, or few more; and again until no pair is left. In tangles where too much would have to
/// be asked for that, all six come to one place. Triangles stay as they are by index, so that a manifold
/// stays one; some have no area any more.
///
/// It ends: each merge leaves one place less, and triangles of fewer than three have no inside. All exact on
/// the double coordinates. The same places for the same numbers of vertices and triangles. O(n log n) for n
/// triangles and each round, of few where little crosses. Source: our own.
Merging merge_crossing_places(Surface& surface, const Context& context = {});

}  // namespace crossloft
