#pragma once
/// From loose segments to a section with closed contours.

#include <array>
#include <vector>

#include "../arrangement/sections.h"

namespace crossloft {

/// Makes vertices of equal coordinates one, drops degenerate segments, cancels equal ones in pairs, and
/// numbers the rest as loops that pass no vertex twice. What is left of it must close (every point an end of
/// an even number of segments). Vertices and edges come loop by loop, starting at lexicographically smallest
/// points. O(n log n).
void trace_contours(const std::vector<std::array<Vec3, 2>>& segments, PlaneSection& section);

}  // namespace crossloft
