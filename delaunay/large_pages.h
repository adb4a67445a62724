#pragma once
/// Memory for large arrays that are read all over the place.

#include <cstddef>
#include <utility>
#include <vector>

#include "in_parallel.h"

namespace crossloft::detail {

/// Asks the system to back memory not yet used with large pages; no effect but on speed: fewer page faults.
void advise_large_pages(void* memory, std::size_t bytes);

/// Asks the system to provide the memory at once, not when it is first used: threads can share that work. No
/// effect on what is in it.
void provide_pages(void* memory, std::size_t bytes);

/// vector.reserve(count), in large pages.
template <class T>
void reserve_in_large_pages(std::vector<T>& items, std::size_t count) {
  if (count <= items.capacity()) return;
  std::vector<T> larger;
  larger.reserve(count);
  advise_large_pages(larger.data(), count * sizeof(T));
  larger.insert(larger.end(), items.begin(), items.end());
  items = std::move(larger);
}

/// The memory of items that will come, by several threads. REQUIRES: reserved room.
template <class T>
void provide_pages_for(std::vector<T>& items, std::size_t count, unsigned threads) {
  if (count <= items.size() || threads < 2) return;
  char* const from = reinterpret_cast<char*>(items.data() + items.size());
  in_slices(threads, (count - items.size()) * sizeof(T),
            [&](std::size_t begin, std::size_t end, unsigned) { provide_pages(from + begin, end - begin); });
}

/// vector.resize(count), in large pages.
template <class T>
void resize_in_large_pages(std::vector<T>& items, std::size_t count, unsigned threads = 1) {
  reserve_in_large_pages(items, count);
  provide_pages_for(items, count, threads);
  items.resize(count);
}

}  // namespace crossloft::detail
