#pragma once
/// What is promised of streams: a stack in windows against the stack at once, a file plane by plane against
/// the file at once.

#include <string>
#include <string_view>

#include "section_sets.h"

namespace crossloft::test {

struct StreamVerdict {
  std::string broken;  ///< what promise does not hold, empty if all do
  bool stack = false;  ///< the planes are parallel, and were streamed
  bool other = false;  ///< another surface than at once, as good; reconstruct/stack.h says when
};

/// Streams the set in windows as small as they get, if it is a stack, and compares with what it is `at_once`.
StreamVerdict judge_stream(const SectionSet& set, const Reconstruction& at_once);

/// Bytes as a file with this extension (".csl"): read plane by plane they are the sections, or the error, of
/// the file read at once.
std::string section_file_complaint(std::string_view bytes, const char* extension);

}  // namespace crossloft::test
