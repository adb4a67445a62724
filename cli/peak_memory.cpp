#include "peak_memory.h"

#include <sys/resource.h>

#include <cinttypes>
#include <cstdio>

namespace crossloft::cli {

/// ru_maxrss outlives exec: a program that a large one has started begins with that one's size. VmHWM belongs
/// to this program alone, so it is asked first.
std::uint64_t peak_memory_kib() {
  std::uint64_t kib = 0;
  if (std::FILE* status = std::fopen("/proc/self/status", "r")) {
    char line[256];
    while (kib == 0 && std::fgets(line, sizeof line, status) != nullptr)
      if (std::sscanf(line, "VmHWM: %" SCNu64, &kib) != 1) kib = 0;
    std::fclose(status);
  }
  struct rusage usage = {};
  if (kib == 0 && getrusage(RUSAGE_SELF, &usage) == 0) kib = static_cast<std::uint64_t>(usage.ru_maxrss);
  return kib;
}

}  // namespace crossloft::cli
