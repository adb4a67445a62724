#pragma once
/// What the slow tests of strategies share: at least 10^7 questions around zero, put to strategies that must
/// not contradict the exact sign, and an exact one must know.

#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <tuple>

#include "../../geom/strategies/list.h"

namespace crossloft::around_zero {

inline constexpr std::uint64_t kSeed = 20261125;
inline constexpr std::int64_t kTarget = 10'000'000;

struct Tally {
  std::int64_t inputs = 0, zeros = 0, positive = 0, wrong = 0;
};

/// One question; the truth is that of fixed-width integers.
template <class Q, class Case, class... S>
void judge(const Case& c, const std::tuple<S...>& watched, Tally& tally) {
  using namespace strategies;
  const Verdict expected = Q::ask(FixedIntegers(), c);
  ++tally.inputs, tally.zeros += expected == 0, tally.positive += expected > 0;
  const auto contradicts = [&](Verdict v, Guarantee g) {
    return v != expected && (v != kUnknown || g == Guarantee::exact);
  };
  std::apply([&](const S&... s) { ((tally.wrong += contradicts(Q::ask(s, c), S::kGuarantee)), ...); },
             watched);
}

/// sweep(tally) asks a number of questions; it is called until there are enough. They must have all three
/// answers.
template <class Q, class Sweep>
void ask_enough(const Sweep& sweep) {
  MESSAGE(std::string(Q::kName) << ", seed " << kSeed);
  Tally tally;
  while (tally.inputs < kTarget) sweep(tally);
  MESSAGE(tally.inputs << " inputs, " << tally.zeros << " zero, " << tally.positive << " positive");
  CHECK(tally.wrong == 0);
  CHECK(tally.zeros > 0);
  CHECK(tally.positive > tally.inputs / 10);
  CHECK(tally.positive < tally.inputs * 9 / 10);
}

}  // namespace crossloft::around_zero
