#pragma once
/// The in-sphere determinant for one point against many simplices: each vertex is lifted once, relative to
/// that point, and four such rows make a determinant in few operations, two at a time.
///
/// For points p with heights h (|p|^2 for the in-sphere test, |p|^2 - w for the power test) and an origin e the
/// row of p is (x, y, z, lift) = (p - e, |p - e|^2 or so, less the difference of the weights).
///
/// *The determinant.* Expanded along the column pairs (x, y) and (lift, z),
///     in-sphere = sum over pairs i < j of +-m(i, j) n(k, l), m = x_i y_j - y_i x_j, n = lift_k z_l - z_k lift_l,
/// k < l the other two rows: m and n of a pair are computed together, in the lanes of one vector.
///
/// *Its error*, in the notation of difference_filters.h, rows rounded as in double_filters.h (entries 1, lifts
/// 5 of their size): m 2 : 8; products of n 1 : 1 + 5 + 1 = 7, n 2 : 7 + 7 + 2 = 16. A product of both
/// 4 : 2*16 + 2*8 + 4 = 52; three terms in each lane 12 : (52 + 52 + 8) + 52 + 12 = 176; both lanes 24 : 376.
/// With weights (weighted_filters.h) the lift is off by 6 of its size: n 2 : 18, products 56, lanes 188, all 400.

#include <limits>

#include "double_filters.h"
#include "vec3.h"
#include "weighted_filters.h"

namespace crossloft {

namespace filters {

inline constexpr double kLiftedError = 376 * kU * kRoom;
inline constexpr double kWeightedLiftedError = 400 * kU * kRoom;

#if defined(__GNUC__)
using Lanes = double __attribute__((vector_size(16)));
inline Lanes exchanged(Lanes v) { return Lanes{v[1], v[0]}; }
#else
/// The same operations without vectors, hence the same bits.
struct Lanes {
  double v[2];
  double operator[](int lane) const { return v[lane]; }
  friend Lanes operator+(Lanes a, Lanes b) { return {{a.v[0] + b.v[0], a.v[1] + b.v[1]}}; }
  friend Lanes operator-(Lanes a, Lanes b) { return {{a.v[0] - b.v[0], a.v[1] - b.v[1]}}; }
  friend Lanes operator*(Lanes a, Lanes b) { return {{a.v[0] * b.v[0], a.v[1] * b.v[1]}}; }
};
inline Lanes exchanged(Lanes v) { return {{v[1], v[0]}}; }
#endif

}  // namespace filters

struct LiftedRow {
  filters::Lanes x_lift, y_z;

  LiftedRow() = default;
  LiftedRow(const Vec3& d, double lift) : x_lift{d.x, lift}, y_z{d.y, d.z} {}
};

/// The sign is that of insphere(p, q, r, s, origin).
inline double lifted_determinant(const LiftedRow& p, const LiftedRow& q, const LiftedRow& r, const LiftedRow& s) {
  using filters::Lanes;
  const auto minors = [](const LiftedRow& a, const LiftedRow& b) { return a.x_lift * b.y_z - a.y_z * b.x_lift; };
  const auto both = [](Lanes a, Lanes b) { return a * filters::exchanged(b); };
  const Lanes sum = (both(minors(p, q), minors(r, s)) - both(minors(p, r), minors(q, s))) +
                    both(minors(p, s), minors(q, r));
  return sum[0] + sum[1];
}

/// The box that holds a set of points, as far as bounds on differences need it.
class Extent {
 public:
  void include(const Vec3& p) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y), std::max(high_.z, p.z)};
  }
  /// The largest computed difference along each axis: rounding is monotone.
  Vec3 differences() const { return high_ - low_; }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Vec3 low_{kInfinity, kInfinity, kInfinity}, high_{-kInfinity, -kInfinity, -kInfinity};
};

/// How far lifted_determinant may be off for any five points with differences up to `largest`. The argument of
/// double_filters.h about overflow and underflow holds as it stands: it needs column maxima in range only for
/// the bound to exceed what an underflow costs. Infinite outside of that range.
inline double lifted_error(const Vec3& largest) {
  if (!filters::in_range(largest.x, largest.y, largest.z)) return std::numeric_limits<double>::infinity();
  return filters::kLiftedError * (largest.x * largest.y * largest.z * dot(largest, largest));
}

/// The same for weighted points with differences of weights up to `largest_weight`.
inline double lifted_error(const Vec3& largest, double largest_weight) {
  const double lift = dot(largest, largest) + largest_weight;
  if (!filters::in_range(largest.x, largest.y, largest.z) || !(lift <= filters::kLargestLift))
    return std::numeric_limits<double>::infinity();
  return filters::kWeightedLiftedError * (largest.x * largest.y * largest.z * lift);
}

}  // namespace crossloft
