#pragma once
/// Strategy: the formulas in long double and their sign as it comes out. No guarantee.

#include "../../geom/strategies/number_strategy.h"

namespace crossloft::strategies {

struct LongDoubleArithmetic {
  using Number = long double;
  static constexpr std::string_view kName = "long double";
  static constexpr Guarantee kGuarantee = Guarantee::none;
  static constexpr bool kIntegers = false, kHomogeneous = false;

  static bool accepts(double) { return true; }
  static bool accepts_weight(double) { return true; }
  static Number from_integer(double v) { return v; }
  static Number from_double(double v) { return v; }
  static Number coordinate(const LatticePoint& p, int axis) { return p[axis]; }
  static Verdict sign(Number v) { return (v > 0) - (v < 0); }
};

using LongDouble = NumberStrategy<LongDoubleArithmetic>;
static_assert(Strategy<LongDouble>);

}  // namespace crossloft::strategies
