#pragma once
/// Doubles that know how wrong they may be: a filter for any polynomial without a bound derived by hand.
///
/// A Bounded stands for a real number within `error` of `value`. With u = 2^-53 the rounding of one operation
/// is at most u times the computed result, or 2^-1075 where a product underflows (sums never do). For
/// operands A = a + a', |a'| <= ea, and B alike:
///     sum:      |A + B - (a + b)| <= ea + eb
///     product:  |A B - a b| <= |a| eb + |b| ea + ea eb
/// plus that rounding of the value. The errors themselves are sums and products of numbers >= 0 in at most
/// six rounded steps, each of which loses a factor 1 - u at most; multiplying by 1 + 8u restores it, for (1 -
/// u)^7 (1 + 8u) >= 1. The rounding enters as 2u |value|: that covers its own underflow, since below 2^-1021
/// sums are exact. kTiny is above all that underflows in a product. An exact zero stays exact, so that a
/// vanishing factor decides without a second stage. Overflow makes the error infinite or NaN: nothing is
/// certain.

#include <cmath>

#include "fp_check.h"

namespace crossloft {

struct Bounded {
  double value = 0, error = 0;

  constexpr Bounded() = default;
  constexpr Bounded(double exact) : value(exact) {}
  constexpr Bounded(double v, double e) : value(v), error(e) {}

  bool is_zero() const { return value == 0 && error == 0; }
  /// The sign is known: the number is away from 0 or exactly 0.
  bool is_certain() const { return std::abs(value) > error || is_zero(); }
  /// REQUIRES: is_certain().
  int sign() const { return value > 0 ? 1 : value < 0 ? -1 : 0; }

  friend Bounded operator-(const Bounded& a) { return {-a.value, a.error}; }
  friend Bounded operator+(const Bounded& a, const Bounded& b) {
    const double v = a.value + b.value;
    return {v, (a.error + b.error + kRounding * std::abs(v)) * kUp};
  }
  friend Bounded operator-(const Bounded& a, const Bounded& b) { return a + -b; }
  friend Bounded operator*(const Bounded& a, const Bounded& b) {
    if (a.is_zero() || b.is_zero()) return {};
    const double v = a.value * b.value;
    const double spread = std::abs(a.value) * b.error + (std::abs(b.value) + b.error) * a.error;
    return {v, (spread + (kRounding * std::abs(v) + kTiny)) * kUp};
  }

 private:
  static constexpr double kRounding = 0x1p-52, kUp = 1 + 0x1p-50, kTiny = 0x1p-1000;
};

}  // namespace crossloft
