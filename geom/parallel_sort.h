#pragma once
/// Sorting by several threads.

#include <algorithm>
#include <string_view>
#include <thread>
#include <vector>

#include "parallel.h"

namespace crossloft {

/// std::sort of long lists by context.threads threads: parts are sorted, then merged two by two, each merge
/// in pieces of its own. Of no use if the context has been cancelled. REQUIRES: no two items are equal, so
/// that the result is the same whatever the threads; T is cheap to copy and has a default.
template <class T, class Before>
void sort_in_parallel(std::vector<T>& items, const Context& context, std::string_view stage,
                      const Before& before) {
  const unsigned threads = context.threads != 0 ? context.threads : std::thread::hardware_concurrency();
  std::size_t parts = 1;
  while (parts < 4 * std::size_t{threads} && parts < 64 && items.size() / parts > 4 * kBlock) parts *= 2;
  if (threads == 1 || parts == 1) return std::sort(items.begin(), items.end(), before);
  const auto begin_of = [&](std::size_t part) { return items.size() * part / parts; };
  parallel_for(parts, context, stage, [&](std::size_t p) {
    std::sort(items.data() + begin_of(p), items.data() + begin_of(p + 1), before);
  });
  std::vector<T> merged(items.size());
  for (std::size_t width = 1; width < parts && !context.cancelled(); width *= 2) {
    // Piece k of a pair of runs: a part of the first run, and of the second what belongs there.
    const auto merge_piece = [&](std::size_t k) {
      const T* const list = items.data();
      const std::size_t run = k / width * 2 * width;
      const T *const a = list + begin_of(run), *const b = list + begin_of(run + width),
                     *const end = list + begin_of(run + 2 * width);
      const T *const from = list + begin_of(run + k % width), *const to =
                                                                  list + begin_of(run + k % width + 1);
      const T* const low = from == a ? b : std::lower_bound(b, end, *from, before);
      const T* const high = to == b ? end : std::lower_bound(b, end, *to, before);
      std::merge(from, to, low, high, merged.data() + (from - list) + (low - b), before);
    };
    parallel_for(parts / 2, context, stage, merge_piece);
    items.swap(merged);
  }
}

}  // namespace crossloft
