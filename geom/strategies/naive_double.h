#pragma once
/// Strategy: the formula in doubles and its sign as it comes out. No guarantee, the floor of every
/// comparison; NaN counts as 0.

#include "number_strategy.h"

namespace crossloft::strategies {

struct DoubleArithmetic {
  using Number = double;
  static constexpr std::string_view kName = "naive";
  static constexpr Guarantee kGuarantee = Guarantee::none;
  static constexpr bool kIntegers = false, kHomogeneous = false;

  static bool accepts(double) { return true; }
  static bool accepts_weight(double) { return true; }
  static double from_integer(double v) { return v; }
  static double from_double(double v) { return v; }
  static double coordinate(const LatticePoint& p, int axis) { return p[axis]; }
  static Verdict sign(double v) { return static_cast<int>(v > 0) - static_cast<int>(v < 0); }
};

using NaiveDouble = NumberStrategy<DoubleArithmetic>;
static_assert(Strategy<NaiveDouble>);

}  // namespace crossloft::strategies
