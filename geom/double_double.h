#pragma once
/// Numbers of two doubles that know how wrong they may be: twice the digits of bounded.h, for any polynomial, and
/// no error where everything fits, so that they decide zeros too.
///
/// A number stands for a real within `error` of high + low, |low| <= u |high|. Let A = a.high + a.low + a',
/// |a'| <= ea, B alike, u = 2^-53.
///   Sum: high parts by two_sum (s, e), low parts by two_sum (t, e'), then v = e + t by two_sum with rest
///   e''.
///     s + v differs from the true sum by a' + b' + e' + e'': the error is ea + eb + |e'| + |e''|.
///   Product: high parts by two_product (p, e); c = a.high b.low + a.low b.high, three operations, each off
///   by
///     u of its result, together at most 2u (x + y)(1 + u) with x, y the sizes of the two products; a.low
///     b.low is left out; v = e + c by two_sum with rest e''. The error is 4u (x + y) + |a.low b.low| + |e''|
///     + (|b.high| + |b.low| + eb) ea + (|a.high| + |a.low|) eb, plus t = 2^-1000, far above the few 2^-1074
///     that underflows cost, of the product and of the error alike.
/// (s, v) is renormalised by two_sum, exactly. The errors are sums and products of numbers >= 0, at most 12
/// rounded steps deep, each of which loses a factor 1 - u at most; (1 - u)^12 (1 + 16u) >= 1 restores them.
/// A product with exact zero is exact zero, one of low parts 0 and representable has rests of 0: only t
/// stays, which is left away if a.high, b.high are at least 2^-400, for then e is exact. Sums never underflow.
/// Overflow, also that of splitting factors from 2^996 on, makes the value NaN or the error infinite: nothing
/// is certain.
///
/// Sources: those of two_sum.h. The bounds are ours; tests/geom/double_double_test.cpp holds them against
/// rationals.

#include <cmath>

#include "two_sum.h"

namespace crossloft {

struct DoubleDouble {
  double high = 0, low = 0, error = 0;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double exact) : high(exact) {}
  constexpr DoubleDouble(double h, double l, double e) : high(h), low(l), error(e) {}

  /// a + b and a - b, exactly.
  static DoubleDouble sum(double a, double b) {
    const Exact2 s = two_sum(a, b);
    return {s.high, s.low, 0};
  }
  static DoubleDouble difference(double a, double b) { return sum(a, -b); }

  bool is_zero() const { return high == 0 && low == 0 && error == 0; }
  /// The sign is known: the number is away from 0 or exactly 0. The difference of its parts is exact up to u
  /// of itself.
  bool is_certain() const { return (std::fabs(high) - std::fabs(low)) * (1 - 0x1p-50) > error || is_zero(); }
  /// REQUIRES: is_certain().
  int sign() const { return high > 0 ? 1 : high < 0 ? -1 : 0; }

  friend DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low, a.error}; }
  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const Exact2 s = two_sum(a.high, b.high), t = two_sum(a.low, b.low), v = two_sum(s.low, t.high);
    const Exact2 r = two_sum(s.high, v.high);
    return {r.high, r.low, ((a.error + b.error) + (std::fabs(t.low) + std::fabs(v.low))) * kUp};
  }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    if (a.is_zero() || b.is_zero()) return {};
    const Exact2 p = two_product(a.high, b.high);
    const double x = a.high * b.low, y = a.low * b.high;
    const Exact2 v = two_sum(p.low, x + y), r = two_sum(p.high, v.high);
    const double rounded =
        0x1p-51 * (std::fabs(x) + std::fabs(y)) + std::fabs(a.low * b.low) + std::fabs(v.low);
    const double spread = (std::fabs(b.high) + std::fabs(b.low) + b.error) * a.error +
                          (std::fabs(a.high) + std::fabs(a.low)) * b.error;
    return {r.high, r.low, (rounded + spread + tiny(a, b)) * kUp};
  }

 private:
  static constexpr double kUp = 1 + 0x1p-49;

  /// 0 for products that are exact as they are: no low parts, no errors, and high parts of at least 2^-400,
  /// whose product's parts are multiples of 2^-904.
  static double tiny(const DoubleDouble& a, const DoubleDouble& b) {
    const bool plain = a.low == 0 && b.low == 0 && a.error == 0 && b.error == 0;
    return plain && std::fabs(a.high) >= 0x1p-400 && std::fabs(b.high) >= 0x1p-400 ? 0 : 0x1p-1000;
  }
};

}  // namespace crossloft
