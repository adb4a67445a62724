#pragma once
/// The first stage of the predicates on arbitrary doubles, inline for triangulations of plain points: +-1
/// when that is certain, 0 when it cannot tell (then predicates.h has the answer), also for NaN and
/// infinities.
///
/// Unlike on the lattice a difference rounds, to within u of its computed size, which all bounds below take
/// as an error of the entries; notation as in difference_filters.h. Maxima outside kSmallest..kLargest are
/// left to the exact stage. Inside, nothing overflows (24 terms of at most 3 * 2^750), and an underflow costs
/// 2^-1075 times at most three more factors and a lift, in less than 100 operations: below 2^-600, while the
/// room in a bound is above 2^-48 * 46 u * 2^-500.

#include "difference_filters.h"

namespace crossloft {

namespace filters {

inline constexpr double kSmallest = 0x1p-100;
inline constexpr double kLargest = 0x1p+150;

/// Entries 1 : 1, products 1 : 3, difference 2 : 6 + 2.
inline constexpr double kRoundedOrient2dError = 8 * kU * kRoom;
/// Minors 2 : 8, times z 2 : 8 + 2 + 2 = 12; two terms 4 : 28; three 6 : 28 + 12 + 6.
inline constexpr double kRoundedOrient3dError = 46 * kU * kRoom;
/// Squares 3 of their own size, a lift 4 in the plane (5 in space); minors 2 : 8, times lift
/// 2 : 8 + 2*4 + 2 = 18; two terms 4 : 40; three 6 : 40 + 18 + 6.
inline constexpr double kRoundedIncircleError = 64 * kU * kRoom;
/// det3 6 : 46, times lift 6 : 46 + 6*5 + 6 = 82; pairs 12 : 176; all 24 : 352 + 24.
inline constexpr double kRoundedInsphereError = 376 * kU * kRoom;

inline bool in_range(double a, double b) { return std::min(a, b) >= kSmallest && std::max(a, b) <= kLargest; }
inline bool in_range(double a, double b, double c) {
  return std::min(std::min(a, b), c) >= kSmallest && std::max(std::max(a, b), c) <= kLargest;
}

}  // namespace filters

inline int orient2d_filter(Vec2 a, Vec2 b, Vec2 c) {
  const filters::Estimate e = filters::orient2d(b - a, c - a);
  if (!filters::in_range(e.x, e.y)) return 0;
  return filters::decide(e.det, filters::kRoundedOrient2dError * e.size());
}

inline int orient3d_filter(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const filters::Estimate e = filters::orient3d(b - a, c - a, d - a);
  if (!filters::in_range(e.x, e.y, e.z)) return 0;
  return filters::decide(e.det, filters::kRoundedOrient3dError * e.size());
}

inline int incircle_filter(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const Vec2 p = a - d, q = b - d, r = c - d;
  const filters::Estimate e = filters::incircle(p, q, r, dot(p, p), dot(q, q), dot(r, r));
  if (!filters::in_range(e.x, e.y)) return 0;
  return filters::decide(e.det, filters::kRoundedIncircleError * e.size());
}

inline int insphere_filter(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  const filters::Estimate s = filters::insphere(a - e, b - e, c - e, d - e);
  if (!filters::in_range(s.x, s.y, s.z)) return 0;
  return filters::decide(s.det, filters::kRoundedInsphereError * s.size());
}

}  // namespace crossloft
