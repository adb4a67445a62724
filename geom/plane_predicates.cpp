#include "plane_predicates.h"

#include "determinants.h"
#include "fixed_int.h"

namespace crossloft {
namespace {

using Entry = FixedInt<40>;
static_assert(kNormalLimit == std::int64_t{1} << 40 && kLatticeLimit == std::int64_t{1} << 50);

struct NormalRow {
  Entry x, y, z;
};

NormalRow normal_row(const LatticePlane& p) {
  return {Entry(p.normal[0]), Entry(p.normal[1]), Entry(p.normal[2])};
}

Vec3 to_doubles(const LatticeVector& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// N . (o - origin) in doubles and the sum of the terms' sizes. The difference is an integer below 2^52.
struct Offset {
  double value, size;
};
Offset offset_in_doubles(const Vec3& n, const LatticePlane& p, const Vec3& origin) {
  const Vec3 d = to_doubles(p.origin) - origin;
  const double x = n.x * d.x, y = n.y * d.y, z = n.z * d.z;
  return {x + y + z, std::fabs(x) + std::fabs(y) + std::fabs(z)};
}

/// N . (o - origin): the plane's offset with `origin` moved to zero.
auto offset_about(const LatticePlane& p, const LatticeVector& origin) {
  const NormalRow n = normal_row(p);
  const auto d = [&](std::size_t k) { return FixedInt<51>(p.origin[k] - origin[k]); };
  return n.x * d(0) + n.y * d(1) + n.z * d(2);
}

}  // namespace

int orient_normals(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c) {
  return det3(normal_row(a), normal_row(b), normal_row(c)).sign();
}

int side_of_meet_filter(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c,
                        const LatticePlane& q) {
  using namespace filters;
  const Vec3 na = to_doubles(a.normal), nb = to_doubles(b.normal), nc = to_doubles(c.normal);
  const Vec3 nq = to_doubles(q.normal), origin = to_doubles(q.origin);
  const Estimate w = orient3d(na, nb, nc);
  const int orientation = decide(w.det, kOrient3dError * w.size());
  const Offset oa = offset_in_doubles(na, a, origin), ob = offset_in_doubles(nb, b, origin),
               oc = offset_in_doubles(nc, c, origin);
  const double value =
      oa.value * det3(nb, nc, nq) + ob.value * det3(nc, na, nq) + oc.value * det3(na, nb, nq);
  const double size =
      largest(oa.size, ob.size, oc.size) * largest(w.x, nq.x) * largest(w.y, nq.y) * largest(w.z, nq.z);
  return orientation * decide(value, kSideOfMeetError * size);
}

int side_of_meet_exact(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c,
                       const LatticePlane& q) {
  // With q's origin at zero, the common point is (A Nb x Nc + B Nc x Na + C Na x Nb) / det(Na, Nb, Nc), where
  // A, B, C are the offsets of a, b, c; its product with Nq is the expansion of the 4x4 determinant.
  const NormalRow na = normal_row(a), nb = normal_row(b), nc = normal_row(c), nq = normal_row(q);
  const int orientation = det3(na, nb, nc).sign();
  if (orientation == 0) return 0;
  const auto value = offset_about(a, q.origin) * det3(nb, nc, nq) +
                     offset_about(b, q.origin) * det3(nc, na, nq) +
                     offset_about(c, q.origin) * det3(na, nb, nq);
  static_assert(decltype(value)::kBits <= 220);
  return orientation * value.sign();
}

int side_of_meet(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c, const LatticePlane& q) {
  if (const int side = side_of_meet_filter(a, b, c, q)) return side;
  return side_of_meet_exact(a, b, c, q);
}

}  // namespace crossloft
