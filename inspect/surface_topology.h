#pragma once
/// The part of the check that reads indices only.

#include <array>
#include <cstdint>
#include <vector>

#include "check.h"

namespace crossloft {

/// The triangles that the rest of a check looks at, and what they belong to.
struct SurfaceTopology {
  std::vector<std::uint32_t>
      triangles;  ///< indices of those with three different indices in range, ascending
  std::vector<std::uint32_t> component;  ///< per entry of `triangles`, index into CheckReport::components
};

/// Fills in the counts by index, the components with all but volume and depth, and the genus. O(n log n).
SurfaceTopology check_topology(const Surface& surface, CheckReport& report);

inline std::array<Vec3, 3> corners(const Surface& surface, std::uint32_t triangle) {
  const auto& t = surface.triangles[triangle];
  return {surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]};
}

}  // namespace crossloft
