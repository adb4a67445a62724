#pragma once
/// The first stage of the lattice predicates, inline so that a triangulation can inline it, and the exact
/// stage behind it. A filter answers +-1 when that is certain and 0 when it cannot tell; `X_exact` is exact
/// alone. `X` of lattice.h is both:
///
///     if (const int sign = orient3d_filter(a, b, c, d)) return sign;
///     return orient3d_exact(a, b, c, d);
///
/// Explicit coordinates are integers |x| <= 2^50, so their differences are exact doubles and only the
/// determinant rounds (difference_filters.h). A rational coordinate is off by half an ulp <= 2^-4; then a
/// difference of two is off by 2^-3 and by half an ulp of its own, <= 2^-3 below 2^51: together <= kBlur.
/// Nothing underflows: a nonzero difference of explicit points is >= 1, and where rational points are
/// involved the bounds are >= kBlur^5 times their constants, far above the 2^-1074 an underflow can cost.

#include "difference_filters.h"
#include "lattice.h"

namespace crossloft {

/// Largest error of a difference of coordinates, at least one of them rational.
inline constexpr double kBlur = 0.25;

int side_of_plane_exact(const LatticePlane& plane, const LatticePoint& p);
int orient3d_exact(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                   const LatticePoint& d);
int insphere_exact(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d,
                   const LatticePoint& e);
int orient2d_exact(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b,
                   const LatticePoint& c);
int incircle_exact(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b,
                   const LatticePoint& c, const LatticePoint& d);

namespace filters {

template <class... Points>
bool all_explicit(const Points&... p) {
  return ((p.exact == nullptr) && ...);
}

inline Vec3 difference(const LatticePoint& p, const LatticePoint& origin) {
  return {p.x - origin.x, p.y - origin.y, p.z - origin.z};
}

/// How far differences blurred by kBlur move a determinant. Replacing one factor of a product at a time, each
/// of its terms moves by at most the sum over its factors of the factor's blur times the other factors,
/// blurred ones taken with their blur on top. det2 has 2 terms, det3 6, in-circle 6 (u v lift), in-sphere 24.
inline double blur_orient2d(const Estimate& e) { return 2 * kRoom * kBlur * (e.x + e.y + kBlur); }

/// At most: blur of x y z for the column maxima x, y, z.
inline double blur_volume(double x, double y, double z) {
  return kBlur * ((x + kBlur) * (y + kBlur) + (x + kBlur) * (z + kBlur) + (y + kBlur) * (z + kBlur));
}
inline double blur_orient3d(const Estimate& e) { return 6 * kRoom * blur_volume(e.x, e.y, e.z); }

/// A lift d.d moves by at most sum of kBlur (2 |d_k| + kBlur); here for |d_k| <= sqrt(lift), the lift itself
/// known up to 3u of its size, which kRoom covers.
inline double blur_lift(double lift) { return 3 * kBlur * (2 * std::sqrt(lift) + kBlur); }
inline double blur_incircle(const Estimate& e) {
  return 6 * kRoom *
         (kBlur * (e.x + e.y + kBlur) * e.lift + (e.x + kBlur) * (e.y + kBlur) * blur_lift(e.lift));
}
inline double blur_insphere(const Estimate& e) {
  return 24 * kRoom *
         (blur_volume(e.x, e.y, e.z) * e.lift +
          (e.x + kBlur) * (e.y + kBlur) * (e.z + kBlur) * blur_lift(e.lift));
}

/// The two coordinates that a projection along the plane's dominant axis keeps, in the order that makes a
/// counter-clockwise turn on the side of `sign` N positive.
struct Projection {
  int u, v;
  int sign;
};
inline Projection projection(const LatticeVector& normal) {
  const int k = dominant_axis(normal);
  return {(k + 1) % 3, (k + 2) % 3, normal[static_cast<std::size_t>(k)] > 0 ? 1 : -1};
}
inline Vec2 project(const Projection& pr, const LatticePoint& p, const LatticePoint& origin) {
  return {p[pr.u] - origin[pr.u], p[pr.v] - origin[pr.v]};
}
inline double squared_distance(const LatticePoint& p, const LatticePoint& origin) {
  const Vec3 d = difference(p, origin);
  return dot(d, d);
}

}  // namespace filters

inline int orient3d_filter(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                           const LatticePoint& d) {
  using namespace filters;
  const Estimate e = filters::orient3d(difference(b, a), difference(c, a), difference(d, a));
  double bound = kOrient3dError * e.size();
  if (!all_explicit(a, b, c, d)) [[unlikely]]
    bound += blur_orient3d(e);
  return decide(e.det, bound);
}

inline int insphere_filter(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                           const LatticePoint& d, const LatticePoint& e) {
  using namespace filters;
  const Estimate s =
      filters::insphere(difference(a, e), difference(b, e), difference(c, e), difference(d, e));
  double bound = kInsphereError * s.size();
  if (!all_explicit(a, b, c, d, e)) [[unlikely]]
    bound += blur_insphere(s);
  return decide(s.det, bound);
}

inline int orient2d_filter(const filters::Projection& pr, const LatticePoint& a, const LatticePoint& b,
                           const LatticePoint& c) {
  using namespace filters;
  const Estimate e = filters::orient2d(project(pr, b, a), project(pr, c, a));
  double bound = kOrient2dError * e.size();
  if (!all_explicit(a, b, c)) [[unlikely]]
    bound += blur_orient2d(e);
  return pr.sign * decide(e.det, bound);
}

inline int orient2d_filter(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b,
                           const LatticePoint& c) {
  return orient2d_filter(filters::projection(plane.normal), a, b, c);
}

inline int incircle_filter(const filters::Projection& pr, const LatticePoint& a, const LatticePoint& b,
                           const LatticePoint& c, const LatticePoint& d) {
  using namespace filters;
  const Estimate e =
      filters::incircle(project(pr, a, d), project(pr, b, d), project(pr, c, d), squared_distance(a, d),
                        squared_distance(b, d), squared_distance(c, d));
  double bound = kIncircleError * e.size();
  if (!all_explicit(a, b, c, d)) [[unlikely]]
    bound += blur_incircle(e);
  return pr.sign * decide(e.det, bound);
}

inline int incircle_filter(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b,
                           const LatticePoint& c, const LatticePoint& d) {
  return incircle_filter(filters::projection(plane.normal), a, b, c, d);
}

/// N and o are exact in doubles. Of the size |N_x d_x| + |N_y d_y| + |N_z d_z|: products 1, first sum 2,
/// whole sum 3 u; a rational point's differences to o are off by 2^-4 + 2^-3 <= kBlur each.
inline constexpr double kSideOfPlaneError = 3 * filters::kU * filters::kRoom;

/// A plane as the filter sees it, for those who ask many points.
struct PlaneInDoubles {
  Vec3 normal, origin;
};
inline PlaneInDoubles in_doubles(const LatticePlane& plane) {
  const auto vec3 = [](const LatticeVector& v) {
    return Vec3{static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
  };
  return {vec3(plane.normal), vec3(plane.origin)};
}

inline int side_of_plane_filter(const PlaneInDoubles& plane, const LatticePoint& p) {
  const Vec3 &n = plane.normal, &o = plane.origin;
  const double tx = n.x * (p.x - o.x), ty = n.y * (p.y - o.y), tz = n.z * (p.z - o.z);
  double bound = kSideOfPlaneError * (std::fabs(tx) + std::fabs(ty) + std::fabs(tz));
  if (!p.is_explicit()) [[unlikely]]
    bound += kBlur * filters::kRoom * (std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z));
  return filters::decide(tx + ty + tz, bound);
}
inline int side_of_plane_filter(const LatticePlane& plane, const LatticePoint& p) {
  return side_of_plane_filter(in_doubles(plane), p);
}

}  // namespace crossloft
