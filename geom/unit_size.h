#pragma once
/// Directions of any length.

#include <algorithm>
#include <cmath>

#include "vec3.h"

namespace crossloft {

/// Times the power of two that brings the largest coordinate to [0.5, 1): products of coordinates neither
/// overflow nor vanish. REQUIRES: finite.
inline Vec3 to_unit_size(Vec3 a) {
  int exponent = 0;
  std::frexp(std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)}), &exponent);
  return {std::ldexp(a.x, -exponent), std::ldexp(a.y, -exponent), std::ldexp(a.z, -exponent)};
}

}  // namespace crossloft
