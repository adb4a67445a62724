#include "large_pages.h"

#if defined(__linux__)
#include <sys/mman.h>

#include <cstdint>
#endif

namespace crossloft::detail {
namespace {

#if defined(__linux__)
/// Of the whole pages within the memory. It is advice: a refusal is no error.
void advise(void* memory, std::size_t bytes, int advice) {
  constexpr std::uintptr_t kPage = 4096;
  const auto begin = (reinterpret_cast<std::uintptr_t>(memory) + kPage - 1) & ~(kPage - 1);
  const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) & ~(kPage - 1);
  if (begin < end) madvise(reinterpret_cast<void*>(begin), end - begin, advice);
}
#endif

}  // namespace

void advise_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::size_t kLargePage = std::size_t{1} << 21;
  if (bytes >= 2 * kLargePage) advise(memory, bytes, MADV_HUGEPAGE);
#endif
}

void provide_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__) && defined(MADV_POPULATE_WRITE)
  advise(memory, bytes, MADV_POPULATE_WRITE);
#endif
}

}  // namespace crossloft::detail
