#include "large_pages.h"

#if defined(__linux__)
#include <sys/mman.h>

#include <cstdint>
#endif

namespace crossloft::detail {

void advise_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::uintptr_t kSmallPage = 4096, kLargePage = std::uintptr_t{1} << 21;
  if (bytes < 2 * kLargePage) return;
  const auto begin = (reinterpret_cast<std::uintptr_t>(memory) + kSmallPage - 1) & ~(kSmallPage - 1);
  const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) & ~(kSmallPage - 1);
  madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);  // advice: a refusal is no error
#endif
}

}  // namespace crossloft::detail
