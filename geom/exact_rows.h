#pragma once
/// Orientation and in-sphere determinants of homogeneous integer points (X, Y, Z) / W, W > 0, in the
/// narrowest widths known: shared by the lattice predicates and those on doubles. For geom's sources only.
///
/// With a point of W = 1 among them all others are taken relative to it (d = X - x W) and one row falls away.
/// The lift of a row is X^2 + Y^2 + Z^2, W^2 times |p|^2. In the determinant with rows
/// (X W, Y W, Z W, X^2 + Y^2 + Z^2, W^2) every row but the lift's own is divided by W while expanding along
/// the lift, and multiplied back at the end: the products stay short until the last step.

#include "determinants.h"
#include "fixed_int.h"

namespace crossloft {

/// In a plane, x and y are the two kept coordinates and z is unused by the determinants.
template <unsigned Bits, unsigned WeightBits, std::size_t Cap = kNoCap>
struct ExactRow {
  static constexpr unsigned kWeightBits = WeightBits;
  FixedInt<Bits, Cap> x, y, z;
  FixedInt<WeightBits, Cap> w;

  /// W^2 times the squared length.
  auto lift() const { return x * x + y * y + z * z; }
};

/// a * w, for a weight known to be 1 by its type just a.
template <unsigned A, unsigned WeightBits, std::size_t Cap>
auto times_weight(const FixedInt<A, Cap>& a, const FixedInt<WeightBits, Cap>& w) {
  if constexpr (WeightBits == 0) {
    return a;
  } else {
    return a * w;
  }
}

/// Rows of (x, y, w): the determinant of orient2d for points without a common origin.
template <class R, class S, class T>
auto det3_xyw(const R& r, const S& s, const T& t) {
  return det2(s.x, s.y, t.x, t.y) * r.w - det2(r.x, r.y, t.x, t.y) * s.w + det2(r.x, r.y, s.x, s.y) * t.w;
}

/// Rows relative to a common origin; orientation of (origin, p, q) or (origin, p, q, r).
template <class P, class Q>
auto orientation_about(const P& p, const Q& q) {
  return det2(p.x, p.y, q.x, q.y);
}

/// In-circle of (p, q, r, origin): positive if the origin is inside a counter-clockwise p, q, r.
template <class P, class Q, class R>
auto in_circle_about(const P& p, const Q& q, const R& r) {
  const auto term = [](const auto& lifted, const auto& a, const auto& b) {
    return times_weight(times_weight(lifted.lift() * det2(a.x, a.y, b.x, b.y), a.w), b.w);
  };
  return term(p, q, r) - term(q, p, r) + term(r, p, q);
}

/// In-sphere of (p, q, r, s, origin): positive if the origin is inside a positively oriented p, q, r, s. The
/// six minors are shared by the four 3x3 determinants.
template <class P, class Q, class R, class S>
auto in_sphere_about(const P& p, const Q& q, const R& r, const S& s) {
  const auto minor = [](const auto& a, const auto& b) { return det2(a.x, a.y, b.x, b.y); };
  // One declaration each: the widths, hence the types, differ.
  const auto pq = minor(p, q);
  const auto pr = minor(p, r);
  const auto ps = minor(p, s);
  const auto qr = minor(q, r);
  const auto qs = minor(q, s);
  const auto rs = minor(r, s);
  const auto term = [](const auto& lifted, const auto& det, const auto& a, const auto& b, const auto& c) {
    return times_weight(times_weight(times_weight(lifted.lift() * det, a.w), b.w), c.w);
  };
  return (term(p, rs * q.z - qs * r.z + qr * s.z, q, r, s) -
          term(q, rs * p.z - ps * r.z + pr * s.z, p, r, s)) +
         (term(r, qs * p.z - ps * q.z + pq * s.z, p, q, s) -
          term(s, qr * p.z - pr * q.z + pq * r.z, p, q, r));
}

/// In-circle of four points without a common origin.
template <class Row>
auto in_circle_free(const Row& p, const Row& q, const Row& r, const Row& s) {
  const auto term = [](const Row& lifted, const Row& a, const Row& b, const Row& c) {
    return lifted.lift() * (a.w * b.w * c.w) * det3_xyw(a, b, c);
  };
  return (term(p, q, r, s) - term(q, p, r, s)) + (term(r, p, q, s) - term(s, p, q, r));
}

/// In-sphere of five points without a common origin.
template <class Row>
auto in_sphere_free(const Row& p, const Row& q, const Row& r, const Row& s, const Row& t) {
  const auto term = [](const Row& lifted, const Row& a, const Row& b, const Row& c, const Row& d) {
    return lifted.lift() * ((a.w * b.w) * (c.w * d.w)) * det4(a, b, c, d);
  };
  return ((term(p, q, r, s, t) - term(q, p, r, s, t)) + (term(r, p, q, s, t) - term(s, p, q, r, t))) +
         term(t, p, q, r, s);
}

}  // namespace crossloft
