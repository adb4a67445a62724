#pragma once
/// Work shared by several threads that are started for it; with one thread, plain calls.

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

namespace crossloft::detail {

/// How many of the threads asked for are worth their while for so many points. More than a few per core gain
/// nothing, and a system that refuses one would end the program.
inline constexpr unsigned kPointsPerThread = 20'000;
inline unsigned useful_threads(unsigned wanted, std::size_t points) {
  constexpr unsigned kMost = 256;
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  const auto enough = static_cast<unsigned>(std::min<std::size_t>(kMost, points / kPointsPerThread));
  return std::max(1u, std::min({wanted, 4 * cores, enough}));
}

/// work(0), work(1), .. work(threads - 1), all at once; the last of them over on return.
template <class Work>
void in_parallel(unsigned threads, const Work& work) {
  std::vector<std::thread> others;
  for (unsigned k = 1; k < threads; ++k) others.emplace_back([&work, k] { work(k); });
  work(0u);
  for (std::thread& other : others) other.join();
}

/// work(begin, end, k) on slice k of 0..count-1, for each thread one.
template <class Work>
void in_slices(unsigned threads, std::size_t count, const Work& work) {
  in_parallel(threads, [&](unsigned k) { work(count * k / threads, count * (k + 1) / threads, k); });
}

}  // namespace crossloft::detail
