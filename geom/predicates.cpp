#include "predicates.h"

#include "aligned_doubles.h"
#include "double_filters.h"
#include "exact_rows.h"
#include "small_integers.h"
#include "static_bounds.h"

namespace crossloft {
namespace {

using namespace filters;
using namespace small_integers;

/// Coordinates relative to an origin, as integers over 2^(low - 1075).
template <unsigned Bits>
ExactRow<Bits + 1, 0> aligned_row(int low, const Vec3& p, const Vec3& origin) {
  const auto d = [&](double to, double from) {
    return aligned::align<Bits>(to, low) - aligned::align<Bits>(from, low);
  };
  return {d(p.x, origin.x), d(p.y, origin.y), d(p.z, origin.z), FixedInt<0>(1)};
}

/// For any doubles, in the narrowest sufficient width; 0 for NaN or infinity.
template <class Shape, class... Points>
[[gnu::noinline]] int aligned_sign(const Vec3& origin, const Points&... points) {
  aligned::Span span;
  const auto include = [&](const Vec3& p) { span.include(p.x), span.include(p.y), span.include(p.z); };
  include(origin);
  (include(points), ...);
  if (!span.finite) return 0;
  return aligned::with_width(span.width(), [&]<unsigned Bits>() {
    return Shape::determinant(aligned_row<Bits>(span.low, points, origin)...).sign();
  });
}

// What the filter with this estimate and bound has left open. Its stages are out of the way of what is more
// frequent.

/// Of finite doubles that need not be integers. A column of zeros needs no more.
template <class Shape, class... Points>
[[gnu::noinline]] int undecided_doubles(const Estimate& e, double bound, const Vec3& origin,
                                        const Points&... points) {
  if (e.x == 0 || e.y == 0 || e.z == 0) return 0;
  int sign = 0;
  if (in_range(e.x, e.y, e.z) && scaled_sign<Shape>(bound, sign, origin, points...)) return sign;
  return aligned_sign<Shape>(origin, points...);
}

/// Of any doubles.
template <class Shape, class... Points>
[[gnu::noinline]] int undecided(const Estimate& e, double bound, const Vec3& origin,
                                const Points&... points) {
  if (e.x == 0 || e.y == 0 || e.z == 0) return 0;  // also the answer to a NaN beside it
  const double distance = (distance_to_integers(origin) + ... + distance_to_integers(points));
  if (!(distance >= 0)) return 0;  // NaN or infinity
  if (distance == 0 && std::max(std::max(e.x, e.y), e.z) <= kLargestDifference)
    return integer_sign<Shape>(bound, (points - origin)...);
  return undecided_doubles<Shape>(e, bound, origin, points...);
}

Vec3 flat(Vec2 p) { return {p.x, p.y, 0}; }

}  // namespace

int orient2d(Vec2 a, Vec2 b, Vec2 c) {
  const Estimate e = filters::orient2d(b - a, c - a);
  const double bound = kRoundedOrient2dError * e.size();
  if (in_range(e.x, e.y))
    if (const int sign = decide(e.det, bound)) return sign;
  return undecided<Orient2d>(e, bound, flat(a), flat(b), flat(c));
}

int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Estimate e = filters::orient3d(b - a, c - a, d - a);
  const double bound = kRoundedOrient3dError * e.size();
  if (in_range(e.x, e.y, e.z))
    if (const int sign = decide(e.det, bound)) return sign;
  return undecided<Orient3d>(e, bound, a, b, c, d);
}

int incircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const Vec2 p = a - d, q = b - d, r = c - d;
  const Estimate e = filters::incircle(p, q, r, dot(p, p), dot(q, q), dot(r, r));
  const double bound = kRoundedIncircleError * e.size();
  if (in_range(e.x, e.y))
    if (const int sign = decide(e.det, bound)) return sign;
  return undecided<InCircle>(e, bound, flat(d), flat(a), flat(b), flat(c));
}

int insphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  const Estimate s = filters::insphere(a - e, b - e, c - e, d - e);
  const double bound = kRoundedInsphereError * s.size();
  if (in_range(s.x, s.y, s.z))
    if (const int sign = decide(s.det, bound)) return sign;
  return undecided<InSphere>(s, bound, e, a, b, c, d);
}

// With a scale, differences are between 2^-100 and 2^151, or 0: the bounds hold without a test of the range.

int orient3d_after_static(const StaticBounds& bounds, const Vec3& a, const Vec3& b, const Vec3& c,
                          const Vec3& d) {
  if (bounds.orient3d == StaticBounds::kNone && bounds.scale == 0) return orient3d(a, b, c, d);
  const Vec3 p = b - a, q = c - a, r = d - a;
  const Estimate e = filters::orient3d(p, q, r);
  const double bound = kRoundedOrient3dError * e.size();
  if (in_range(e.x, e.y, e.z))
    if (const int sign = decide(e.det, bound)) return sign;
  if (bounds.scale != 0) return difference_sign<Orient3d>(bound, bounds.scale, p, q, r);
  return undecided_doubles<Orient3d>(e, bound, a, b, c, d);
}

int insphere_after_static(const StaticBounds& bounds, const Vec3& a, const Vec3& b, const Vec3& c,
                          const Vec3& d, const Vec3& e) {
  if (bounds.insphere == StaticBounds::kNone && bounds.scale == 0) return insphere(a, b, c, d, e);
  const Vec3 p = a - e, q = b - e, r = c - e, s = d - e;
  const Estimate t = filters::insphere(p, q, r, s);
  const double bound = kRoundedInsphereError * t.size();
  if (in_range(t.x, t.y, t.z))
    if (const int sign = decide(t.det, bound)) return sign;
  if (bounds.scale != 0) return difference_sign<InSphere>(bound, bounds.scale, p, q, r, s);
  return undecided_doubles<InSphere>(t, bound, e, a, b, c, d);
}

}  // namespace crossloft
