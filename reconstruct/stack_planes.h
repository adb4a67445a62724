#pragma once
/// What has to be known of all planes of a stack before the first can be reconstructed.

#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "../geom/lattice.h"
#include "stack.h"

namespace crossloft {

struct StackPlanes {
  /// In the file, from the lowest plane to the highest; in the order of the file where they are one.
  std::vector<std::uint32_t> positions;
  /// Where in `positions` each *level* begins, and the end of the last: planes that are one, or almost.
  std::vector<std::uint32_t> begin_of;
  std::vector<std::uint32_t> level_of;  ///< by position
  std::vector<std::uint32_t> vertices;  ///< by position
  Bounds extent, wide;                  ///< of all walls, of those of contours with area (PartOf)
  LatticeVector direction{};            ///< that frames give all planes
  std::set<std::int32_t> materials;     ///< but for the outside

  std::uint32_t levels() const { return static_cast<std::uint32_t>(begin_of.size()) - 1; }
  std::span<const std::uint32_t> level(std::uint32_t l) const {
    return std::span(positions).subspan(begin_of[l], begin_of[l + 1] - begin_of[l]);
  }
};

/// Reads every plane once, those with contours that may have no area once more, and once more those that
/// frames may put in another order, as the normal that they fit is tilted against the planes'. Errors: those
/// of the source, those of numbers and of contours that are not closed, and usage if a plane is not parallel
/// to the first (directions.h).
Result<StackPlanes> survey(SectionSource& source, const Context& context);

/// The planes of levels [first, last), as a part of the whole. Error: of the source.
Result<Sections> read_part(SectionSource& source, const StackPlanes& planes, std::uint32_t first,
                           std::uint32_t last);

/// Levels at which the stack is cut into windows, the first and the last included: each with `vertices`
/// vertices and `least` levels, as far as there are so many.
std::vector<std::uint32_t> window_levels(const StackPlanes& planes, std::uint64_t vertices,
                                         std::uint32_t least);

}  // namespace crossloft
