#pragma once
/// Merging: the last resort of mending (mend.h). What still crosses when moving vertices to places nearby has
/// not helped comes apart by giving one corner's place to another.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "../geom/context.h"
#include "surface.h"

namespace crossloft {

/// Pairs of triangles whose boxes meet, counted without regard to any order.
struct MergingEffort {
  std::uint64_t choosing = 1U << 22;  ///< asked to choose merges; from then on short ones of few triangles
  std::uint64_t renewing = 1U << 28;  ///< asked after rounds; from then on all corners of a pair are merged
};

struct Merging {
  std::uint32_t merged = 0;  ///< vertices that took another one's place
};

/// For each pair of triangles that cross or overlap, of which `crossing` has all, ascending, one of their
/// corners and all vertices at its place take the place of another of the six: a near one after which fewer
/// pairs cross, or few more; and again until no pair is left. Places with a vertex that is `exact` (by
/// vertex, none if empty) stay if another one of the six can go. In tangles where too much would have to be
/// asked for that
/// (`effort`), a near one around which there are few triangles; in the worst all six come to one place.
/// Triangles stay as they are by index, so that a manifold stays one; some have no area any more.
///
/// It ends: each merge leaves one place less, and triangles of fewer than three have no inside. All exact on
/// the double coordinates. The same places for the same numbers of vertices and triangles. Each round asks
/// around what the one before has moved. Source: our own.
Merging merge_crossing_places(Surface& surface, std::vector<std::array<std::uint32_t, 2>> crossing,
                              std::span<const std::uint8_t> exact = {}, const Context& context = {},
                              const MergingEffort& effort = {});

}  // namespace crossloft
