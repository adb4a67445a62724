#pragma once
/// Sections that a file gives for one plane: which draw the same thing, and which lie within each other.

#include <cstdint>
#include <span>
#include <vector>

#include "../arrangement/sections.h"
#include "../geom/context.h"
#include "planar_lattice.h"

namespace crossloft {

/// A contour that lies within another section of its group, or on its outline, so that their union is without
/// it.
struct CoveredContour {
  std::uint32_t section = 0, contour = 0, by = 0;
  std::uint32_t vertex = kNone, edges = 0;  ///< its first vertex; its walls
};

struct PlaneRecords {
  std::vector<std::uint32_t> group;     ///< by section: the first of those that it is to be united with
  std::vector<CoveredContour> covered;  ///< by section, contour and cover
};

/// Sections whose outlines cross or run along each other draw the same thing twice, or parts of one thing:
/// they make a group, and what each of them holds is inside. Outlines of different groups meet at single
/// points at most. A group within another one is a hole there, as it would be in one section: even-odd. Exact
/// on the grid, after snap rounding. O(n^2) for n walls. Cancelled, every section is alone.
PlaneRecords compare_records(std::span<const PlaneSection* const> sections, const PlaneChart& chart,
                             const Context& context = {});

}  // namespace crossloft
