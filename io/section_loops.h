#pragma once
/// The walls of a section as closed loops with their nesting, as `.csl` needs them.

#include <cstdint>
#include <vector>

#include "../arrangement/sections.h"
#include "../geom/result.h"

namespace crossloft {

struct SectionLoop {
  std::vector<std::uint32_t> vertices;  ///< in order; the last is joined to the first
  std::int32_t material = 1;            ///< inside, that of the first wall
  bool mixed = false;                   ///< walls of the loop bound different materials
  std::uint32_t parent = kNone;         ///< the loop that a hole is in, kNone for no hole
};

/// Joins the walls of a section (edges with the outside on exactly one side, equal ones cancelled in pairs)
/// to loops. At a vertex of higher degree neighbours around it are joined, so loops touch there and never
/// cross. Holes are loops inside an odd number of others, decided in double precision. Errors: open_chain at
/// a vertex with an odd number of walls. O(n log n + loops * n) at worst, boxes skip most pairs. REQUIRES:
/// edges that name vertices of the plane.
Result<std::vector<SectionLoop>> section_loops(const PlaneSection& plane);

}  // namespace crossloft
