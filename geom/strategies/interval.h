#pragma once
/// Strategy: intervals of doubles, without changing the rounding mode: every end is moved outwards by more
/// than it can have been rounded. A filter.
///
/// With u = 2^-53, a computed v is off from the true value by at most u |v|, or by 2^-1075 where a product
/// underflows. Let e = fl(3u |v|) for a sum, fl(3u |v| + t) for a product, t = 2^-1000, far above all that
/// underflows and far enough from it: e >= 3u |v| (1 - u)^2, or 2^-1075 less where 3u |v| underflows. fl(v -
/// e)
/// <= (v - e) + u |v - e|, hence it stays below v by 3u |v| (1 - u)^2 - u |v| (1 + 4u) > u |v|. A sum with
/// |v| < 2^-1021 is exact; from there to 2^-968, where 3u |v| underflows, it is at least 3 * 2^-1074 and
/// keeps five sixths of itself. Upwards alike.
///
/// Zero times anything is 0 exactly, so that a vanishing factor decides. Coordinates are at most 2^190 and
/// weights 2^380, so that nothing overflows (formulas of degree 5; kLargest of number ranges).

#include <algorithm>
#include <cmath>

#include "number_range.h"
#include "number_strategy.h"

namespace crossloft::strategies {

struct Interval {
  double low = 0, high = 0;

  constexpr Interval() = default;
  constexpr Interval(double exact) : low(exact), high(exact) {}
  constexpr Interval(double l, double h) : low(l), high(h) {}

  bool is_zero() const { return low == 0 && high == 0; }

  friend Interval operator-(const Interval& a) { return {-a.high, -a.low}; }
  friend Interval operator+(const Interval& a, const Interval& b) {
    const double l = a.low + b.low, h = a.high + b.high;
    return {l - kThree * std::fabs(l), h + kThree * std::fabs(h)};
  }
  friend Interval operator-(const Interval& a, const Interval& b) { return a + -b; }
  friend Interval operator*(const Interval& a, const Interval& b) {
    if (a.is_zero() || b.is_zero()) return {};
    const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
    return {down(std::min(std::min(p, q), std::min(r, s))), up(std::max(std::max(p, q), std::max(r, s)))};
  }

 private:
  static constexpr double kThree = 3 * 0x1p-53, kTiny = 0x1p-1000;
  static double down(double v) { return v - (kThree * std::fabs(v) + kTiny); }
  static double up(double v) { return v + (kThree * std::fabs(v) + kTiny); }
};

struct IntervalArithmetic {
  using Number = Interval;
  static constexpr std::string_view kName = "interval";
  static constexpr Guarantee kGuarantee = Guarantee::filter;
  static constexpr bool kIntegers = false, kHomogeneous = false;

  static bool accepts(double v) { return std::fabs(v) <= range::kLargest; }
  static bool accepts_weight(double v) { return std::fabs(v) <= range::kLargestWeight; }
  static Interval from_integer(double v) { return v; }
  static Interval from_double(double v) { return v; }
  /// Rounded to nearest: the true coordinate is between the neighbours.
  static Interval coordinate(const LatticePoint& p, int axis) {
    const double v = p[axis], e = p.is_explicit() ? 0 : 0x1p-52 * std::fabs(v) + 0x1p-1074;
    return {v - e, v + e};
  }
  static Verdict sign(const Interval& v) {
    return v.low > 0 ? 1 : v.high < 0 ? -1 : v.is_zero() ? 0 : kUnknown;
  }
};

using IntervalStrategy = NumberStrategy<IntervalArithmetic>;
static_assert(Strategy<IntervalStrategy>);

}  // namespace crossloft::strategies
