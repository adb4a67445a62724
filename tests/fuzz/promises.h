#pragma once
/// What is promised of every reconstruction, judged from outside; shared by the fuzz targets, the stress
/// program and the replay of kept inputs.

#include <optional>
#include <string>

#include "section_sets.h"

namespace crossloft::test {

struct Verdict {
  std::string broken;              ///< what promise does not hold, empty if all do
  std::optional<ErrorCode> error;  ///< the input was refused
  bool empty = false;              ///< a result without surface
  // Counted, not promised (README, limits): triangles that cross after rounding.
  std::uint64_t crossings = 0;
  // With plates: edges of theirs where a section contradicts another, needles that have no room for one.
  std::uint64_t outside = 0;
  bool bare = false;
};

/// Reconstructs and judges: no internal error; surface closed, oriented, a 2-manifold by index, its volume
/// that of the tetrahedra; every plane met in its section but for the flat area of the report; no handle
/// within a cell in mode natural; numbers of the report that agree with the result; the same bytes when told
/// in another order to other threads. With plates, compared with the same set without: outside of a section
/// no more than another section has there, nothing bare but needles.
Verdict judge(const SectionSet& set);

}  // namespace crossloft::test
