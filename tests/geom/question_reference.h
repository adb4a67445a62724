#pragma once
/// The predicates of bench/predicate_questions.h in GMP rationals: the referee of the tests of strategies.

#include "../../bench/predicate_questions.h"
#include "rational_reference.h"

namespace crossloft::reference {

inline Rational3 exact(Vec2 p) { return exact(Vec3{p.x, p.y, 0}); }
inline const Rational3 kUp{0, 0, 1};

inline int answer(bench::Orient2d, const bench::PlanarCase& c) {
  return orient2d(kUp, exact(c[0]), exact(c[1]), exact(c[2]));
}
inline int answer(bench::Incircle, const bench::PlanarCase& c) {
  return incircle(kUp, exact(c[0]), exact(c[1]), exact(c[2]), exact(c[3]));
}
inline int answer(bench::Orient3d, const bench::SpaceCase& c) {
  return orient3d(exact(c[0].position), exact(c[1].position), exact(c[2].position), exact(c[3].position));
}
inline int answer(bench::Insphere, const bench::SpaceCase& c) {
  return insphere(exact(c[0].position), exact(c[1].position), exact(c[2].position), exact(c[3].position),
                  exact(c[4].position));
}
/// Cramer's rule for the height of the lifted hyperplane over the last point.
inline int answer(bench::PowerTest, const bench::SpaceCase& c) {
  const Rational3 origin = exact(c[4].position);
  mpq_class sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<Rational3, 3> others;
    for (std::size_t j = 0, n = 0; j < 4; ++j)
      if (j != i) others[n++] = exact(c[j].position) - origin;
    const Rational3 d = exact(c[i].position) - origin;
    const mpq_class height = dot(d, d) - mpq_class(c[i].weight) + mpq_class(c[4].weight);
    const mpq_class term = height * volume(others[0], others[1], others[2]);
    sum += i % 2 == 0 ? term : mpq_class(-term);
  }
  return sgn(sum);
}

inline int answer(bench::LatticeOrient3d, const bench::LatticeCase& c) {
  return orient3d(exact(c.points[0]), exact(c.points[1]), exact(c.points[2]), exact(c.points[3]));
}
inline int answer(bench::LatticeInsphere, const bench::LatticeCase& c) {
  return insphere(exact(c.points[0]), exact(c.points[1]), exact(c.points[2]), exact(c.points[3]),
                  exact(c.points[4]));
}
inline int answer(bench::LatticeOrient2d, const bench::LatticeCase& c) {
  return orient2d(exact(c.plane.normal), exact(c.in_plane[0]), exact(c.in_plane[1]), exact(c.in_plane[2]));
}
inline int answer(bench::LatticeIncircle, const bench::LatticeCase& c) {
  return incircle(exact(c.plane.normal), exact(c.in_plane[0]), exact(c.in_plane[1]), exact(c.in_plane[2]),
                  exact(c.in_plane[3]));
}
inline int answer(bench::SideOfPlane, const bench::LatticeCase& c) {
  return side(c.plane, exact(c.points[0]));
}
/// The common point of three planes as a rational point, then its side.
inline int answer(bench::SideOfMeet, const bench::LatticeCase& c) {
  const Rational3 a = exact(c.planes[0].normal), b = exact(c.planes[1].normal), n = exact(c.planes[2].normal);
  const mpq_class det = volume(a, b, n);
  if (det == 0) return 0;
  const auto offset = [&](std::size_t i) {
    return mpq_class(dot(exact(c.planes[i].normal), exact(c.planes[i].origin)) / det);
  };
  const Rational3 bc = cross(b, n), ca = cross(n, a), ab = cross(a, b);
  const mpq_class x = offset(0), y = offset(1), z = offset(2);
  Rational3 p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = x * bc[k] + y * ca[k] + z * ab[k];
  return side(c.planes[3], p);
}

}  // namespace crossloft::reference
