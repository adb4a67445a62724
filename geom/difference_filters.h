#pragma once
/// What the filters of lattice points (lattice_filters.h) and of plain doubles (predicates.cpp) share: the
/// determinants on coordinate differences in doubles, and bounds of what their evaluation rounds away.
///
/// Notation: u = 2^-53; every operation is exact times (1 + d), |d| <= u. Differences enter exactly as they
/// are, with column maxima X, Y, Z; `a : b` beside a value says: size at most a, error at most b, in units of
/// the product of the maxima and, for errors, of u to first order. The constants include the higher orders
/// and the roundings of the bound itself; tests/geom/filters_test.cpp recomputes them in rationals.

#include <algorithm>
#include <cmath>

#include "determinants.h"
#include "fp_check.h"
#include "vec2.h"
#include "vec3.h"

namespace crossloft::filters {

inline constexpr double kU = 0x1p-53;
/// Room for the higher orders of u and for the at most eight roundings of a bound: (1 + u)^20 < kRoom.
inline constexpr double kRoom = 1 + 0x1p-48;

/// det2: products 1 : 1, difference 2 : 1 + 1 + 2.
inline constexpr double kOrient2dError = 4 * kU * kRoom;
/// det3: minors 2 : 4, times z 2 : 4 + 2 = 6; first two terms 4 : 12 + 4 = 16; all three 6 : 16 + 6 + 6.
inline constexpr double kOrient3dError = 28 * kU * kRoom;
/// Lifts (size L, the largest computed one): squares 1, first sum 2, whole sum 3 of their own size, all terms
/// being positive. Minors 2 : 4, times lift 2 : 4 + 2*3(+2) = 12; two terms 4 : 28; three 6 : 28 + 12 + 6.
inline constexpr double kIncircleError = 46 * kU * kRoom;
/// det3 6 : 28, times lift 6 : 28 + 6*3 + 6 = 52; pairs 12 : 104 + 12 = 116; all 24 : 232 + 24.
inline constexpr double kInsphereError = 256 * kU * kRoom;

/// The sign of a determinant known to within `bound`; 0 if that does not tell, also for NaN.
inline int decide(double det, double bound) {
  return static_cast<int>(det > bound) - static_cast<int>(det < -bound);
}

/// Of a determinant that is not 0; no branch, which half of the signs would mispredict.
inline int sign_of(double det) { return det > 0 ? 1 : -1; }

inline double largest(double a, double b) { return std::max(std::fabs(a), std::fabs(b)); }
inline double largest(double a, double b, double c) { return std::max(largest(a, b), std::fabs(c)); }
inline double largest(double a, double b, double c, double d) {
  return std::max(largest(a, b), largest(c, d));
}

/// A determinant, the largest differences of each column and the largest lift; unused ones stay 1.
struct Estimate {
  double det;
  double x, y, z = 1, lift = 1;
  double size() const { return x * y * z * lift; }
};

inline Estimate orient2d(Vec2 p, Vec2 q) {
  return {det2(p.x, p.y, q.x, q.y), largest(p.x, q.x), largest(p.y, q.y)};
}

inline Estimate orient3d(const Vec3& p, const Vec3& q, const Vec3& r) {
  return {det3(p, q, r), largest(p.x, q.x, r.x), largest(p.y, q.y, r.y), largest(p.z, q.z, r.z)};
}

/// The lifts come from outside: they are |.|^2 in space even where the circle lies in a projected plane.
inline Estimate incircle(Vec2 p, Vec2 q, Vec2 r, double lp, double lq, double lr) {
  const double det =
      det2(q.x, q.y, r.x, r.y) * lp - det2(p.x, p.y, r.x, r.y) * lq + det2(p.x, p.y, q.x, q.y) * lr;
  return {det, largest(p.x, q.x, r.x), largest(p.y, q.y, r.y), 1, std::max(std::max(lp, lq), lr)};
}

/// The lifts come from outside, the largest last: they may be sums with weights.
inline Estimate insphere(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s, double lp, double lq,
                         double lr, double ls, double largest_lift) {
  const double pq = det2(p.x, p.y, q.x, q.y), qr = det2(q.x, q.y, r.x, r.y), rs = det2(r.x, r.y, s.x, s.y);
  const double sp = det2(s.x, s.y, p.x, p.y), pr = det2(p.x, p.y, r.x, r.y), qs = det2(q.x, q.y, s.x, s.y);
  const double pqr = (p.z * qr - q.z * pr) + r.z * pq, qrs = (q.z * rs - r.z * qs) + s.z * qr;
  const double rsp = (r.z * sp + s.z * pr) + p.z * rs, spq = (s.z * pq + p.z * qs) + q.z * sp;
  return {(lp * qrs - lq * rsp) + (lr * spq - ls * pqr), largest(p.x, q.x, r.x, s.x),
          largest(p.y, q.y, r.y, s.y), largest(p.z, q.z, r.z, s.z), largest_lift};
}

inline Estimate insphere(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
  const double lp = dot(p, p), lq = dot(q, q), lr = dot(r, r), ls = dot(s, s);
  return insphere(p, q, r, s, lp, lq, lr, ls, std::max(std::max(lp, lq), std::max(lr, ls)));
}

}  // namespace crossloft::filters
