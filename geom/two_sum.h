#pragma once
/// Sums and products of two doubles without loss: the rounded result and what was rounded away. Exact unless
/// something over- or underflows; no fused multiply-add.
/// Source: T. J. Dekker, A floating-point technique for extending the available precision, 1971; D. E. Knuth,
/// The Art of Computer Programming, volume 2, 4.2.2.

#include "fp_check.h"

namespace crossloft {

/// high + low is the exact result, high the rounded one.
struct Exact2 {
  double high, low;
};

inline Exact2 two_sum(double a, double b) {
  const double s = a + b, bb = s - a;
  return {s, (a - (s - bb)) + (b - bb)};
}
/// REQUIRES: |a| >= |b|, or a = 0.
inline Exact2 fast_two_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a)};
}

/// The upper 26 bits and the rest, which has 26 too, its sign included.
inline Exact2 split(double a) {
  const double c = 0x1.0000002p+27 * a, high = c - (c - a);
  return {high, a - high};
}
/// With b's halves at hand.
inline Exact2 two_product(double a, double b, Exact2 halves) {
  const double p = a * b;
  const Exact2 h = split(a);
  const double rest = ((p - h.high * halves.high) - h.low * halves.high) - h.high * halves.low;
  return {p, h.low * halves.low - rest};
}
inline Exact2 two_product(double a, double b) { return two_product(a, b, split(b)); }

}  // namespace crossloft
