#include "lattice.h"

#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "homogeneous.h"

namespace crossloft {
namespace {

using Wide = Fixed<2560>;

struct Coordinates {
  Wide x, y, z, w;
};

Coordinates widen(const LatticePoint& p) {
  if (p.exact) return {Wide(p.exact->x), Wide(p.exact->y), Wide(p.exact->z), Wide(p.exact->w)};
  const LatticeVector v = to_vector(p);
  return {Wide(v[0]), Wide(v[1]), Wide(v[2]), Wide(1)};
}

template <class T>
T det2(const T& a, const T& b, const T& c, const T& d) { return a * d - b * c; }

template <class T>
T det3(const std::array<T, 3>& r, const std::array<T, 3>& s, const std::array<T, 3>& t) {
  return r[0] * det2(s[1], s[2], t[1], t[2]) - r[1] * det2(s[0], s[2], t[0], t[2]) +
         r[2] * det2(s[0], s[1], t[0], t[1]);
}

const Wide& coordinate(const Coordinates& c, int axis) { return axis == 0 ? c.x : axis == 1 ? c.y : c.z; }

/// q - p scaled by wp wq > 0.
std::array<Wide, 3> scaled_difference(const Coordinates& p, const Coordinates& q) {
  return {q.x * p.w - p.x * q.w, q.y * p.w - p.y * q.w, q.z * p.w - p.z * q.w};
}

}  // namespace

LatticeVector cross(const LatticeVector& a, const LatticeVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

LatticePlane make_lattice_plane(LatticeVector origin, LatticeVector e1, LatticeVector e2) {
  return {origin, e1, e2, cross(e1, e2)};
}

LatticePlane make_axis_plane(int axis, std::int64_t value) {
  LatticeVector origin{}, e1{}, e2{};
  origin[static_cast<std::size_t>(axis)] = value;
  e1[static_cast<std::size_t>((axis + 1) % 3)] = 1;
  e2[static_cast<std::size_t>((axis + 2) % 3)] = 1;
  return make_lattice_plane(origin, e1, e2);
}

int dominant_axis(const LatticeVector& n) {
  const auto size = [&](std::size_t k) { return n[k] < 0 ? -n[k] : n[k]; };
  int axis = 0;
  if (size(1) > size(0)) axis = 1;
  if (size(2) > size(static_cast<std::size_t>(axis))) axis = 2;
  return axis;
}

LatticePoint make_point(const LatticeVector& c) {
  return {static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2]), nullptr};
}

LatticeVector to_vector(const LatticePoint& p) {
  return {static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y), static_cast<std::int64_t>(p.z)};
}

struct LatticePointStore::Impl {
  std::map<std::tuple<Fixed<192>, Fixed<192>, Fixed<192>, Fixed<128>>, const Homogeneous*> known;
  std::deque<Homogeneous> points;
};

LatticePointStore::LatticePointStore() : impl_(std::make_unique<Impl>()) {}
LatticePointStore::~LatticePointStore() = default;
LatticePointStore::LatticePointStore(LatticePointStore&&) noexcept = default;
LatticePointStore& LatticePointStore::operator=(LatticePointStore&&) noexcept = default;
std::size_t LatticePointStore::size() const { return impl_->points.size(); }

namespace {

using Solve = Fixed<512>;

std::array<Solve, 3> normal_of(const LatticePlane& p) {
  return {Solve(p.normal[0]), Solve(p.normal[1]), Solve(p.normal[2])};
}
Solve offset_of(const LatticePlane& p) {
  return Solve(p.normal[0]) * p.origin[0] + Solve(p.normal[1]) * p.origin[1] + Solve(p.normal[2]) * p.origin[2];
}

/// Nearest double of n / d, d > 0, ties to even.
double round_quotient(const Solve& n, const Solve& d) {
  const bool negative = n < 0;
  const Solve a = negative ? Solve(-n) : n;
  int shift = 0;  // bring the quotient to at least 55 bits plus a sticky bit
  const int bits = a == 0 ? 0 : static_cast<int>(msb(a)) - static_cast<int>(msb(d));
  if (bits < 56) shift = 56 - bits;
  const Solve scaled = a << shift;
  const Solve q = scaled / d;
  const bool inexact = q * d != scaled;
  std::uint64_t m = static_cast<std::uint64_t>(q);  // 56 or 57 bits
  if (inexact) m |= 1;
  const double value = std::ldexp(static_cast<double>(m), -shift);
  return negative ? -value : value;
}

}  // namespace

bool LatticePointStore::meet(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c,
                             LatticePoint& point) {
  const auto na = normal_of(a), nb = normal_of(b), nc = normal_of(c);
  Solve w = det3(na, nb, nc);
  if (w == 0) return false;
  const Solve da = offset_of(a), db = offset_of(b), dc = offset_of(c);
  std::array<Solve, 3> x;
  for (std::size_t k = 0; k < 3; ++k) {
    auto ra = na, rb = nb, rc = nc;
    ra[k] = da, rb[k] = db, rc[k] = dc;
    x[k] = det3(ra, rb, rc);
    if (w < 0) x[k] = -x[k];
  }
  if (w < 0) w = -w;
  for (const Solve& v : x)
    if (abs(v) > w * kLatticeLimit) return false;
  const Solve g = gcd(gcd(w, abs(x[0])), gcd(abs(x[1]), abs(x[2])));
  w /= g;
  for (Solve& v : x) v /= g;
  if (w == 1) {
    point = make_point({static_cast<std::int64_t>(x[0]), static_cast<std::int64_t>(x[1]),
                        static_cast<std::int64_t>(x[2])});
    return true;
  }
  const Homogeneous h{Fixed<192>(x[0]), Fixed<192>(x[1]), Fixed<192>(x[2]), Fixed<128>(w)};
  auto [it, fresh] = impl_->known.try_emplace({h.x, h.y, h.z, h.w}, nullptr);
  if (fresh) {
    impl_->points.push_back(h);
    it->second = &impl_->points.back();
  }
  point = {round_quotient(x[0], w), round_quotient(x[1], w), round_quotient(x[2], w), it->second};
  return true;
}

bool equal(const LatticePoint& a, const LatticePoint& b) { return compare_lex(a, b) == 0; }

int compare_axis(int axis, const LatticePoint& a, const LatticePoint& b) {
  // Rounding to nearest is monotone: different rounded values order the exact ones.
  if (a[axis] != b[axis]) return a[axis] < b[axis] ? -1 : 1;
  if (a.exact == b.exact) return 0;
  const Coordinates p = widen(a), q = widen(b);
  return Wide(coordinate(p, axis) * q.w - coordinate(q, axis) * p.w).sign();
}

int compare_lex(const LatticePoint& a, const LatticePoint& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (const int sign = compare_axis(axis, a, b)) return sign;
  return 0;
}

int side_of_plane(const LatticePlane& plane, const LatticePoint& p) {
  const Coordinates c = widen(p);
  const auto& n = plane.normal;
  const auto& o = plane.origin;
  const Wide s = (c.x - c.w * o[0]) * n[0] + (c.y - c.w * o[1]) * n[1] + (c.z - c.w * o[2]) * n[2];
  return s.sign();
}

int orient3d(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d) {
  const Coordinates p = widen(a);
  return det3(scaled_difference(p, widen(b)), scaled_difference(p, widen(c)), scaled_difference(p, widen(d)))
      .sign();
}

namespace {

/// Row of the in-sphere determinant for q relative to p: (d W, |d|^2) with d = scaled difference, W = wp wq;
/// the row times W of (d / W, |d/W|^2) W, so that all entries are integers and the factor is positive.
struct LiftedRow {
  std::array<Wide, 3> d;
  Wide lift;
};
LiftedRow lifted_row(const Coordinates& p, const Coordinates& q) {
  auto d = scaled_difference(p, q);
  const Wide w = p.w * q.w;
  const Wide lift = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  for (auto& v : d) v *= w;
  return {d, lift};
}

}  // namespace

int insphere(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d,
             const LatticePoint& e) {
  const Coordinates p = widen(e);
  const LiftedRow ra = lifted_row(p, widen(a)), rb = lifted_row(p, widen(b)), rc = lifted_row(p, widen(c)),
                  rd = lifted_row(p, widen(d));
  const Wide s = ra.lift * det3(rb.d, rc.d, rd.d) - rb.lift * det3(ra.d, rc.d, rd.d) +
                 rc.lift * det3(ra.d, rb.d, rd.d) - rd.lift * det3(ra.d, rb.d, rc.d);
  return s.sign();
}

int orient2d(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  const int k = dominant_axis(plane.normal);
  const auto i = static_cast<std::size_t>((k + 1) % 3), j = static_cast<std::size_t>((k + 2) % 3);
  const Coordinates p = widen(a);
  const auto u = scaled_difference(p, widen(b)), v = scaled_difference(p, widen(c));
  const int sign = Wide(det2(u[i], u[j], v[i], v[j])).sign();
  return plane.normal[static_cast<std::size_t>(k)] > 0 ? sign : -sign;
}

int incircle(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
             const LatticePoint& d) {
  const int k = dominant_axis(plane.normal);
  const auto i = static_cast<std::size_t>((k + 1) % 3), j = static_cast<std::size_t>((k + 2) % 3);
  const Coordinates p = widen(d);
  const LiftedRow ra = lifted_row(p, widen(a)), rb = lifted_row(p, widen(b)), rc = lifted_row(p, widen(c));
  const std::array<Wide, 3> r{ra.d[i], ra.d[j], ra.lift}, s{rb.d[i], rb.d[j], rb.lift},
      t{rc.d[i], rc.d[j], rc.lift};
  const int sign = Wide(det3(r, s, t)).sign();
  return plane.normal[static_cast<std::size_t>(k)] > 0 ? sign : -sign;
}

}  // namespace crossloft
