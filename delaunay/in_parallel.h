#pragma once
/// Work shared by several threads that are started for it; with one thread, plain calls.

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

#include "../geom/failing.h"

namespace crossloft::detail {

/// How many of the threads asked for are worth their while for so many points. More than a few per core gain
/// nothing.
inline constexpr unsigned kPointsPerThread = 20'000;
inline unsigned useful_threads(unsigned wanted, std::size_t points) {
  constexpr unsigned kMost = 256;
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  const auto enough = static_cast<unsigned>(std::min<std::size_t>(kMost, points / kPointsPerThread));
  return std::max(1u, std::min({wanted, 4 * cores, enough}));
}

/// work(0), work(1), .. work(threads - 1), all at once but for threads that the system refuses; the last of
/// them over on return, which fails if one of them did.
template <class Work>
void in_parallel(unsigned threads, const Work& work) {
  SharedFailure failure;
  const auto guarded = [&](unsigned k) { failure.keep_from([&] { work(k); }); };
  std::vector<std::thread> others = start_threads(threads, guarded);
  guarded(0);
  for (auto k = static_cast<unsigned>(others.size()) + 1; k < threads; ++k) guarded(k);
  for (std::thread& other : others) other.join();
  failure.pass_on();
}

/// work(begin, end, k) on slice k of 0..count-1, for each thread one.
template <class Work>
void in_slices(unsigned threads, std::size_t count, const Work& work) {
  in_parallel(threads, [&](unsigned k) { work(count * k / threads, count * (k + 1) / threads, k); });
}

}  // namespace crossloft::detail
