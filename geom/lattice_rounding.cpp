#include "lattice_rounding.h"

#include <cmath>

namespace crossloft {

Vec3 real(const LatticeVector& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

std::array<std::int64_t, 2> nearest_coordinates(const LatticePlane& plane, Vec3 target) {
  const Vec3 e1 = real(plane.e1), e2 = real(plane.e2), d = target - real(plane.origin);
  const double a = dot(e1, e1), b = dot(e1, e2), c = dot(e2, e2), p = dot(d, e1), q = dot(d, e2);
  const double det = a * c - b * b;
  return {std::llround((c * p - b * q) / det), std::llround((a * q - b * p) / det)};
}

LatticePoint plane_point(const LatticePlane& plane, std::int64_t u, std::int64_t v) {
  LatticeVector c;
  for (std::size_t k = 0; k < 3; ++k) c[k] = plane.origin[k] + u * plane.e1[k] + v * plane.e2[k];
  return make_point(c);
}

}  // namespace crossloft
