#pragma once
/// Numbers of two doubles that know how wrong they may be: twice the digits of bounded.h, for any polynomial.
///
/// A DoubleDouble stands for a real number within `error` of high + low, where |low| <= u |high|, u = 2^-53.
/// Differences of doubles are held exactly. The roundings of one operation on A = a + a', B = b + b' (high +
/// low), to first order in u:
///     sum      s + e = a + b exactly (two_sum); t = a' + b' rounds by u |t| <= u^2 (|a| + |b|);
///              w = e + t by u |w| <= 2 u^2 (|a| + |b|); high + low = s + w exactly: 3 u^2 (|a| + |b|).
///     product  p + e = a b exactly (two_product), P = |p|; a' b' <= u^2 P is dropped; a b' and a' b round by
///              u^2 P each, their sum c by 2 u^2 P, w = e + c by 3 u^2 P; high + low = p + w: 8 u^2 P.
/// Errors of the operands enter as in bounded.h: ea + eb, and |A| eb + |B| ea + ea eb. Higher orders of u and
/// the at most eight roundings of the error itself are covered by kUp. In sums everything is a multiple of
/// 2^-1074, the rounding errors too, so that a bound of them rounded to the nearest multiple still holds. A
/// product below 2^-960 has its parts below 2^-985 and wrong by some 2^-1038: kTiny is above all that, and
/// what rounds is relative above. Overflow, also that of splitting factors from 2^996 on, makes the value NaN
/// or the error infinite: nothing is certain.
///
/// Sources: T. J. Dekker, A floating-point technique for extending the available precision, 1971 (split,
/// two_product); D. E. Knuth, The Art of Computer Programming 2, 4.2.2 (two_sum). The bounds are ours;
/// tests/geom/double_double_test.cpp holds them against rationals.

#include <cmath>

#include "fp_check.h"

namespace crossloft {

struct DoubleDouble {
  double high = 0, low = 0, error = 0;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double exact) : high(exact) {}
  constexpr DoubleDouble(double h, double l, double e) : high(h), low(l), error(e) {}

  /// a + b and a - b, exactly.
  static DoubleDouble sum(double a, double b) {
    const double s = a + b, from_b = s - a, from_a = s - from_b;
    return {s, (a - from_a) + (b - from_b), 0};
  }
  static DoubleDouble difference(double a, double b) { return sum(a, -b); }

  bool is_zero() const { return high == 0 && error == 0; }
  /// The sign is known: the number is away from 0 or exactly 0.
  bool is_certain() const { return std::abs(high) > error * kUp || is_zero(); }
  /// REQUIRES: is_certain().
  int sign() const { return high > 0 ? 1 : high < 0 ? -1 : 0; }

  friend DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low, a.error}; }
  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble s = sum(a.high, b.high);
    DoubleDouble r = sum(s.high, s.low + (a.low + b.low));
    r.error = (a.error + b.error + 3 * kSquare * (std::abs(a.high) + std::abs(b.high))) * kUp;
    return r;
  }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    if (a.is_zero() || b.is_zero()) return {};
    const double p = a.high * b.high;
    const double w = product_error(a.high, b.high, p) + (a.high * b.low + a.low * b.high);
    DoubleDouble r = sum(p, w);
    const double spread = std::abs(a.high) * b.error + (std::abs(b.high) + b.error) * a.error;
    r.error = (spread + (8 * kSquare * std::abs(p) + kTiny)) * kUp;
    return r;
  }

 private:
  static constexpr double kSquare = 0x1p-106, kUp = 1 + 0x1p-49, kTiny = 0x1p-1000;

  /// v = high + low, each of at most 26 bits.
  struct Halves {
    double high, low;
    explicit Halves(double v) {
      const double c = 0x1.0000002p27 * v;
      high = c - (c - v);
      low = v - high;
    }
  };
  /// a b - p for p = a b rounded.
  static double product_error(double a, double b, double p) {
    const Halves x(a), y(b);
    return ((x.high * y.high - p) + x.high * y.low + x.low * y.high) + x.low * y.low;
  }
};

}  // namespace crossloft
