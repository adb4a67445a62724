#pragma once
/// The common unit of a predicate's doubles, for strategies on integers: coordinates are multiples of a power
/// of two, weights of its square.

#include "../aligned_doubles.h"
#include "../vec2.h"
#include "../weighted_point.h"

namespace crossloft::strategies {

/// Exponents as in aligned::Parts: e stands for 2^(e - kBias), so the square of the unit 2^(low - kBias) has
/// exponent 2 low - kBias.
struct AlignedUnit {
  static constexpr int kBias = 1075;
  int low = 0;
  int bits = 0;  ///< coordinates are below 2^bits units, weights below 2^(2 bits) squares of it
  bool finite = true;

  int weight_low() const { return 2 * low - kBias; }
};

/// Collects the doubles of one call.
class UnitBuilder {
 public:
  void include(Vec2 p) { coordinates_.include(p.x), coordinates_.include(p.y); }
  void include(const Vec3& p) { include(Vec2{p.x, p.y}), coordinates_.include(p.z); }
  void include(const WeightedPoint& p) { include(p.position), weights_.include(p.weight); }

  AlignedUnit unit() const {
    const int low = std::min(coordinates_.low, (weights_.low + AlignedUnit::kBias) >> 1);  // rounds down
    AlignedUnit unit{low, coordinates_.high - low, coordinates_.finite && weights_.finite};
    if (weights_.width() > 0) unit.bits = std::max(unit.bits, (weights_.high - unit.weight_low() + 1) / 2);
    return unit;
  }

 private:
  aligned::Span coordinates_, weights_;
};

template <class... Points>
AlignedUnit unit_of(const Points&... points) {
  UnitBuilder builder;
  (builder.include(points), ...);
  return builder.unit();
}

}  // namespace crossloft::strategies
