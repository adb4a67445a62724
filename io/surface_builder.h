#pragma once
/// Polygons on their way to triangles, with the checks that all surface formats share.

#include <cstdint>
#include <vector>

#include "../reconstruct/surface.h"
#include "token_reader.h"

namespace crossloft {

/// Adds a polygon as a fan around its first corner. REQUIRES: at least three corners.
inline void add_fan(Surface& surface, const std::vector<std::uint32_t>& corners) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    surface.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
}

/// Adds a polygon that a text names; fewer than three corners are ErrorCode::bad_count.
inline void add_polygon(TokenReader& in, Surface& surface, const std::vector<std::uint32_t>& corners) {
  if (corners.size() < 3) in.fail(ErrorCode::bad_count, "a face has fewer than three corners");
  if (in.ok()) add_fan(surface, corners);
}

}  // namespace crossloft
