#pragma once
/// `reconstruct --stream`: a stack of parallel planes that is too large to be held at once.

#include <cstdint>
#include <string>

#include "../reconstruct/reconstruct.h"
#include "terminal.h"

namespace crossloft::cli {

struct StreamArguments {
  std::string input, surface, report;  ///< files; report may be empty
  Options options;
  std::uint64_t window_vertices = 0;
};

/// Reconstructs and prints a summary. The surface and the report appear whole or not at all.
ExitCode stream(const StreamArguments& arguments, Terminal& terminal, const Context& context);

}  // namespace crossloft::cli
