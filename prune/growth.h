#pragma once
/// Step 3 of the paper: connecting more than two planes.

#include <cstdint>
#include <vector>

#include "cell_complex.h"

namespace crossloft {

/// What a candidate with exactly two facets in the solid must satisfy. Its two other facets meet in the edge
/// between the two vertices that the glued facets don't share; were this edge in the solid already, the solid
/// would close on itself along it, and were it grounded, its shell would not be solid.
enum class TwoFacetRule : std::uint8_t {
  corrected,  ///< that edge is neither in the solid nor grounded
  literal,    ///< no condition, as printed
};

/// Adds candidates with four, three or two facets in the solid to `kept` until there are none.
/// A first-in first-out list as in the paper, in canonical order: first all candidates with two facets or
/// more by their sorted vertices, then, after each addition, its neighbours that have become so, again by
/// sorted vertices. With `corrected` the result is solid if `kept` was; the order matters where two
/// candidates want one edge. REQUIRES: both arrays have complex.mesh.size() entries; candidates[t] and
/// kept[t] are not both set; a candidate has no grounded facet. Time: n log n for the order, plus the degrees
/// of the edges asked for.
void grow_over_facets(const CellComplex& complex, const std::vector<std::uint8_t>& candidates,
                      TwoFacetRule rule, std::vector<std::uint8_t>& kept);

}  // namespace crossloft
