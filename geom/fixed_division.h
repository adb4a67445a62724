#pragma once
/// Division, greatest common divisor and rounding of FixedInts. Plain bit by bit algorithms: they run once
/// per constructed point, never in a predicate.

#include <bit>
#include <cmath>

#include "fixed_int.h"

namespace crossloft {

template <unsigned Bits>
FixedInt<Bits> magnitude(const FixedInt<Bits>& v) {
  return v.negative() ? -v : v;
}

/// Number of bits of v >= 0: 0 for 0.
template <unsigned Bits>
int bit_length(const FixedInt<Bits>& v) {
  for (std::size_t i = v.kLimbs; i-- > 0;)
    if (v.limb[i] != 0) return static_cast<int>(64 * i) + 64 - std::countl_zero(v.limb[i]);
  return 0;
}

/// Number of zero bits below the lowest one. REQUIRES: v != 0.
template <unsigned Bits>
int trailing_zeros(const FixedInt<Bits>& v) {
  std::size_t i = 0;
  while (v.limb[i] == 0) ++i;
  return static_cast<int>(64 * i) + std::countr_zero(v.limb[i]);
}

/// v 2^n. REQUIRES: the result fits, n >= 0.
template <unsigned Bits>
FixedInt<Bits> shift_left(const FixedInt<Bits>& v, int n) {
  FixedInt<Bits> r;
  const auto whole = static_cast<std::size_t>(n / 64);
  const int part = n % 64;
  for (std::size_t i = whole; i < r.kLimbs; ++i) {
    r.limb[i] = v.limb[i - whole] << part;
    if (part != 0 && i > whole) r.limb[i] |= v.limb[i - whole - 1] >> (64 - part);
  }
  return r;
}

/// v / 2^n rounded down. REQUIRES: v >= 0, n >= 0.
template <unsigned Bits>
FixedInt<Bits> shift_right(const FixedInt<Bits>& v, int n) {
  FixedInt<Bits> r;
  const auto whole = static_cast<std::size_t>(n / 64);
  const int part = n % 64;
  for (std::size_t i = 0; i + whole < r.kLimbs; ++i) {
    r.limb[i] = v.limb[i + whole] >> part;
    if (part != 0 && i + whole + 1 < r.kLimbs) r.limb[i] |= v.limb[i + whole + 1] << (64 - part);
  }
  return r;
}

/// a - b for 0 <= b <= a.
template <unsigned Bits>
FixedInt<Bits> subtract_smaller(const FixedInt<Bits>& a, const FixedInt<Bits>& b) {
  return FixedInt<Bits>(a - b);
}

template <unsigned Bits>
bool less(const FixedInt<Bits>& a, const FixedInt<Bits>& b) {
  return (a - b).negative();
}

/// Binary algorithm. REQUIRES: a, b >= 0, not both 0.
template <unsigned Bits>
FixedInt<Bits> gcd(FixedInt<Bits> a, FixedInt<Bits> b) {
  if (a.is_zero()) return b;
  if (b.is_zero()) return a;
  const int common = std::min(trailing_zeros(a), trailing_zeros(b));
  a = shift_right(a, trailing_zeros(a));
  while (!b.is_zero()) {
    b = shift_right(b, trailing_zeros(b));
    if (less(b, a)) std::swap(a, b);
    b = subtract_smaller(b, a);
  }
  return shift_left(a, common);
}

template <unsigned Bits>
struct Division {
  FixedInt<Bits> quotient, remainder;
};

/// n = quotient d + remainder, 0 <= remainder < d. One step per bit of the quotient. REQUIRES: n >= 0, d > 0.
template <unsigned Bits>
Division<Bits> divide(const FixedInt<Bits>& n, const FixedInt<Bits>& d) {
  Division<Bits> r{{}, n};
  for (int bit = bit_length(n) - bit_length(d); bit >= 0; --bit) {
    const FixedInt<Bits> part = shift_left(d, bit);
    if (less(r.remainder, part)) continue;
    r.remainder = subtract_smaller(r.remainder, part);
    r.quotient.limb[static_cast<std::size_t>(bit / 64)] |= limbs::Limb{1} << (bit % 64);
  }
  return r;
}

/// v rounded to the nearest double, ties to even. REQUIRES: |v| < 2^1023.
template <unsigned Bits>
double to_double(const FixedInt<Bits>& v) {
  const FixedInt<Bits> m = magnitude(v);
  const int shift = std::max(0, bit_length(m) - 62);
  const FixedInt<Bits> high = shift_right(m, shift);
  // 62 bits and a sticky one below them: the conversion to 53 bits rounds as the whole number would.
  const bool sticky = shift_left(high, shift) != m;
  const double value = std::ldexp(static_cast<double>(2 * high.limb[0] + (sticky ? 1 : 0)), shift - 1);
  return v.negative() ? -value : value;
}

/// The double nearest to n / d, ties to even. REQUIRES: d > 0, |n / d| is 0 or between 2^-1000 and 2^1000.
template <unsigned Bits>
double round_quotient(const FixedInt<Bits>& n, const FixedInt<Bits>& d) {
  using Wide = FixedInt<Bits + 64>;  // the shifted numerator has at most 57 + Bits
  const Wide m(magnitude(n)), divisor(d);
  const int shift = std::max(0, 57 + bit_length(divisor) - bit_length(m));  // at least 57 bits of quotient
  const auto [quotient, remainder] = divide(shift_left(m, shift), divisor);
  // A bit below the quotient says whether anything is left.
  const double value = to_double(Wide(shift_left(quotient, 1) + Wide(remainder.is_zero() ? 0 : 1)));
  return std::ldexp(n.negative() ? -value : value, -shift - 1);
}

}  // namespace crossloft
