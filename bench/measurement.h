#pragma once
/// What the benchmark of predicates measures, and the pages it is shown on.

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace crossloft::bench {

/// One strategy on one predicate and distribution.
struct Measurement {
  std::string predicate, distribution, strategy;
  double nanoseconds = 0;  ///< per call, the median of the repetitions
  double multiple = 0;     ///< of the naive strategy's time on the same data
  double wrong = 0;        ///< share of the calls answered, and wrongly: the naive strategy alone may
  std::vector<std::string> stages{};  ///< of a cascade; else the strategy itself
  std::vector<double> decided{};      ///< share of the calls that each stage decided, and last the unknown
};

/// Something to be timed: `run(n)` does n calls.
struct Contestant {
  std::function<void(std::size_t)> run;
  std::vector<double> samples{};
};

/// The upper one of an even number. REQUIRES: not empty.
double median(std::vector<double> values);

/// Nanoseconds per call, medians over `repetitions` rounds in which all contestants take turns; each turn is
/// as many calls as take some `turn_seconds`, `least_calls` of them or more.
std::vector<double> take_turns(std::vector<Contestant> contestants, int repetitions, double turn_seconds,
                               std::size_t least_calls = 16);

/// One table a predicate: strategies down, distributions across, nanoseconds and multiples; then where the
/// cascades decided.
void print_tables(const std::vector<Measurement>& measurements);
std::string to_json(const std::vector<Measurement>& measurements);
/// One panel a predicate: strategies down, time across on a logarithmic scale, a dot for each distribution.
std::string to_svg(const std::vector<Measurement>& measurements);

}  // namespace crossloft::bench
