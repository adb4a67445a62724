#pragma once
/// What is fuzzed: one target for each reader, and one for the pipeline. All take bytes and judge what comes
/// of them.

#include <span>
#include <string>
#include <string_view>

namespace crossloft::test {

struct FuzzTarget {
  const char* name;  ///< also the folder of its seeds and finds
  /// What promise the bytes break; empty if none.
  std::string (*judge)(std::string_view bytes);
};

/// contour, csl: sections that are read are reconstructed too. ply, obj, off, stl: surfaces are checked.
/// medit, vtu. points, weighted: triangulated. sites: their Moebius diagram, drawn. planes. pipeline: bytes
/// are choices (section_sets.h).
std::span<const FuzzTarget> fuzz_targets();

/// Of that name, nullptr if there is none.
const FuzzTarget* find_fuzz_target(std::string_view name);

}  // namespace crossloft::test
