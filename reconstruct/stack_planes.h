#pragma once
/// What has to be known of all planes of a stack before the first can be reconstructed.

#include <cstdint>
#include <span>
#include <vector>

#include "stack.h"

namespace crossloft {

struct StackPlanes {
  std::vector<std::uint32_t> positions;  ///< in the file, from the lowest plane to the highest
  std::vector<std::uint32_t> rank_of;    ///< by position, the inverse
  std::vector<std::uint32_t> vertices;   ///< by position
  Bounds extent;                         ///< of all walls
};

/// Reads every plane once. Errors: those of the source, those of numbers and of contours that are not closed,
/// and usage if a plane is not parallel to the first.
Result<StackPlanes> survey(SectionSource& source, const Context& context);

/// The planes of ranks [first, last), as a part of the whole. Error: of the source.
Result<Sections> read_part(SectionSource& source, const StackPlanes& planes, std::uint32_t first,
                           std::uint32_t last);

/// Ranks at which the stack is cut into windows, the first and the last included: each with `vertices` vertices
/// and `least` planes, as far as there are so many.
std::vector<std::uint32_t> window_ranks(const StackPlanes& planes, std::uint64_t vertices,
                                        std::uint32_t least);

}  // namespace crossloft
