#pragma once
/// Minimum cuts without their flow, of less than the whole graph.

#include <cstdint>
#include <functional>
#include <vector>

#include "min_cut.h"

namespace crossloft {

/// What minimum_cut() keeps.
///
/// A tetrahedron whose own price outweighs that of all its facets is decided whatever its neighbours do: kept
/// if dropping it costs more, in every minimum cut; dropped if keeping it does not cost less, in the smallest
/// one. Its facets then count for the prices of its neighbours, which may decide them. What is left, some
/// hundredths in practice, is cut.
///
/// REQUIRES: as minimum_cut(); a terminal and the four capacities of a tetrahedron add up to kUncuttable at
/// most, so that nothing overflows. Near O(n), and minimum_cut() of what is left.
std::vector<std::uint8_t> smallest_cheapest(const CutProblem& problem);

/// What a terminal is in.
struct PriceRange {
  std::int64_t low = 0, high = 0;
};

/// The terminal of tetrahedron t by steps: 0 all that is known for nothing, 1 closer, 2 itself.
using PriceOf = std::function<PriceRange(std::uint32_t t, unsigned step)>;

/// The same, where terminals cost more than the cut: problem.terminal is not looked at, and what is decided
/// after one step is not asked for the next one. REQUIRES: all are in the limits of a terminal.
std::vector<std::uint8_t> smallest_cheapest(const CutProblem& problem, const PriceOf& price);

}  // namespace crossloft
