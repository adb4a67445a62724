#pragma once
/// Room for results that several threads fill.

#include <thread>
#include <vector>

#include "../delaunay/large_pages.h"
#include "../geom/context.h"

namespace crossloft {

/// items.resize(count), its memory provided by the context's threads: the system takes longer for that than
/// filling it does. REQUIRES: no items yet.
template <class T>
void resize(std::vector<T>& items, std::size_t count, const Context& context) {
  const unsigned threads = context.threads != 0 ? context.threads : std::thread::hardware_concurrency();
  items.reserve(count);
  detail::provide_pages_for(items, count, detail::useful_threads(threads, count));
  items.resize(count);
}

}  // namespace crossloft
