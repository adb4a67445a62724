#pragma once
/// Which sections of a cell a solid joins, when confidences cost more than the search for them.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "joins.h"

namespace crossloft {

/// The same as find_joins() with the confidences that `measure` gives, but it is asked for part of them only,
/// and each time once: from the smallest section of each body Prim's algorithm goes on over the best way so
/// far, until it has met the other sections of the body. What is behind the worst of these joins is never
/// measured. `body`: by ground triangle, equal within a body (find_bodies). O(n log n).
std::vector<Join> find_widest_ways(const CellComplex& complex, const Ground& ground,
                                   const std::vector<std::uint8_t>& kept, std::span<const std::uint32_t> body,
                                   const std::function<std::int32_t(std::uint32_t)>& measure);

}  // namespace crossloft
