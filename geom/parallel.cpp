#include "parallel.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include "failing.h"

namespace crossloft {

bool parallel_for(std::size_t count, const Context& context, std::string_view stage,
                  const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0}, done{0};
  std::size_t told = 0;
  const auto report = [&] {
    told = done.load();
    context.report(stage, static_cast<double>(told) / static_cast<double>(count));
  };
  SharedFailure failure;
  const auto may_go_on = [&] { return !context.cancelled() && !failure.failed(); };
  const auto drain = [&](unsigned k) {
    failure.keep_from([&] {
      for (std::size_t i; may_go_on() && (i = next.fetch_add(1, std::memory_order_relaxed)) < count;) {
        work(i);
        done.fetch_add(1);
        if (k == 0) report();
      }
    });
  };
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  // More threads than a few per core gain nothing.
  const unsigned wanted = context.threads != 0 ? std::min(context.threads, 4 * cores) : cores;
  std::vector<std::thread> workers =
      start_threads(static_cast<unsigned>(std::min<std::size_t>(wanted, count)), drain);
  drain(0);
  for (std::thread& worker : workers) worker.join();
  failure.pass_on();
  if (done.load() == count && told < count) report();  // other threads had the last ones
  return !context.cancelled();
}

}  // namespace crossloft
