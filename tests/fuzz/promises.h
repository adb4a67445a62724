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
  bool merged = false;             ///< crossed so much after rounding that vertices were merged
  bool stack = false;              ///< parallel planes, streamed too
  bool unlike = false;             ///< the stream is another surface
  // With plates: edges of theirs where a section contradicts another, needles that have no room for one.
  std::uint64_t outside = 0;
  bool bare = false;
};

/// Reconstructs and judges: no internal error; surface closed, oriented, a 2-manifold by index, without
/// proper crossings, its volume that of the tetrahedra; every plane met in its section but for the flat area
/// of the report; no handle within a cell in mode natural; numbers of the report that agree with the result;
/// the same bytes when told in another order to other threads; a stack can be streamed, with a surface as
/// good. With plates, compared with the same set without: outside of a section no more than another section
/// has there, nothing bare but needles.
Verdict judge(const SectionSet& set);

}  // namespace crossloft::test
