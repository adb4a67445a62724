#pragma once
/// Division, greatest common divisor and rounding of FixedInts. They run once per constructed point, never in
/// a predicate; short rather than the fastest known.

#include <bit>
#include <cmath>
#include <numeric>

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

template <unsigned Bits>
struct Division {
  FixedInt<Bits> quotient, remainder;
};

/// The leading `bits` <= 62 bits of v >= 0, and how many are below them.
struct Leading {
  std::int64_t value;
  int below;
};
template <unsigned Bits>
Leading leading(const FixedInt<Bits>& v, int bits) {
  const int below = std::max(0, bit_length(v) - bits);
  return {shift_right(v, below).to_int64(), below};
}

/// n = quotient d + remainder, 0 <= remainder < d. REQUIRES: n >= 0, d > 0.
///
/// Each round takes a multiple of d off the remainder r that is never too large, for r is rounded down to 62
/// bits and d up to 31, and too small by less than a part in 2^29 while r is long: r loses a factor 1 + 2^-61
/// at most, d gains 1 + 2^-30, and a quotient of 31 bits or more loses 2^-30. So a round settles 29 bits.
template <unsigned Bits>
Division<Bits> divide(const FixedInt<Bits>& n, const FixedInt<Bits>& d) {
  Division<Bits> result{{}, n};
  Leading divisor = leading(d, 31);
  if (divisor.below > 0) ++divisor.value;
  while (!less(result.remainder, d)) {
    const Leading dividend = leading(result.remainder, 62);
    const int shift = dividend.below - divisor.below;
    std::int64_t digit = dividend.value / divisor.value;
    if (shift < 0) digit = std::max<std::int64_t>(digit >> -shift, 1);
    const FixedInt<Bits> multiple = shift_left(FixedInt<Bits>(digit), std::max(shift, 0));
    result.quotient = FixedInt<Bits>(result.quotient + multiple);
    result.remainder = subtract_smaller(
        result.remainder, shift_left(FixedInt<Bits>(d * FixedInt<62>(digit)), std::max(shift, 0)));
  }
  return result;
}

/// Stein's binary algorithm, in fewer limbs as soon as both fit. REQUIRES: a, b > 0, odd.
template <unsigned Bits>
FixedInt<Bits> odd_gcd(FixedInt<Bits> a, FixedInt<Bits> b) {
  constexpr std::size_t kTop = FixedInt<Bits>::kLimbs - 1;
  if constexpr (kTop == 0) {
    return FixedInt<Bits>(std::gcd(a.to_int64(), b.to_int64()));
  } else {
    using Narrow = FixedInt<64 * kTop - 2>;
    while ((a.limb[kTop] | b.limb[kTop] | (a.limb[kTop - 1] | b.limb[kTop - 1]) >> 62) != 0) {
      const auto difference = a - b;
      if (difference.is_zero()) return a;
      if (!difference.negative()) a = b;
      const FixedInt<Bits> even = magnitude(FixedInt<Bits>(difference));
      b = shift_right(even, trailing_zeros(even));
    }
    return FixedInt<Bits>(odd_gcd(Narrow(a), Narrow(b)));
  }
}

/// REQUIRES: a, b >= 0, not both 0. One division first, since one may be far longer than the other.
template <unsigned Bits>
FixedInt<Bits> gcd(FixedInt<Bits> a, FixedInt<Bits> b) {
  if (less(a, b)) std::swap(a, b);
  if (b.is_zero()) return a;
  a = divide(a, b).remainder;
  if (a.is_zero()) return b;
  const int twos_a = trailing_zeros(a), twos_b = trailing_zeros(b);
  return shift_left(odd_gcd(shift_right(a, twos_a), shift_right(b, twos_b)), std::min(twos_a, twos_b));
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
