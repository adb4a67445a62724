#pragma once
/// The cheapest first stage, for many predicates on one set of points: the determinant in doubles against a
/// bound known for the whole set.
///
/// Differences and lifts of points of the set, as computed, are at most those of the corners of its box,
/// since rounding is monotone. The bounds of double_filters.h and lattice_filters.h grow with the column
/// maxima and the largest lift, so with those of the box they hold for every call; what underflows is within
/// their room when the box is in range. A box that is not, or flat, has no bound: the next stage decides.
///
/// If all coordinates are multiples of one power of two and the box is small enough, no operation rounds: the
/// bound is 0 then and a determinant of 0 is true.
///
///     const StaticBounds bounds = static_bounds(points);
///     insphere(bounds, points[a], points[b], points[c], points[d], points[e]);
///
/// REQUIRES, everywhere: all points are from the set, of the same type. Answers are those of predicates.h,
/// lattice.h and weighted_predicates.h, which also are the stages behind.

#include <limits>
#include <span>

#include "inline_filters.h"
#include "lattice_filters.h"
#include "predicates.h"
#include "weighted_filters.h"
#include "weighted_predicates.h"

namespace crossloft {

struct StaticBounds {
  static constexpr double kNone = std::numeric_limits<double>::infinity();
  /// A determinant above its bound has the right sign; at 0 the evaluation is exact.
  double orient3d = kNone, insphere = kNone;
  /// A power of two that makes all coordinates integers below 2^51; 0 if there is none.
  double scale = 0;
};

/// O(n), a nanosecond or so per coordinate. `insphere` is that of the power test for weighted points.
StaticBounds static_bounds(std::span<const Vec3> points);
StaticBounds static_bounds(std::span<const LatticePoint> points);
StaticBounds static_bounds(std::span<const WeightedPoint> points);

// The further stages of the calls below.
int orient3d_after_static(const StaticBounds& bounds, const Vec3& a, const Vec3& b, const Vec3& c,
                          const Vec3& d);
int insphere_after_static(const StaticBounds& bounds, const Vec3& a, const Vec3& b, const Vec3& c,
                          const Vec3& d, const Vec3& e);

inline int orient3d(const StaticBounds& bounds, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double det = det3(b - a, c - a, d - a);
  if (std::fabs(det) > bounds.orient3d) [[likely]]
    return filters::sign_of(det);
  return bounds.orient3d == 0 ? 0 : orient3d_after_static(bounds, a, b, c, d);
}

inline int insphere(const StaticBounds& bounds, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                    const Vec3& e) {
  const double det = filters::insphere(a - e, b - e, c - e, d - e).det;
  if (std::fabs(det) > bounds.insphere) [[likely]]
    return filters::sign_of(det);
  return bounds.insphere == 0 ? 0 : insphere_after_static(bounds, a, b, c, d, e);
}

inline int orient3d(const StaticBounds& bounds, const LatticePoint& a, const LatticePoint& b,
                    const LatticePoint& c, const LatticePoint& d) {
  if constexpr (!kInlineFilters) return orient3d(a, b, c, d);
  using filters::difference;
  const double det = det3(difference(b, a), difference(c, a), difference(d, a));
  if (std::fabs(det) > bounds.orient3d) [[likely]]
    return filters::sign_of(det);
  return bounds.orient3d == 0 ? 0 : orient3d(a, b, c, d);
}

inline int insphere(const StaticBounds& bounds, const LatticePoint& a, const LatticePoint& b,
                    const LatticePoint& c, const LatticePoint& d, const LatticePoint& e) {
  if constexpr (!kInlineFilters) return insphere(a, b, c, d, e);
  using filters::difference;
  const double det =
      filters::insphere(difference(a, e), difference(b, e), difference(c, e), difference(d, e)).det;
  if (std::fabs(det) > bounds.insphere) [[likely]]
    return filters::sign_of(det);
  return bounds.insphere == 0 ? 0 : insphere(a, b, c, d, e);
}

inline int power_test(const StaticBounds& bounds, const WeightedPoint& a, const WeightedPoint& b,
                      const WeightedPoint& c, const WeightedPoint& d, const WeightedPoint& e) {
  using filters::lifted;
  const filters::Lifted p = lifted(a, e), q = lifted(b, e), r = lifted(c, e), s = lifted(d, e);
  const double det = filters::insphere(p.d, q.d, r.d, s.d, p.lift, q.lift, r.lift, s.lift, 0).det;
  if (std::fabs(det) > bounds.insphere) [[likely]]
    return filters::sign_of(det);
  return power_test(a, b, c, d, e);
}

}  // namespace crossloft
