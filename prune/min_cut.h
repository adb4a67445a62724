#pragma once
/// Minimum cut of the dual graph of a tetrahedralization: which tetrahedra to keep when each has a price and
/// each facet between a kept and a dropped one has a price too. Integers only, so that the answer is exact.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "../geom/context.h"
#include "../geom/ids.h"

namespace crossloft {

/// Nodes are the tetrahedra, arcs lead through their facets.
///
/// REQUIRES: the three arrays have one size below kNone. Neighbours are mutual; no tetrahedron is its own
/// neighbour or twice a neighbour of another (true in space: two common facets are all four vertices).
/// 0 <= capacity <= kUncuttable, equal from both sides, 0 where there is no neighbour; |terminal| <=
/// kUncuttable; the minimum cut is below 2^61.
///
/// Then nothing overflows: a residual capacity is at most two capacities, 2^61; the value of a flow is below
/// 2^61; verify() adds up to 2^61 and the five prices of one more tetrahedron, less than 2^63.
///
/// kUncuttable is what must not be cut: a cut of n tetrahedra through weights up to c costs at most n c for
/// terminals and 2 n c for facets. While 3 n c < kUncuttable (c = 2^38 for n = 2^20, c = 2^40 for n = 2^18)
/// such a cut, if there is one, is cheaper than any through an uncuttable facet or terminal.
struct CutProblem {
  std::span<const std::array<std::uint32_t, 4>> neighbours;  ///< as in TetMesh, kNone: no neighbour
  /// [t][i]: price of keeping one of t and its neighbour across facet i, and dropping the other.
  std::vector<std::array<std::int64_t, 4>> capacity;
  /// > 0: price of dropping t (capacity from the source); < 0: minus the price of keeping it (to the sink).
  std::vector<std::int64_t> terminal;
  CancelFlag cancel = nullptr;  ///< once it is raised the result comes soon, and means nothing
};

inline constexpr std::int64_t kUncuttable = std::int64_t{1} << 60;

struct MinCut {
  /// 1 = kept, on the side of the source. Of all minimum cuts the one with the fewest kept: it is the
  /// intersection of their source sides (these are closed under intersection), thus independent of numbering
  /// and algorithm.
  std::vector<std::uint8_t> kept;
  std::int64_t value = 0;  ///< of the cut and of the flow
  /// A maximum flow, [t][i] out of t through facet i, negative into it. Maximum flows are not unique.
  std::vector<std::array<std::int64_t, 4>> flow;
};

/// Shortest augmenting paths (Edmonds & Karp 1972), found in a breadth-first forest from the source that is
/// repaired instead of rebuilt, as in Goldberg, Hed, Kaplan, Tarjan & Werneck, *Maximum Flows by Incremental
/// Breadth-First Search* (2011), from one side. O(n^3) whatever the capacities; near n where most
/// tetrahedra are decided by their own price. Memory: 60 bytes a
/// tetrahedron.
MinCut minimum_cut(const CutProblem& problem);

/// True iff `cut` proves itself: `flow` is a flow, the cut has its value (so both are
/// optimal), and the kept are exactly those that the source still reaches (so they are the fewest).
/// O(n).
bool verify(const CutProblem& problem, const MinCut& cut);

}  // namespace crossloft
