#include "parallel.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace crossloft {

bool parallel_for(std::size_t count, const Context& context, std::string_view stage,
                  const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  const auto drain = [&](bool reports) {
    for (std::size_t i; !context.cancelled() && (i = next.fetch_add(1, std::memory_order_relaxed)) < count;) {
      work(i);
      if (reports)
        context.report(stage, static_cast<double>(std::min(count, next.load())) / static_cast<double>(count));
    }
  };
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  // More threads than a few per core gain nothing, and a system that refuses one would end the program.
  const unsigned wanted = context.threads != 0 ? std::min(context.threads, 4 * cores) : cores;
  std::vector<std::thread> workers;
  for (unsigned t = 1; t < std::min<std::size_t>(wanted, count); ++t) workers.emplace_back(drain, false);
  drain(true);
  for (std::thread& worker : workers) worker.join();
  return !context.cancelled();
}

}  // namespace crossloft
