#include "heap.h"

#if defined(__linux__)
#include <features.h>
#endif
#if defined(__GLIBC__)
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#endif

namespace crossloft::cli {

#if defined(__GLIBC__)
namespace {

constexpr int kLargestInHeap = 32 << 20;  // as far as glibc goes; what is larger is mapped for itself
constexpr int kFirstExtent = 1 << 30;     // addresses, not memory
constexpr int kFurtherExtents = 64 << 20;
constexpr std::uintptr_t kLargePage = std::uintptr_t{1} << 21;

/// Advice holds for what is there: so the heap gets its addresses in one go.
void advise_large_pages() {
  const auto begin = (reinterpret_cast<std::uintptr_t>(sbrk(0)) + kLargePage - 1) & ~(kLargePage - 1);
  mallopt(M_TOP_PAD, kFirstExtent);
  void* volatile first = std::malloc(kLargestInHeap / 2);  // volatile: or the compiler does without
  std::free(first);
  mallopt(M_TOP_PAD, kFurtherExtents);
  const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0)) & ~(kLargePage - 1);
  if (begin < end) madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
}

}  // namespace
#endif

void prepare_heap() {
#if defined(__GLIBC__)
  mallopt(M_MMAP_THRESHOLD, kLargestInHeap);
  mallopt(M_TRIM_THRESHOLD, 2 * (kFirstExtent - 1));
#if defined(MADV_HUGEPAGE)
  advise_large_pages();
#endif
#endif
}

}  // namespace crossloft::cli
