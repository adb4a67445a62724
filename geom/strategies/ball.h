#pragma once
/// Strategy: doubles with a running error bound (bounded.h, where the bound is derived). A filter; it takes
/// every finite double: an overflow makes the error infinite or NaN, which leaves the sign uncertain, and
/// where an exact zero swallows it the number behind it was finite.

#include "../bounded.h"
#include "number_strategy.h"

namespace crossloft::strategies {

struct BallArithmetic {
  using Number = Bounded;
  static constexpr std::string_view kName = "ball";
  static constexpr Guarantee kGuarantee = Guarantee::filter;
  static constexpr bool kIntegers = false, kHomogeneous = false;

  static bool accepts(double v) { return std::isfinite(v); }
  static bool accepts_weight(double v) { return std::isfinite(v); }
  static Bounded from_integer(double v) { return v; }
  static Bounded from_double(double v) { return v; }
  /// Rounded to nearest: off by half an ulp at most, which is u |p| or less.
  static Bounded coordinate(const LatticePoint& p, int axis) {
    return {p[axis], p.is_explicit() ? 0 : 0x1p-53 * std::fabs(p[axis]) + 0x1p-1074};
  }
  static Verdict sign(const Bounded& v) { return v.is_certain() ? v.sign() : kUnknown; }
};

using Ball = NumberStrategy<BallArithmetic>;
static_assert(Strategy<Ball>);

}  // namespace crossloft::strategies
