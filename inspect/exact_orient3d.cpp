#include "exact_orient3d.h"

#include <boost/multiprecision/cpp_int.hpp>

namespace crossloft {
namespace {

using Rational = boost::multiprecision::cpp_rational;

int orient3d_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto difference = [](double x, double y) { return Rational(x) - Rational(y); };
  const Rational m[3][3] = {{difference(b.x, a.x), difference(b.y, a.y), difference(b.z, a.z)},
                            {difference(c.x, a.x), difference(c.y, a.y), difference(c.z, a.z)},
                            {difference(d.x, a.x), difference(d.y, a.y), difference(d.z, a.z)}};
  const Rational det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                       m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                       m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return det.sign();
}

}  // namespace

int exact_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  const double det = dot(u, cross(v, w));
  const auto size = [](const Vec3& p) { return std::abs(p.x) + std::abs(p.y) + std::abs(p.z); };
  const double bound = 1e-14 * size(u) * size(v) * size(w);
  if (bound > 1e-200) {
    if (det > bound) return 1;
    if (det < -bound) return -1;
  }
  return orient3d_exact(a, b, c, d);
}

}  // namespace crossloft
