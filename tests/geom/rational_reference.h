#pragma once
/// The predicates over again in GMP rationals, written from their definitions: the referee of the tests here.

#include <gmpxx.h>

#include <array>
#include <random>
#include <vector>

#include "../../geom/homogeneous.h"
#include "../../geom/lattice.h"

namespace crossloft::reference {

using Rational3 = std::array<mpq_class, 3>;

template <unsigned Bits>
mpz_class integer(const FixedInt<Bits>& v) {
  const FixedInt<Bits> m = v.negative() ? -v : v;
  mpz_class r;
  mpz_import(r.get_mpz_t(), m.kLimbs, -1, sizeof(limbs::Limb), 0, 0, m.limb.data());
  return v.negative() ? mpz_class(-r) : r;
}

inline Rational3 exact(const LatticePoint& p) {
  if (p.is_explicit()) return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)};
  Rational3 r;
  const mpz_class w = integer(p.exact->w);
  const std::array<mpz_class, 3> numerators{integer(p.exact->x), integer(p.exact->y), integer(p.exact->z)};
  for (std::size_t k = 0; k < 3; ++k) {
    r[k] = mpq_class(numerators[k], w);
    r[k].canonicalize();
  }
  return r;
}
inline Rational3 exact(const Vec3& p) { return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)}; }

inline mpz_class big(std::int64_t v) { return mpz_class(std::to_string(v)); }
inline Rational3 exact(const LatticeVector& v) { return {big(v[0]), big(v[1]), big(v[2])}; }

inline Rational3 operator-(const Rational3& a, const Rational3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline mpq_class dot(const Rational3& a, const Rational3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Rational3 cross(const Rational3& a, const Rational3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline mpq_class volume(const Rational3& a, const Rational3& b, const Rational3& c) {
  return dot(a, cross(b, c));
}

inline int orient3d(const Rational3& a, const Rational3& b, const Rational3& c, const Rational3& d) {
  return sgn(volume(b - a, c - a, d - a));
}

/// By the power of e: positively oriented a, b, c, d have e inside iff e is above the lifted hyperplane.
inline int insphere(const Rational3& a, const Rational3& b, const Rational3& c, const Rational3& d,
                    const Rational3& e) {
  const std::array<Rational3, 4> r{a - e, b - e, c - e, d - e};
  mpq_class sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<Rational3, 3> others;
    for (std::size_t j = 0, n = 0; j < 4; ++j)
      if (j != i) others[n++] = r[j];
    const mpq_class term = dot(r[i], r[i]) * volume(others[0], others[1], others[2]);
    sum += i % 2 == 0 ? term : mpq_class(-term);
  }
  return sgn(sum);
}

/// Seen from the side of n; the points lie on a plane of that normal.
inline int orient2d(const Rational3& n, const Rational3& a, const Rational3& b, const Rational3& c) {
  return sgn(dot(n, cross(b - a, c - a)));
}

/// In the plane through the points with normal n; by the angle-free form |u|^2 (v x w) - ... along n.
inline int incircle(const Rational3& n, const Rational3& a, const Rational3& b, const Rational3& c,
                    const Rational3& d) {
  const Rational3 u = a - d, v = b - d, w = c - d;
  return sgn(mpq_class(dot(u, u) * dot(n, cross(v, w)) - dot(v, v) * dot(n, cross(u, w)) +
                       dot(w, w) * dot(n, cross(u, v))));
}

inline int side(const LatticePlane& plane, const Rational3& p) {
  return sgn(dot(exact(plane.normal), p - exact(plane.origin)));
}

}  // namespace crossloft::reference
