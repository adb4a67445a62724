#pragma once
/// Which sections of a cell a solid joins, and how sure that is.

#include <cstdint>
#include <span>
#include <vector>

#include "cell_complex.h"
#include "ground.h"

namespace crossloft {

/// Two bodies that became one, or did not because the confidence was too low. A body is named by the smallest
/// section vertex in it.
struct Join {
  std::uint32_t a = kNone, b = kNone;  ///< a <= b; equal if two sections of one face touch there
  std::int32_t confidence = 0;         ///< of the joining tetrahedron, the bottleneck of the best way
  bool done = false;

  friend auto operator<=>(const Join&, const Join&) = default;
};

/// The section vertex that names each part of the ground: by ground triangle, set where it is the part's
/// first.
std::vector<std::uint32_t> part_names(const CellComplex& complex, const Ground& ground);

/// The joins that make one body of several sections, each by its best way: Kruskal's algorithm from the most
/// confident tetrahedron down, so the most confident join first. Does not depend on the numbers of the
/// tetrahedra nor on the order of their vertices. O(n log n).
std::vector<Join> find_joins(const CellComplex& complex, const Ground& ground,
                             const std::vector<std::uint8_t>& kept, std::span<const std::int32_t> confidence);

/// Tetrahedra with chosen[t] != 0, the most confident first, equals by their sorted vertices. O(n log n).
std::vector<std::uint32_t> by_confidence(const CellComplex& complex, const std::vector<std::uint8_t>& chosen,
                                         std::span<const std::int32_t> confidence);

}  // namespace crossloft
