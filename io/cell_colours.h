#pragma once
/// A colour for each cell of a Moebius diagram, so that cells that meet differ.

#include <cstdint>
#include <vector>

#include "../moebius/diagram.h"

namespace crossloft {

/// A number below `colours` for each site. Sites whose cells share an arc get different ones where a greedy
/// choice finds one: always with six colours if the cells are connected. O(n + m) for m arcs, but for
/// sorting.
std::vector<std::uint32_t> colour_cells(const MoebiusDiagram& diagram, std::uint32_t colours);

}  // namespace crossloft
