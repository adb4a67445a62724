#pragma once
/// A point with a weight: a sphere of squared radius `weight`, which may be negative.

#include "vec3.h"

namespace crossloft {

/// The power distance of x from it is |x - position|^2 - weight.
struct WeightedPoint {
  Vec3 position;
  double weight = 0;
};

}  // namespace crossloft
