#include "weighted_predicates.h"

#include <array>

#include "aligned_doubles.h"
#include "exact_rows.h"
#include "weighted_filters.h"

namespace crossloft {
namespace {

/// A row relative to the last point, for the determinants of exact_rows.h; the lift has the weight in it.
template <unsigned Bits>
struct PowerRow {
  static constexpr unsigned kWeightBits = 0;
  using Difference = FixedInt<Bits + 1>;
  using Lift = FixedInt<2 * Bits + 5>;
  Difference x, y, z;
  FixedInt<0> w{1};  ///< the homogeneous one
  Lift height;

  const Lift& lift() const { return height; }
};

/// The unit of the coordinates as an exponent (aligned::Parts), and the bits that hold all numbers: a
/// coordinate in `bits`, a weight in twice as many.
struct Unit {
  int low = 0;
  int bits = 0;
  bool finite = true;
};

/// Weights are in squares of the unit: exponent e stands for 2^(e - kBias), the unit's square for
/// 2^(2 low - 2 kBias), so weights are counted from exponent 2 low - kBias on.
constexpr int kBias = 1075;
constexpr int weight_low(int low) { return 2 * low - kBias; }

// The largest weight over the smallest unit.
static_assert((1024 + kBias - weight_low(1) + 1) / 2 <= static_cast<int>(aligned::kEverything));

template <std::size_t N>
Unit unit_of(const std::array<WeightedPoint, N>& points) {
  aligned::Span coordinates, weights;
  for (const WeightedPoint& p : points) {
    for (const double v : {p.position.x, p.position.y, p.position.z}) coordinates.include(v);
    weights.include(p.weight);
  }
  const int low = std::min(coordinates.low, (weights.low + kBias) >> 1);  // rounds down
  int bits = coordinates.high - low;
  if (weights.width() > 0) bits = std::max(bits, (weights.high - weight_low(low) + 1) / 2);
  return {low, bits, coordinates.finite && weights.finite};
}

template <unsigned Bits>
PowerRow<Bits> power_row(int low, const WeightedPoint& p, const WeightedPoint& origin,
                         const std::array<int, 3>& axes) {
  const auto coordinate = [](const Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; };
  const auto d = [&](int axis) {
    return aligned::align<Bits>(coordinate(p.position, axis), low) -
           aligned::align<Bits>(coordinate(origin.position, axis), low);
  };
  const auto weight = [&](double w) { return aligned::align<2 * Bits>(w, weight_low(low)); };
  PowerRow<Bits> row{d(axes[0]), d(axes[1]), d(axes[2]), FixedInt<0>(1), {}};
  row.height = typename PowerRow<Bits>::Lift(row.x * row.x + row.y * row.y + row.z * row.z -
                                             (weight(p.weight) - weight(origin.weight)));
  return row;
}

constexpr std::array<int, 3> kSpace{0, 1, 2};
constexpr std::array<int, 3> axes_off(int drop) { return {(drop + 1) % 3, (drop + 2) % 3, drop}; }

/// evaluate(row), row(i) that of point i relative to the last, in the narrowest sufficient width; 0 for NaN
/// or infinity.
template <std::size_t N, class Evaluate>
int sign_of(const std::array<WeightedPoint, N>& points, const std::array<int, 3>& axes,
            const Evaluate& evaluate) {
  const Unit unit = unit_of(points);
  if (!unit.finite) return 0;
  return aligned::with_width(unit.bits, [&]<unsigned Bits>() {
    return evaluate([&](std::size_t i) { return power_row<Bits>(unit.low, points[i], points[N - 1], axes); });
  });
}

/// An axis along which the places differ, -1 if they are equal.
int axis_between(const Vec3& a, const Vec3& b) {
  return a.x != b.x ? 0 : a.y != b.y ? 1 : a.z != b.z ? 2 : -1;
}

}  // namespace

int power_test(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c, const WeightedPoint& d,
               const WeightedPoint& e) {
  if (const int sign = power_test_filter(a, b, c, d, e)) return sign;
  return sign_of(std::array{a, b, c, d, e}, kSpace,
                 [](const auto& row) { return in_sphere_about(row(0), row(1), row(2), row(3)).sign(); });
}

int power_test2d(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c,
                 const WeightedPoint& d, int drop) {
  if (const int sign = power_test2d_filter(a, b, c, d, drop)) return sign;
  return sign_of(std::array{a, b, c, d}, axes_off(drop),
                 [](const auto& row) { return in_circle_about(row(0), row(1), row(2)).sign(); });
}

int power_test1d(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c) {
  const int axis = axis_between(a.position, b.position);
  if (axis < 0) return 0;
  // Relative to c the line through (x, h) of a and b is at height (ha xb - hb xa) / (xb - xa) over c.
  return sign_of(std::array{a, b, c}, {axis, (axis + 1) % 3, (axis + 2) % 3}, [](const auto& row) {
    const auto p = row(0), q = row(1);
    return det2(p.lift(), p.x, q.lift(), q.x).sign() * (q.x - p.x).sign();
  });
}

}  // namespace crossloft
