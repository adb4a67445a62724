// The exact stage of the lattice predicates. Calls whose points are all explicit, the vast majority, take a
// path of their own, integers in as few limbs as an estimate leaves; otherwise the explicit points go first
// and the first serves as origin, with one instance for each number of rational points.

#include <array>
#include <utility>

#include "exact_rows.h"
#include "homogeneous.h"
#include "lattice_filters.h"
#include "small_integers.h"

namespace crossloft {
namespace {

constexpr unsigned kCoordinateBits = 50;
constexpr unsigned kNormalBits = 40;
constexpr unsigned kDifferenceBits = kCoordinateBits + 1;
static_assert(kLatticeLimit == std::int64_t{1} << kCoordinateBits);
static_assert(kNormalLimit == std::int64_t{1} << kNormalBits);

/// q - p for explicit p: d of an explicit q; for a rational one (X - x W, ...), where |X - x W| <= 2^51 W.
using ExplicitRow = ExactRow<kDifferenceBits, 0>;
using RationalRow = ExactRow<kDifferenceBits + kWeightBits, kWeightBits>;
/// A rational point as it is.
using FreeRow = ExactRow<kNumeratorBits, kWeightBits>;

using Axes = std::array<int, 3>;
constexpr Axes kSpace{0, 1, 2};

Axes axes_of(const filters::Projection& pr) { return {pr.u, pr.v, 3 - pr.u - pr.v}; }

const FixedInt<kNumeratorBits>& numerator(const Homogeneous& h, int axis) {
  return axis == 0 ? h.x : axis == 1 ? h.y : h.z;
}

std::int64_t integer(double coordinate) { return static_cast<std::int64_t>(coordinate); }

ExplicitRow explicit_row(const Axes& k, const LatticePoint& origin, const LatticePoint& p) {
  // Differences of explicit points are exact in doubles.
  const auto d = [&](int axis) { return FixedInt<kDifferenceBits>(integer(p[axis] - origin[axis])); };
  return {d(k[0]), d(k[1]), d(k[2]), FixedInt<0>(1)};
}

RationalRow rational_row(const Axes& k, const LatticePoint& origin, const LatticePoint& p) {
  const Homogeneous& h = *p.exact;
  const auto d = [&](int axis) {
    return FixedInt<kDifferenceBits + kWeightBits>(numerator(h, axis) -
                                                   h.w * FixedInt<kCoordinateBits>(integer(origin[axis])));
  };
  return {d(k[0]), d(k[1]), d(k[2]), h.w};
}

template <bool Rational>
auto row(const Axes& k, const LatticePoint& origin, const LatticePoint& p) {
  if constexpr (Rational) {
    return rational_row(k, origin, p);
  } else {
    return explicit_row(k, origin, p);
  }
}

FreeRow free_row(const Axes& k, const LatticePoint& p) {
  const Homogeneous& h = *p.exact;
  return {numerator(h, k[0]), numerator(h, k[1]), numerator(h, k[2]), h.w};
}

/// The arguments of a predicate with the explicit ones first, and the sign of the exchange: every predicate
/// changes its sign when two of its points change places.
template <std::size_t N>
struct Sorted {
  std::array<const LatticePoint*, N> points;
  std::size_t rational = 0;
  int sign = 1;

  explicit Sorted(const std::array<const LatticePoint*, N>& given) : points(given) {
    for (const LatticePoint* p : points) rational += p->is_explicit() ? 0 : 1;
    std::size_t first = 0;  // all before are explicit
    for (std::size_t i = 0; i < N; ++i) {
      if (!points[i]->is_explicit()) continue;
      if (i != first) {
        std::swap(points[i], points[first]);
        sign = -sign;
      }
      ++first;
    }
  }
  const LatticePoint& operator[](std::size_t i) const { return *points[i]; }
};

/// Of explicit points: `e` and `error` of the differences `rows`, which are exact integers.
template <class Shape, class... Rows>
int explicit_sign(const filters::Estimate& e, double error, const Rows&... rows) {
  const double bound = error * e.size();
  if (const int sign = filters::decide(e.det, bound)) return sign;
  return small_integers::integer_sign<Shape>(bound, rows...);
}

Vec3 difference(const Axes& k, const LatticePoint& p, const LatticePoint& origin) {
  return {p[k[0]] - origin[k[0]], p[k[1]] - origin[k[1]], p[k[2]] - origin[k[2]]};
}
Vec2 flat(const Vec3& v) { return {v.x, v.y}; }

int orient3d_explicit(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                      const LatticePoint& d) {
  using filters::difference;
  const Vec3 p = difference(b, a), q = difference(c, a), r = difference(d, a);
  return explicit_sign<small_integers::Orient3d>(filters::orient3d(p, q, r), filters::kOrient3dError, p, q,
                                                 r);
}

int insphere_explicit(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                      const LatticePoint& d, const LatticePoint& e) {
  using filters::difference;
  const Vec3 p = difference(a, e), q = difference(b, e), r = difference(c, e), s = difference(d, e);
  return explicit_sign<small_integers::InSphere>(filters::insphere(p, q, r, s), filters::kInsphereError, p, q,
                                                 r, s);
}

int orient2d_explicit(const Axes& k, const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  const Vec3 p = difference(k, b, a), q = difference(k, c, a);
  return explicit_sign<small_integers::Orient2d>(filters::orient2d(flat(p), flat(q)), filters::kOrient2dError,
                                                 p, q);
}

int incircle_explicit(const Axes& k, const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                      const LatticePoint& d) {
  const Vec3 p = difference(k, a, d), q = difference(k, b, d), r = difference(k, c, d);
  const filters::Estimate e = filters::incircle(flat(p), flat(q), flat(r), dot(p, p), dot(q, q), dot(r, r));
  return explicit_sign<small_integers::InCircle>(e, filters::kIncircleError, p, q, r);
}

template <std::size_t Rational>
int orient3d_with(const Sorted<4>& p) {
  const auto determinant =
      det3(row<(Rational >= 3)>(kSpace, p[0], p[1]), row<(Rational >= 2)>(kSpace, p[0], p[2]),
           row<(Rational >= 1)>(kSpace, p[0], p[3]));
  static_assert(decltype(determinant)::kBits <= 522);
  return p.sign * determinant.sign();
}

int orient3d_free(const Sorted<4>& p) {
  const auto determinant =
      det4(free_row(kSpace, p[0]), free_row(kSpace, p[1]), free_row(kSpace, p[2]), free_row(kSpace, p[3]));
  static_assert(decltype(determinant)::kBits <= 645);
  return -p.sign * determinant.sign();  // of rows (p, 1) the determinant is minus the one of differences
}

template <std::size_t Rational>
int insphere_with(const Sorted<5>& p) {
  // The origin comes last in the in-sphere of five points; from the first place that is an even exchange.
  const auto determinant =
      in_sphere_about(row<(Rational >= 4)>(kSpace, p[0], p[1]), row<(Rational >= 3)>(kSpace, p[0], p[2]),
                      row<(Rational >= 2)>(kSpace, p[0], p[3]), row<(Rational >= 1)>(kSpace, p[0], p[4]));
  static_assert(decltype(determinant)::kBits <= 1239);
  return p.sign * determinant.sign();
}

int insphere_free(const Sorted<5>& p) {
  const auto determinant =
      in_sphere_free(free_row(kSpace, p[0]), free_row(kSpace, p[1]), free_row(kSpace, p[2]),
                     free_row(kSpace, p[3]), free_row(kSpace, p[4]));
  static_assert(decltype(determinant)::kBits <= 1480);
  return p.sign * determinant.sign();
}

template <std::size_t Rational>
int orient2d_with(const Axes& k, const Sorted<3>& p) {
  const auto determinant =
      orientation_about(row<(Rational >= 2)>(k, p[0], p[1]), row<(Rational >= 1)>(k, p[0], p[2]));
  static_assert(decltype(determinant)::kBits <= 347);
  return p.sign * determinant.sign();
}

int orient2d_free(const Axes& k, const Sorted<3>& p) {
  const auto determinant = det3_xyw(free_row(k, p[0]), free_row(k, p[1]), free_row(k, p[2]));
  static_assert(decltype(determinant)::kBits <= 469);
  return p.sign * determinant.sign();
}

template <std::size_t Rational>
int incircle_with(const Axes& k, const Sorted<4>& p) {
  // From the first to the last of four places is an odd exchange.
  const auto determinant =
      in_circle_about(row<(Rational >= 3)>(k, p[0], p[1]), row<(Rational >= 2)>(k, p[0], p[2]),
                      row<(Rational >= 1)>(k, p[0], p[3]));
  static_assert(decltype(determinant)::kBits <= 941);
  return -p.sign * determinant.sign();
}

int incircle_free(const Axes& k, const Sorted<4>& p) {
  const auto determinant =
      in_circle_free(free_row(k, p[0]), free_row(k, p[1]), free_row(k, p[2]), free_row(k, p[3]));
  static_assert(decltype(determinant)::kBits <= 1183);
  return p.sign * determinant.sign();
}

}  // namespace

int side_of_plane_exact(const LatticePlane& plane, const LatticePoint& p) {
  const auto sum = [&](const auto& d) {
    const auto n = [&](std::size_t k) { return FixedInt<kNormalBits>(plane.normal[k]); };
    return (n(0) * d.x + n(1) * d.y + n(2) * d.z).sign();
  };
  const LatticePoint origin = make_point(plane.origin);
  return p.is_explicit() ? sum(explicit_row(kSpace, origin, p)) : sum(rational_row(kSpace, origin, p));
}

int orient3d_exact(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                   const LatticePoint& d) {
  if (filters::all_explicit(a, b, c, d)) return orient3d_explicit(a, b, c, d);
  const Sorted<4> p({&a, &b, &c, &d});
  switch (p.rational) {
    case 1:
      return orient3d_with<1>(p);
    case 2:
      return orient3d_with<2>(p);
    case 3:
      return orient3d_with<3>(p);
    default:
      return orient3d_free(p);
  }
}

int insphere_exact(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d,
                   const LatticePoint& e) {
  if (filters::all_explicit(a, b, c, d, e)) return insphere_explicit(a, b, c, d, e);
  const Sorted<5> p({&a, &b, &c, &d, &e});
  switch (p.rational) {
    case 1:
      return insphere_with<1>(p);
    case 2:
      return insphere_with<2>(p);
    case 3:
      return insphere_with<3>(p);
    case 4:
      return insphere_with<4>(p);
    default:
      return insphere_free(p);
  }
}

int orient2d_exact(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b,
                   const LatticePoint& c) {
  const filters::Projection pr = filters::projection(plane.normal);
  const Axes k = axes_of(pr);
  if (filters::all_explicit(a, b, c)) return pr.sign * orient2d_explicit(k, a, b, c);
  const Sorted<3> p({&a, &b, &c});
  switch (p.rational) {
    case 1:
      return pr.sign * orient2d_with<1>(k, p);
    case 2:
      return pr.sign * orient2d_with<2>(k, p);
    default:
      return pr.sign * orient2d_free(k, p);
  }
}

int incircle_exact(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b,
                   const LatticePoint& c, const LatticePoint& d) {
  const filters::Projection pr = filters::projection(plane.normal);
  const Axes k = axes_of(pr);
  if (filters::all_explicit(a, b, c, d)) return pr.sign * incircle_explicit(k, a, b, c, d);
  const Sorted<4> p({&a, &b, &c, &d});
  switch (p.rational) {
    case 1:
      return pr.sign * incircle_with<1>(k, p);
    case 2:
      return pr.sign * incircle_with<2>(k, p);
    case 3:
      return pr.sign * incircle_with<3>(k, p);
    default:
      return pr.sign * incircle_free(k, p);
  }
}

int compare_axis_exact(int axis, const LatticePoint& a, const LatticePoint& b) {
  if (b.is_explicit()) return -compare_axis_exact(axis, b, a);
  const Homogeneous& q = *b.exact;
  if (a.is_explicit()) return (FixedInt<kCoordinateBits>(integer(a[axis])) * q.w - numerator(q, axis)).sign();
  return (numerator(*a.exact, axis) * q.w - numerator(q, axis) * a.exact->w).sign();
}

bool equal(const LatticePoint& a, const LatticePoint& b) { return compare_lex(a, b) == 0; }

#ifndef CROSSLOFT_BENCH_STRATEGIES  // there a strategy answers: bench/pipeline/routed_predicates.cpp

int side_of_plane(const LatticePlane& plane, const LatticePoint& p) {
  if (const int sign = side_of_plane_filter(plane, p)) return sign;
  return side_of_plane_exact(plane, p);
}

int orient3d(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d) {
  if (filters::all_explicit(a, b, c, d)) return orient3d_explicit(a, b, c, d);
  if (const int sign = orient3d_filter(a, b, c, d)) return sign;
  return orient3d_exact(a, b, c, d);
}

int insphere(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d,
             const LatticePoint& e) {
  if (filters::all_explicit(a, b, c, d, e)) return insphere_explicit(a, b, c, d, e);
  if (const int sign = insphere_filter(a, b, c, d, e)) return sign;
  return insphere_exact(a, b, c, d, e);
}

int orient2d(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  if (const int sign = orient2d_filter(plane, a, b, c)) return sign;
  return orient2d_exact(plane, a, b, c);
}

int incircle(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
             const LatticePoint& d) {
  if (const int sign = incircle_filter(plane, a, b, c, d)) return sign;
  return incircle_exact(plane, a, b, c, d);
}

#endif

}  // namespace crossloft
