#pragma once
/// Which doubles the formulas take without overflow, and without underflow of anything that a product of
/// doubles splits off. The formulas have degree 5 at most in the coordinates, weights counting twice.
///
/// Largest: coordinates 2^190, differences 2^191, a lift with its weight 3 * 2^382 + 2^381 < 2^384, det3 < 6
/// * 2^573 < 2^576, 24 terms of the whole < 24 * 2^955 < 2^960 and Veltkamp's splitting multiplies factors by
/// 2^27: all far below 2^1024. Smallest: a double of at least 2^-160 is a multiple of 2^-212; then all sums
/// and products, and the parts that they are split into, are multiples of 2^(-212 * 5) = 2^-1060, for weights
/// from 2^-371 on, multiples of 2^-424, likewise. Doubles hold such multiples down to 2^-1074.

#include <cmath>

namespace crossloft::strategies::range {

inline constexpr double kLargest = 0x1p+190, kLargestWeight = 0x1p+380;
inline constexpr double kSmallest = 0x1p-160, kSmallestWeight = 0x1p-371;

inline bool holds(double v, double smallest, double largest) {
  const double size = std::fabs(v);
  return size <= largest && (size >= smallest || size == 0);
}

/// Homogeneous coordinates of rational lattice points are taken times this. The formulas have degree 10 at
/// most in them: what is an integer below 2^1480 becomes a multiple of 2^-1000 below 2^480.
inline constexpr double kHomogeneousScale = 0x1p-100;

}  // namespace crossloft::strategies::range
