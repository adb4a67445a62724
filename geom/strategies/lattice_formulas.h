#pragma once
/// The predicates of the lattice model as formulas over any numbers. Rational points enter in one of two
/// ways, as the arithmetic likes (arithmetic.h):
///   - affine: each coordinate is a number (with its error, or a fraction); the formulas are those of
///   doubles;
///   - homogeneous: numerators and weight. With an explicit point among them as origin the rows are
///     (X - x W, ..., W), otherwise all points enter as they are (exact_rows.h says how rows are combined).

#include <array>
#include <cstddef>
#include <utility>

#include "../homogeneous.h"
#include "../lattice_filters.h"
#include "formulas.h"

namespace crossloft::strategies {

/// The order of axes: of a projection, found at run time, or all as they are, known to the compiler.
using Axes = std::array<int, 3>;
struct SpaceAxes {
  constexpr int operator[](std::size_t k) const { return static_cast<int>(k); }
};
inline constexpr SpaceAxes kSpace;

template <class T>
struct HomogeneousRow {
  T x, y, z;
  Weight<T> w;
  auto lift() const { return x * x + y * y + z * z; }
};
template <class T>
struct FreeRow {
  T x, y, z, w;
  auto lift() const { return x * x + y * y + z * z; }
};

inline const FixedInt<kNumeratorBits>& numerator(const Homogeneous& h, int axis) {
  return axis == 0 ? h.x : axis == 1 ? h.y : h.z;
}

template <class A, class K>
SpaceRow<typename A::Number> affine_row(const K& k, const LatticePoint& p, const LatticePoint& origin) {
  const auto d = [&](int axis) { return A::coordinate(p, axis) - A::coordinate(origin, axis); };
  return {d(k[0]), d(k[1]), d(k[2]), {}};
}
/// Of explicit points; the differences are integers below 2^51.
template <class A, class K>
SpaceRow<typename A::Number> explicit_row(const K& k, const LatticePoint& p, const LatticePoint& origin) {
  const auto d = [&](int axis) { return A::from_integer(p[axis] - origin[axis]); };
  return {d(k[0]), d(k[1]), d(k[2]), {}};
}
/// The origin is explicit.
template <class A, class K>
HomogeneousRow<typename A::Number> homogeneous_row(const K& k, const LatticePoint& p,
                                                   const LatticePoint& origin) {
  if (p.is_explicit()) {
    auto r = explicit_row<A>(k, p, origin);
    return {std::move(r.x), std::move(r.y), std::move(r.z), {A::from_integer(1)}};
  }
  auto w = A::from_fixed(p.exact->w);
  const auto d = [&](int axis) {
    return A::from_fixed(numerator(*p.exact, axis)) - w * A::from_integer(origin[axis]);
  };
  auto x = d(k[0]), y = d(k[1]), z = d(k[2]);
  return {std::move(x), std::move(y), std::move(z), {std::move(w)}};
}
template <class A, class K>
FreeRow<typename A::Number> free_row(const K& k, const LatticePoint& p) {
  const auto n = [&](int axis) { return A::from_fixed(numerator(*p.exact, axis)); };
  return {n(k[0]), n(k[1]), n(k[2]), A::from_fixed(p.exact->w)};
}

/// The arguments of a predicate with an explicit point, if there is one, at `place`; an exchange of two
/// points changes the sign.
template <std::size_t N>
struct Arranged {
  std::array<const LatticePoint*, N> points;
  int sign = 1;
  std::size_t explicit_count = 0;

  Arranged(const std::array<const LatticePoint*, N>& given, std::size_t place) : points(given) {
    std::size_t at = N;
    for (std::size_t i = 0; i < N; ++i)
      if (points[i]->is_explicit()) at = explicit_count++ == 0 || i == place ? i : at;
    if (at == N || at == place) return;
    std::swap(points[at], points[place]);
    sign = -1;
  }
  const LatticePoint& operator[](std::size_t i) const { return *points[i]; }
};

/// about(row) with the rows relative to the point at `place`, or free(row) if no point is explicit.
template <class A, std::size_t N, class K, class About, class Free>
int lattice_sign(const std::array<const LatticePoint*, N>& points, std::size_t place, const K& k,
                 const About& about, const Free& free) {
  if constexpr (!A::kHomogeneous) {
    return A::sign(about([&](std::size_t i) { return affine_row<A>(k, *points[i], *points[place]); }));
  } else {
    const Arranged<N> p(points, place);
    const auto signed_as = [&](int verdict) { return verdict == 2 ? verdict : p.sign * verdict; };
    if (p.explicit_count == N)
      return signed_as(A::sign(about([&](std::size_t i) { return explicit_row<A>(k, p[i], p[place]); })));
    if (p.explicit_count > 0)
      return signed_as(A::sign(about([&](std::size_t i) { return homogeneous_row<A>(k, p[i], p[place]); })));
    return A::sign(free([&](std::size_t i) { return free_row<A>(k, p[i]); }));
  }
}

template <class A>
int orient3d(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d) {
  return lattice_sign<A>(
      std::array{&a, &b, &c, &d}, 0, kSpace, [](const auto& row) { return det3(row(1), row(2), row(3)); },
      // Of rows (p, 1) the determinant is minus the one of differences: one exchange of rows.
      [](const auto& row) { return det4(row(1), row(0), row(2), row(3)); });
}

template <class A>
int insphere(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d,
             const LatticePoint& e) {
  return lattice_sign<A>(
      std::array{&a, &b, &c, &d, &e}, 4, kSpace,
      [](const auto& row) { return in_sphere_about(row(0), row(1), row(2), row(3)); },
      [](const auto& row) { return in_sphere_free(row(0), row(1), row(2), row(3), row(4)); });
}

inline Axes axes_of(const filters::Projection& pr) { return {pr.u, pr.v, 3 - pr.u - pr.v}; }
inline int times_sign(int sign, int verdict) { return verdict == 2 ? verdict : sign * verdict; }

template <class A>
int orient2d(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  const filters::Projection pr = filters::projection(plane.normal);
  return times_sign(pr.sign, lattice_sign<A>(
                                 std::array{&a, &b, &c}, 0, axes_of(pr),
                                 [](const auto& row) { return orientation_about(row(1), row(2)); },
                                 [](const auto& row) { return det3_xyw(row(0), row(1), row(2)); }));
}

template <class A>
int incircle(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
             const LatticePoint& d) {
  const filters::Projection pr = filters::projection(plane.normal);
  return times_sign(pr.sign,
                    lattice_sign<A>(
                        std::array{&a, &b, &c, &d}, 3, axes_of(pr),
                        [](const auto& row) { return in_circle_about(row(0), row(1), row(2)); },
                        [](const auto& row) { return in_circle_free(row(0), row(1), row(2), row(3)); }));
}

template <class A>
SpaceRow<typename A::Number> normal_row(const LatticePlane& plane) {
  const auto n = [&](std::size_t k) { return A::from_integer(static_cast<double>(plane.normal[k])); };
  return {n(0), n(1), n(2), {}};
}

template <class N, class D>
auto dot3(const N& n, const D& d) {
  return n.x * d.x + n.y * d.y + n.z * d.z;
}

template <class A>
int side_of_plane(const LatticePlane& plane, const LatticePoint& p) {
  const auto n = normal_row<A>(plane);
  const LatticePoint origin = make_point(plane.origin);
  if (p.is_explicit()) return A::sign(dot3(n, explicit_row<A>(kSpace, p, origin)));
  if constexpr (A::kHomogeneous) {
    return A::sign(dot3(n, homogeneous_row<A>(kSpace, p, origin)));
  } else {
    return A::sign(dot3(n, affine_row<A>(kSpace, p, origin)));
  }
}

/// plane_predicates.cpp derives the formula.
template <class A>
int side_of_meet(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c, const LatticePlane& q) {
  const auto na = normal_row<A>(a), nb = normal_row<A>(b), nc = normal_row<A>(c), nq = normal_row<A>(q);
  const int orientation = A::sign(det3(na, nb, nc));
  if (orientation == 0 || orientation == 2) return orientation;
  const LatticePoint origin = make_point(q.origin);
  const auto offset = [&](const LatticePlane& plane, const auto& n) {
    return dot3(n, explicit_row<A>(kSpace, make_point(plane.origin), origin));
  };
  const auto value =
      offset(a, na) * det3(nb, nc, nq) + offset(b, nb) * det3(nc, na, nq) + offset(c, nc) * det3(na, nb, nq);
  return times_sign(orientation, A::sign(value));
}

}  // namespace crossloft::strategies
