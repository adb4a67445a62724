#pragma once
/// The first stage of the power tests (weighted_predicates.h), inline for triangulations of weighted points:
/// +-1 when that is certain, 0 when it cannot tell.
///
/// Relative to the last point, a lift is |d|^2 - v, v the difference of the weights. It may cancel, so its
/// error is measured by L, the largest computed |d|^2 + |v|: |d|^2 is off by 5 of its own size
/// (double_filters.h), v by 1, the difference of the two by 1 of L more: 6. The rest is as for in-sphere;
/// notation as there. L exceeds the square of each entry, so its least size is theirs; with its largest
/// bounded too, the argument of double_filters.h about overflow and underflow holds as it stands.

#include "double_filters.h"
#include "weighted_point.h"

namespace crossloft {

namespace filters {

/// Above the lift of three entries of kLargest.
inline constexpr double kLargestLift = 0x1p+302;

/// Minors 2 : 8, times lift 2 : 8 + 2*6 + 2 = 22; two terms 4 : 48; three 6 : 48 + 22 + 6.
inline constexpr double kPower2dError = 76 * kU * kRoom;
/// det3 6 : 46, times lift 6 : 46 + 6*6 + 6 = 88; pairs 12 : 188; all 24 : 376 + 24.
inline constexpr double kPower3dError = 400 * kU * kRoom;

/// A point relative to an origin: difference, lift, and the lift's size without cancellation.
struct Lifted {
  Vec3 d;
  double lift, size;
};

inline Lifted lifted(const WeightedPoint& p, const WeightedPoint& origin) {
  const Vec3 d = p.position - origin.position;
  const double square = dot(d, d), v = p.weight - origin.weight;
  return {d, square - v, square + std::fabs(v)};
}

}  // namespace filters

/// The projection along an axis, right-handed: axes (drop + 1) % 3 and (drop + 2) % 3.
constexpr Vec2 without_axis(const Vec3& v, int drop) {
  return drop == 0 ? Vec2{v.y, v.z} : drop == 1 ? Vec2{v.z, v.x} : Vec2{v.x, v.y};
}

inline int power_test_filter(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c,
                             const WeightedPoint& d, const WeightedPoint& e) {
  using filters::lifted;
  const filters::Lifted p = lifted(a, e), q = lifted(b, e), r = lifted(c, e), s = lifted(d, e);
  const filters::Estimate estimate =
      filters::insphere(p.d, q.d, r.d, s.d, p.lift, q.lift, r.lift, s.lift,
                        std::max(std::max(p.size, q.size), std::max(r.size, s.size)));
  if (!filters::in_range(estimate.x, estimate.y, estimate.z)) return 0;
  if (!(estimate.lift <= filters::kLargestLift)) return 0;
  return filters::decide(estimate.det, filters::kPower3dError * estimate.size());
}

/// In the projection along axis `drop`, lifts as in space.
inline int power_test2d_filter(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c,
                               const WeightedPoint& d, int drop) {
  const filters::Lifted p = filters::lifted(a, d), q = filters::lifted(b, d), r = filters::lifted(c, d);
  filters::Estimate estimate = filters::incircle(without_axis(p.d, drop), without_axis(q.d, drop),
                                                 without_axis(r.d, drop), p.lift, q.lift, r.lift);
  estimate.lift = std::max(std::max(p.size, q.size), r.size);
  if (!filters::in_range(estimate.x, estimate.y)) return 0;
  if (!(estimate.lift <= filters::kLargestLift)) return 0;
  return filters::decide(estimate.det, filters::kPower2dError * estimate.size());
}

}  // namespace crossloft
