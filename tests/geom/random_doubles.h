#pragma once
/// Random doubles for the tests of predicates on arbitrary ones.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

#include "../../geom/vec3.h"

namespace crossloft {

/// Random doubles with exponents in a band; every bit comes from the engine alone.
class Doubles {
 public:
  explicit Doubles(std::uint64_t seed) : engine_(seed) {}
  std::size_t index(std::size_t size) { return engine_() % size; }
  double value(int low, int high) {
    const auto spread = static_cast<std::uint64_t>(high - low + 1);
    const double m = 1 + static_cast<double>(engine_() >> 12) * 0x1p-52;
    const double v = std::ldexp(m, low + static_cast<int>(engine_() % spread));
    return engine_() % 2 == 0 ? v : -v;
  }
  Vec3 vec(int low, int high) { return {value(low, high), value(low, high), value(low, high)}; }
  /// A neighbour at most two ulps off in every coordinate.
  double nudged(double v) {
    const std::size_t steps = index(5);
    for (std::size_t i = 2; i < steps; ++i) v = std::nextafter(v, 1e308);
    for (std::size_t i = steps; i < 2; ++i) v = std::nextafter(v, -1e308);
    return v;
  }
  Vec3 nudged(Vec3 v) { return {nudged(v.x), nudged(v.y), nudged(v.z)}; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace crossloft
