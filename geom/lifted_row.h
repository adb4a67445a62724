#pragma once
/// The in-sphere determinant for one point against many simplices: each vertex is lifted once, relative to
/// that point, and four such rows make a determinant in few operations, two at a time.
///
/// For points p with heights h (|p|^2 for the in-sphere test, |p|^2 - w for the power test) and an origin e the
/// row of p is (x, y, z, lift) = (p - e, |p - e|^2 or so, less the difference of the weights).
///
/// *The determinant.* Expanded along the column pairs (x, y) and (lift, z),
///     in-sphere = sum over pairs i < j of +-m(i, j) n(k, l), m = x_i y_j - y_i x_j, n = lift_k z_l - z_k lift_l,
/// k < l the other two rows: m and n of a pair are computed together, in the lanes of one vector.
///
/// *Its error*, in the notation of difference_filters.h. With entries off by a of their size and lifts by b:
/// m 2 : 4a + 4; products of n 1 : a + b + 1, n 2 : 2 (a + b + 1) + 2; a product of m and n, which are up to 2,
/// 4 : 2 (4a + 4) + 2 (2a + 2b + 4) + 4 = 12a + 4b + 20. Two in a lane 8 : 24a + 8b + 48; three
/// 12 : 36a + 12b + 80; both lanes 24 : 72a + 24b + 184. That makes 256 of exact differences (a = 0, b = 3), 376
/// of rounded ones (1, 5), 400 with weights (1, 6): the bounds of the in-sphere filters, kInsphereError,
/// kRoundedInsphereError and kPower3dError, hold here too, and so do their static ones (static_bounds.h).

#include <limits>

#include "double_filters.h"
#include "fp_check.h"
#include "vec3.h"

namespace crossloft {

namespace filters {

#if defined(__GNUC__)
using Lanes = double __attribute__((vector_size(16)));
inline Lanes exchanged(Lanes v) { return Lanes{v[1], v[0]}; }
#else
/// The same operations without vectors, hence the same bits.
struct Lanes {
  double v[2];
  double operator[](int lane) const { return v[lane]; }
  friend Lanes operator+(Lanes a, Lanes b) { return {{a.v[0] + b.v[0], a.v[1] + b.v[1]}}; }
  friend Lanes operator-(Lanes a, Lanes b) { return {{a.v[0] - b.v[0], a.v[1] - b.v[1]}}; }
  friend Lanes operator*(Lanes a, Lanes b) { return {{a.v[0] * b.v[0], a.v[1] * b.v[1]}}; }
};
inline Lanes exchanged(Lanes v) { return {{v[1], v[0]}}; }
#endif

}  // namespace filters

struct LiftedRow {
  filters::Lanes x_lift, y_z;

  LiftedRow() = default;
  LiftedRow(const Vec3& d, double lift) : x_lift{d.x, lift}, y_z{d.y, d.z} {}
};

/// The sign is that of insphere(p, q, r, s, origin).
inline double lifted_determinant(const LiftedRow& p, const LiftedRow& q, const LiftedRow& r, const LiftedRow& s) {
  using filters::Lanes;
  const auto minors = [](const LiftedRow& a, const LiftedRow& b) { return a.x_lift * b.y_z - a.y_z * b.x_lift; };
  const auto both = [](Lanes a, Lanes b) { return a * filters::exchanged(b); };
  const Lanes sum = (both(minors(p, q), minors(r, s)) - both(minors(p, r), minors(q, s))) +
                    both(minors(p, s), minors(q, r));
  return sum[0] + sum[1];
}

/// How far lifted_determinant may be off, of any rows of one set of points (static_bounds.h).
struct LiftedError {
  double absolute = std::numeric_limits<double>::infinity();  ///< whatever the rows
  /// Times the column maxima, if these are in range (double_filters.h).
  double relative = std::numeric_limits<double>::infinity();
};

/// The product of the column maxima, infinite if one of them is out of range.
inline double lifted_size(const LiftedRow& p, const LiftedRow& q, const LiftedRow& r, const LiftedRow& s) {
  using filters::largest;
  const double x = largest(p.x_lift[0], q.x_lift[0], r.x_lift[0], s.x_lift[0]);
  const double y = largest(p.y_z[0], q.y_z[0], r.y_z[0], s.y_z[0]);
  const double z = largest(p.y_z[1], q.y_z[1], r.y_z[1], s.y_z[1]);
  if (!filters::in_range(x, y, z)) return std::numeric_limits<double>::infinity();
  return x * y * z * largest(p.x_lift[1], q.x_lift[1], r.x_lift[1], s.x_lift[1]);
}

}  // namespace crossloft
