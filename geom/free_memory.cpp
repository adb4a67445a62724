#include "free_memory.h"

#if defined(__GLIBC__) || defined(__linux__)
#include <features.h>
#endif
#if defined(__GLIBC__)
#include <malloc.h>

#include <cstddef>
#endif

namespace crossloft {

void release_free_memory() {
#if defined(__GLIBC__)
  constexpr std::size_t kWholeTop = std::size_t{1} << 62;  // the end of the heap is the program's to keep
  malloc_trim(kWholeTop);
#endif
}

}  // namespace crossloft
