#pragma once
/// Homogeneous coordinates as sums of doubles, times range::kHomogeneousScale.

#include <cstddef>

#include "../fixed_int.h"
#include "number_range.h"

namespace crossloft::strategies {

/// The number's bits by 32, each piece an exact double, summed in the type T from the lowest up.
template <class T, unsigned Bits>
T sum_of_pieces(const FixedInt<Bits>& v) {
  const FixedInt<Bits> size = v.negative() ? -v : v;
  double unit = v.negative() ? -range::kHomogeneousScale : range::kHomogeneousScale;
  T sum(0);
  for (const limbs::Limb limb : size.limb)
    for (const limbs::Limb half : {limb & 0xFFFFFFFFu, limb >> 32}) {
      if (half != 0) sum = sum + T(unit * static_cast<double>(half));
      unit *= 0x1p+32;
    }
  return sum;
}

}  // namespace crossloft::strategies
