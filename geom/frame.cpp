#include "frame.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "lattice_reduction.h"

namespace crossloft {
namespace {

__extension__ using Int128 = __int128;

constexpr double kDirectionScale = 70368744177664.0;  // 2^46
constexpr int kLeastWeight = 20, kGreatestWeight = 60;
constexpr std::int64_t kAxisLimit = std::int64_t{1} << 30;

/// The axis that the plane is normal to if its lattice is all of the grid on it, as slices along an axis
/// have; else -1.
int full_grid_axis(const LatticePlane& plane) {
  const auto is_unit = [](const LatticeVector& v) {
    return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]) == 1;
  };
  if (!is_unit(plane.e1) || !is_unit(plane.e2)) return -1;
  return dominant_axis(plane.normal);
}

Wide norm2(const WideVector& v) { return dot(v, v); }

/// A fit's quality as the exact fraction value / scale.
struct Cost {
  Wide value, scale;
  bool operator<(const Cost& o) const { return value * o.scale < o.value * scale; }
};

/// 4 |d|^2 times the square of max(radius x angle, covering radius), angle = |N x d| / (|N| |d|); the
/// covering radius of a reduced basis is the circumradius |a| |b| |a -+ b| / (2 |N|) of its acute triangle.
/// Bits: radius 51, N 41, d 47: 4 + 102 + 176 and 94 + 82 + 84, times a scale of 82.
Cost plane_cost(const WideVector& n, const WideVector& direction, const Wide& radius) {
  const Kernel k = kernel_of(narrow(n));
  const WideVector c = dot(k.a, k.b) > 0 ? k.a - k.b : k.a + k.b;
  const Wide tilt = 4 * radius * radius * norm2(cross(n, direction));
  const Wide cover = norm2(k.a) * norm2(k.b) * norm2(c) * norm2(direction);
  return {std::max(tilt, cover), norm2(n)};
}

/// The same with half the length in place of the covering radius.
Cost axis_cost(const WideVector& e, const WideVector& direction, const Wide& radius) {
  const Wide tilt = 4 * radius * radius * norm2(cross(e, direction));
  const Wide step = norm2(e) * norm2(e) * norm2(direction);
  return {std::max(tilt, step), norm2(e)};
}

bool within(const WideVector& v, std::int64_t limit) {
  return std::all_of(v.begin(), v.end(), [&](const Wide& c) { return abs(c) <= limit; });
}

LatticeVector positive(LatticeVector v) {
  for (const std::int64_t c : v) {
    if (c > 0) return v;
    if (c < 0) return {-v[0], -v[1], -v[2]};
  }
  return v;
}

/// The cheapest of the shortest vectors of the lattice over all weights of the form.
template <class CostOf>
LatticeVector fit(std::span<WideVector> basis, const LatticeVector& direction, std::int64_t radius,
                  std::int64_t limit, const CostOf& cost_of) {
  const WideVector d = widen(direction);
  const Wide r = radius;
  WideVector best{}, last{};
  Cost best_cost{Wide(1), Wide(0)};  // infinite
  for (int weight = kLeastWeight; weight <= kGreatestWeight; ++weight) {
    reduce_basis(basis, DirectionForm(direction, weight));
    if (basis[0] == last || !within(basis[0], limit)) continue;
    last = basis[0];
    if (Cost cost = cost_of(last, d, r); cost < best_cost) best = last, best_cost = std::move(cost);
  }
  return positive(narrow(best));
}

std::array<WideVector, 3> unit_basis() { return {widen({1, 0, 0}), widen({0, 1, 0}), widen({0, 0, 1})}; }

/// The direction without its part along another one, quantised again: what a fit among the vectors orthogonal
/// to `along` can reach. Against the direction itself no vector's angle gets small, and short ones would win.
LatticeVector without_part_along(const LatticeVector& direction, const LatticeVector& along) {
  const WideVector d = widen(direction), a = widen(along);
  WideVector v = norm2(a) * d - dot(a, d) * a;
  const Wide largest = std::max({Wide(abs(v[0])), Wide(abs(v[1])), Wide(abs(v[2]))});
  for (Wide& c : v) c = round_quotient(c * (Wide(1) << 46), largest);
  return narrow(v);
}

/// The vector a i + b j, i and j from -1 to 1, nearest to d; the lexicographically first of several.
/// REQUIRES: components below 2^60, so that squared lengths have at most 126 bits.
LatticeVector nearest_step(const LatticeVector& a, const LatticeVector& b, const LatticeVector& d) {
  const auto squared_distance = [&](const LatticeVector& v) {
    Int128 sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += Int128{d[k] - v[k]} * (d[k] - v[k]);
    return sum;
  };
  LatticeVector best{};
  Int128 best_distance = squared_distance(best);
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j) {
      const LatticeVector v{i * a[0] + j * b[0], i * a[1] + j * b[1], i * a[2] + j * b[2]};
      const Int128 distance = squared_distance(v);
      if (distance < best_distance || (distance == best_distance && v < best))
        best = v, best_distance = distance;
    }
  return best;
}

/// The vector a i + b j, i and j integers, nearest to d; the lexicographically first of several.
/// The basis is reduced: that is at most one step from the rounded coefficients, and what is left of d there
/// is no longer than a, b and the distance of d from their plane, some 2^53 at most, together.
WideVector nearest_combination(const WideVector& a, const WideVector& b, const WideVector& d) {
  const Wide aa = norm2(a), bb = norm2(b), ab = dot(a, b), ad = dot(a, d), bd = dot(b, d);
  const Wide det = aa * bb - ab * ab;
  const WideVector base =
      round_quotient(ad * bb - bd * ab, det) * a + round_quotient(bd * aa - ad * ab, det) * b;
  return base + widen(nearest_step(narrow(a), narrow(b), narrow(d - base)));
}

/// The plane { N.x = N.centre + offset }.
LatticePlane plane_at(const LatticeVector& normal, const Wide& offset, const LatticeVector& centre) {
  const Kernel k = kernel_of(normal);
  const WideVector away = offset * k.t;
  const WideVector origin = widen(centre) + away - nearest_combination(k.a, k.b, away);
  return {narrow(origin), narrow(k.a), narrow(k.b), normal};
}

WideVector normal_of(const LatticePlane& p) { return widen(p.normal); }
/// N.x of the plane's points relative to a reference point.
Wide offset_from(const LatticePlane& p, const LatticeVector& reference) {
  return dot(normal_of(p), widen(p.origin) - widen(reference));
}

using Row = std::array<Wide, 4>;
Row row_of(const LatticePlane& p, const LatticeVector& reference) {
  const WideVector n = normal_of(p);
  return {n[0], n[1], n[2], offset_from(p, reference)};
}
Wide minor(const std::array<Row, 3>& m, std::size_t i, std::size_t j, std::size_t k) {
  return m[0][i] * (m[1][j] * m[2][k] - m[1][k] * m[2][j]) -
         m[0][j] * (m[1][i] * m[2][k] - m[1][k] * m[2][i]) +
         m[0][k] * (m[1][i] * m[2][j] - m[1][j] * m[2][i]);
}

}  // namespace

LatticeVector quantise_direction(Vec3 v) {
  const double largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  int exponent = 0;  // bring it to [0.5, 1): neither the division nor its operands may under- or overflow
  std::frexp(largest, &exponent);
  const double size = std::ldexp(largest, -exponent);
  const auto quantised = [&](double c) {
    return static_cast<std::int64_t>(std::floor(std::ldexp(c, -exponent) / size * kDirectionScale + 0.5));
  };
  // Of the positive representative, since halves round upwards.
  const double first = v.x != 0 ? v.x : v.y != 0 ? v.y : v.z;
  if (first < 0) v = -v;
  return positive({quantised(v.x), quantised(v.y), quantised(v.z)});
}

LatticeVector fit_normal(const LatticeVector& direction, std::int64_t radius) {
  auto basis = unit_basis();
  return fit(basis, direction, radius, kNormalLimit, plane_cost);
}

LatticeVector fit_axis(const LatticeVector& direction, std::int64_t radius) {
  auto basis = unit_basis();
  return fit(basis, direction, radius, kAxisLimit, axis_cost);
}

bool fit_axis_in_plane(const LatticeVector& direction, const LatticeVector& normal, std::int64_t radius,
                       LatticeVector& axis) {
  const Kernel k = kernel_of(normal);
  std::array<WideVector, 2> basis{k.a, k.b};
  const LatticeVector wanted = without_part_along(direction, normal);
  axis = fit(basis, wanted, radius, kAxisLimit, axis_cost);
  const WideVector a = widen(axis), d = widen(wanted);
  const Wide along = dot(a, d);
  return 2 * along * along > norm2(a) * norm2(d);  // not of (0, 0, 0), where none is short enough
}

LatticeVector fit_normal_around(const LatticeVector& direction, const LatticeVector& axis,
                                std::int64_t radius) {
  const Kernel k = kernel_of(axis);
  std::array<WideVector, 2> basis{k.a, k.b};
  return fit(basis, without_part_along(direction, axis), radius, kNormalLimit, plane_cost);
}

LatticePlane plane_through(const LatticeVector& normal, const LatticeVector& point,
                           const LatticeVector& centre) {
  return plane_at(normal, dot(widen(normal), widen(point) - widen(centre)), centre);
}

LatticePlane plane_amid(const LatticeVector& normal, std::span<const LatticeVector> points,
                        const LatticeVector& centre) {
  const WideVector n = widen(normal), c = widen(centre);
  Wide low = dot(n, widen(points[0]) - c), high = low;
  for (const LatticeVector& p : points.subspan(1)) {
    const Wide s = dot(n, widen(p) - c);
    if (s < low) low = s;
    if (s > high) high = s;
  }
  return plane_at(normal, round_quotient(low + high, Wide(2)), centre);
}

LatticeVector snap_to_plane(const LatticePlane& plane, const LatticeVector& p) {
  if (const int axis = full_grid_axis(plane); axis >= 0) {
    LatticeVector snapped = p;
    snapped[static_cast<std::size_t>(axis)] = plane.origin[static_cast<std::size_t>(axis)];
    return snapped;
  }
  const WideVector origin = widen(plane.origin);
  return narrow(origin + nearest_combination(widen(plane.e1), widen(plane.e2), widen(p) - origin));
}

bool same_plane(const LatticePlane& a, const LatticePlane& b) {
  const WideVector parallel = cross(normal_of(a), normal_of(b));
  return within(parallel, 0) && offset_from(a, b.origin) == 0;
}

bool share_line(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c) {
  if (within(cross(normal_of(a), normal_of(b)), 0)) return false;
  const std::array m{row_of(a, a.origin), row_of(b, a.origin), row_of(c, a.origin)};
  return minor(m, 0, 1, 2) == 0 && minor(m, 0, 1, 3) == 0 && minor(m, 0, 2, 3) == 0 && minor(m, 1, 2, 3) == 0;
}

bool axis_of(const LatticePlane& a, const LatticePlane& b, LatticeVector& axis) {
  WideVector e = cross(normal_of(a), normal_of(b));
  if (within(e, 0)) return false;
  const Wide g = gcd(gcd(abs(e[0]), abs(e[1])), abs(e[2]));
  for (Wide& c : e) c /= g;
  if (!within(e, kAxisLimit)) return false;
  axis = positive(narrow(e));
  return true;
}

int compare_offsets(const LatticePlane& a, const LatticePlane& b) { return offset_from(a, b.origin).sign(); }

}  // namespace crossloft
