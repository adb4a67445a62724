#pragma once
/// Sorting what most of the memory holds: tetrahedra and triangles by vertex numbers.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "../geom/context.h"

namespace crossloft {

/// Into lexicographic order. O(n log k) for k items of the same first number, and as much memory again. Of no
/// use if the context has been cancelled. REQUIRES: first numbers below `firsts`.
void sort_quadruples(std::span<std::array<std::uint32_t, 4>> items, std::size_t firsts,
                     const Context& context);

}  // namespace crossloft
