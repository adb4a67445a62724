#pragma once
/// Exact representation behind a rational LatticePoint; for geom's sources and tests.

#include <compare>

#include "fixed_int.h"

namespace crossloft {

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
