#pragma once
/// Sections and patches of one plane combined: what is inside of the result, and its boundary on the grid.

#include <cstdint>
#include <span>
#include <vector>

#include "../geom/context.h"
#include "planar_lattice.h"

namespace crossloft {

/// What the inside of a layer, even-odd, does to the result.
enum class LayerKind : std::uint8_t {
  section,  ///< is inside,
  added,    ///< becomes inside,
  removed,  ///< becomes outside whatever the others say
};

struct OverlaySegment {
  PlanarPoint a, b;
  std::uint32_t layer = 0;
};

/// A part of a segment that is boundary of the result, in the segment's direction.
struct OverlayEdge {
  PlanarPoint a, b;
  std::uint32_t segment = 0;  ///< of several in one place the first; segments are ordered by the caller
};

/// The boundary of (sections or added) and not removed. Every layer is read by even-odd on its own after all
/// segments were rounded together (snap_rounding.h); every decision is exact. Edges are in the order of their
/// segments and along them; they meet at ends alone, and every point has an even number of them.
/// O(n log n) for n segments where a single layer or nothing but sections far from the patches is concerned,
/// O(n) more for each piece in the box of a patch. Nothing if cancelled.
std::vector<OverlayEdge> overlay(std::span<const OverlaySegment> segments, std::span<const LayerKind> layers,
                                 const Context& context = {});

}  // namespace crossloft
