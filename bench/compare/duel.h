#pragma once
/// Two ways of doing the same, timed in turns.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

namespace crossloft::bench {

/// Each round runs both, taking turns at being first: what disturbs the machine disturbs both. The medians of
/// the times and of the ratios become counters.
class Duel {
 public:
  template <class Ours, class Theirs>
  void round(const Ours& ours, const Theirs& theirs) {
    const bool first = ours_.size() % 2 == 0;
    if (first) ours_.push_back(milliseconds(ours));
    theirs_.push_back(milliseconds(theirs));
    if (!first) ours_.push_back(milliseconds(ours));
    ratio_.push_back(ours_.back() / theirs_.back());
  }
  void report(benchmark::State& state) const {
    state.counters["ours_ms"] = median(ours_);
    state.counters["theirs_ms"] = median(theirs_);
    state.counters["ratio"] = median(ratio_);
  }

 private:
  template <class Run>
  static double milliseconds(const Run& run) {
    const auto start = std::chrono::steady_clock::now();
    run();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  }
  static double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

  std::vector<double> ours_, theirs_, ratio_;
};

}  // namespace crossloft::bench
