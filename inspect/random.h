#pragma once
/// A random number generator that yields the same numbers everywhere; the standard's distributions don't.

#include <cstdint>

#include "../geom/vec3.h"

namespace crossloft {

/// SplitMix64 (Steele, Lea, Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform on the unit sphere: a point of the ball by rejection, scaled.
  Vec3 direction() {
    for (;;) {
      const double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
      const double square = x * x + y * y + z * z;
      if (square > 1e-4 && square <= 1) return (1 / norm({x, y, z})) * Vec3{x, y, z};
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace crossloft
