#pragma once
/// Exact representation behind a rational LatticePoint, and the general integer of geom's constructions; for
/// geom's sources and tests only, since it pulls in Boost.

// GCC 12 takes the copy loop between fixed widths for a copy past the end of the narrower one.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Warray-bounds"
#endif
#include <boost/multiprecision/cpp_int.hpp>

#include "fixed_int.h"

namespace crossloft {

/// Signed integer of `Bits` bits on the stack with division, for constructions that run a few times per
/// plane; no overflow check, widths are proven where they are used. Predicates use FixedInt.
template <unsigned Bits>
using Fixed = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<Bits, Bits, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;

/// Bits of W of a common point of three planes: the determinant of a 3x3 matrix with entries of at most 1 is
/// at most 4 (it is linear in each entry, hence largest at +-1, where it is 0 or +-4), so W <= 4 (2^40)^3.
inline constexpr unsigned kWeightBits = 122;
/// Bits of X, Y, Z: |X| <= 2^50 W.
inline constexpr unsigned kNumeratorBits = 50 + kWeightBits;

/// (x, y, z) / w in lowest terms: w >= 2, gcd(x, y, z, w) = 1. On a line point w <= 2^81.
struct Homogeneous {
  FixedInt<kNumeratorBits> x, y, z;
  FixedInt<kWeightBits> w;
};

}  // namespace crossloft
