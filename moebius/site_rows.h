#pragma once
/// The lifted sites as rows, and the polynomials that decide a Moebius diagram, for any ring.
///
/// With X = x, Z = |x|^2 the distance of site m is d_m = L_m Z - 2 L_m p_m.X + L_m |p_m|^2 - M_m. Taken
/// relative to a base site b, with coordinates of the plane that start at p_b:
///     d_m - d_b = l Z - 2 (x, y).X + w,   (x, y) = L_m (p_m - p_b),  l = L_m - L_b,  w = L_m |p_m - p_b|^2 -
///     (M_m - M_b).
/// Moving the origin shears (L p, L) space and adds a linear function to the heights: no determinant below
/// notices.

#include <cstdint>

#include "../geom/determinants.h"
#include "diagram.h"

namespace crossloft {

/// Columns named as geom/determinants.h has them: z is l, w the height.
template <class T>
struct SiteRow {
  T x, y, z, w;
};

template <class T>
SiteRow<T> site_row(const MoebiusSite& m, const MoebiusSite& base) {
  const T lambda(m.lambda), dx = T(m.p.x) - T(base.p.x), dy = T(m.p.y) - T(base.p.y);
  const T x = lambda * dx, y = lambda * dy;
  return {x, y, lambda - T(base.lambda), (x * dx + y * dy) - (T(m.mu) - T(base.mu))};
}

/// The line in (X, Z) space where d_r = d_s = d_base, in the coordinates (2X, 2Y, -Z): all points q with r.q
/// = r.w, s.q = s.w. Its direction is u = r x s; m, a and b are the moments of the pairs of columns (w, z),
/// (w, x), (w, y).
template <class T>
struct PowerLine {
  T ux, uy, uz, m, a, b;

  PowerLine(const SiteRow<T>& r, const SiteRow<T>& s)
      : ux(det2(r.y, r.z, s.y, s.z)),
        uy(det2(r.z, r.x, s.z, s.x)),
        uz(det2(r.x, r.y, s.x, s.y)),
        m(det2(r.w, r.z, s.w, s.z)),
        a(det2(r.w, r.x, s.w, s.x)),
        b(det2(r.w, r.y, s.w, s.y)) {}

  /// Four times Z - |X|^2 at 2X = (m (-uy, ux) + t (ux, uy)) / n, n = ux^2 + uy^2, is -(t^2 + 4 uz t +
  /// product()) / n: the line meets the paraboloid for t = -2 uz -+ sqrt(discriminant()), entering the inside
  /// at the lower t. Vertical lines have n = 0.
  T product() const { return m * m - T(4) * (ux * b - uy * a); }
  T discriminant() const { return T(4) * (uz * uz) - product(); }
};

/// The point of the line where d_t equals the others: (2X, 2Y, -Z) = (x, y, z) / d.
template <class T>
struct PowerVertex {
  T x, y, z, d;

  PowerVertex(const PowerLine<T>& line, const SiteRow<T>& t)
      : x(line.ux * t.w - line.m * t.y + line.b * t.z),
        y(line.uy * t.w + line.m * t.x - line.a * t.z),
        z(line.uz * t.w - line.b * t.x + line.a * t.y),
        d(line.ux * t.x + line.uy * t.y + line.uz * t.z) {}

  /// Positive inside the paraboloid, Z > |X|^2.
  T inside() const { return -(x * x + y * y + T(4) * (z * d)); }
  /// Positive if Z - |X|^2 rises along the line from here to where d_t is larger. That is along u iff d < 0,
  /// since d_t grows by -t.u = -d; the slope along u is -(4 uz d + 2 ux x + 2 uy y) / d, so the sign of d
  /// cancels.
  T rise(const PowerLine<T>& line) const { return T(2) * (line.uz * d) + (line.ux * x + line.uy * y); }
};

/// The curve l |x|^2 - 2 (x, y).x + w = 0 of a row and its base. Positive if it is more than a point, for l
/// != 0: its squared radius times l^2.
template <class T>
T circle_extent(const SiteRow<T>& r) {
  return (r.x * r.x + r.y * r.y) - r.w * r.z;
}
/// Positive if d_s > d_r = d_base above the centre of that circle, on its own plane in (X, Z) space: times
/// l^2.
template <class T>
T circle_clearance(const SiteRow<T>& r, const SiteRow<T>& s) {
  const T squared = r.x * r.x + r.y * r.y;
  return s.z * (T(2) * squared - r.w * r.z) + r.z * (s.w * r.z - T(2) * (s.x * r.x + s.y * r.y));
}

}  // namespace crossloft
