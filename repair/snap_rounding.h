#pragma once
/// Segments on the planar grid made to meet at grid points alone.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "../geom/context.h"
#include "planar_lattice.h"

namespace crossloft {

using PlanarSegment = std::array<PlanarPoint, 2>;

/// A straight part of a segment, in the segment's direction.
struct SegmentPiece {
  PlanarPoint a, b;           ///< different
  std::uint32_t segment = 0;  ///< which it is a part of
};

/// The pieces of the segments, those of one segment in order and in a row, so that two pieces share ends or
/// all points or nothing, and no end of a piece lies within the unit square of another piece's inner point.
/// A segment that meets nothing stays one piece; one of length 0 has none. No point moves by more than a few
/// steps. O(n log n + pairs of pieces and points with boxes that meet). Cancelled, it ends soon, and nothing
/// holds of the pieces.
std::vector<SegmentPiece> snap_round(std::span<const PlanarSegment> segments, const Context& context = {});

}  // namespace crossloft
