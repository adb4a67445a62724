#pragma once
/// Where a surface touches itself, exactly on its double coordinates.

#include <array>
#include <cstdint>
#include <vector>

#include "../geom/context.h"
#include "surface.h"

namespace crossloft {

/// Pairs of triangles, ascending, that have common points beside the vertices and the edge that they share by
/// index: they touch, cross or overlap. Without any the surface is embedded: no point of space is on it
/// twice. A triangle without area may be reported with a neighbour that it does not meet. Expected O(n log n)
/// for n triangles (close_pairs.h). Some of them if cancelled.
std::vector<std::array<std::uint32_t, 2>> find_contacts(const Surface& surface, const Context& context = {});

}  // namespace crossloft
