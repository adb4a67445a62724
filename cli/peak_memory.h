#pragma once
/// How much memory the program has needed.

#include <cstdint>

namespace crossloft::cli {

/// The largest resident size of the process since it was started, in KiB; 0 if the system doesn't tell.
std::uint64_t peak_memory_kib();

}  // namespace crossloft::cli
