#pragma once
/// The in-sphere determinant for one point against many simplices: each vertex is lifted once, relative to
/// that point, and four such rows make a determinant in few operations, two at a time.
///
/// For points p with heights h (|p|^2 for the in-sphere test, |p|^2 - w for the power test) and an origin e
/// the row of p is (x, y, z, lift) = (p - e, |p - e|^2 or so, less the difference of the weights).
///
/// *The determinant.* Expanded along the column pairs (x, y) and (lift, z),
///     in-sphere = sum over pairs i < j of +-m(i, j) n(k, l), m = x_i y_j - y_i x_j, n = lift_k z_l - z_k
///     lift_l,
/// k < l the other two rows: m and n of a pair are computed together, in the lanes of one vector.
///
/// *Its error*, in the notation of difference_filters.h. With entries off by a of their size and lifts by b:
/// m 2 : 4a + 4; products of n 1 : a + b + 1, n 2 : 2 (a + b + 1) + 2; a product of m and n, which are up to
/// 2, 4 : 2 (4a + 4) + 2 (2a + 2b + 4) + 4 = 12a + 4b + 20. Two in a lane 8 : 24a + 8b + 48; three 12 : 36a +
/// 12b + 80; both lanes 24 : 72a + 24b + 184. That makes 256 of exact differences (a = 0, b = 3), 376 of
/// rounded ones (1, 5), 400 with weights (1, 6): the bounds of the in-sphere filters, kInsphereError,
/// kRoundedInsphereError and kPower3dError, hold here too, and so do their static ones (static_bounds.h).
///
/// *Relative to its own terms* the bound is sharper, mostly by some bits. Followed through all operations,
/// each of the 24 products of entries as computed is off by, in units of u of its size: in m 2a + 2, in n a +
/// b + 2, their product 3a + b + 5, and three sums 3a + b + 8: 11 of exact differences, 16 of rounded ones.
/// Not with weights: their lifts may cancel. Computing the sum of the sizes loses 8 u of it, which the room
/// covers. An underflow costs 2^-1075 times at most three entries of 2^150, or an entry and a lift of 2^300;
/// 100 of them are below 2^-610, and the room of a sum of 2^-500 above 2^-600.

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

namespace filters {
inline constexpr double kTermsError = 11 * kU * kRoom;
inline constexpr double kRoundedTermsError = 16 * kU * kRoom;
}  // namespace filters

struct LiftedRow {
  filters::Lanes x_lift, y_z;

  LiftedRow() = default;
  LiftedRow(const Vec3& d, double lift) : x_lift{d.x, lift}, y_z{d.y, d.z} {}
};

/// The sign is that of insphere(p, q, r, s, origin).
inline double lifted_determinant(const LiftedRow& p, const LiftedRow& q, const LiftedRow& r,
                                 const LiftedRow& s) {
  using filters::Lanes;
  const auto minors = [](const LiftedRow& a, const LiftedRow& b) {
    return a.x_lift * b.y_z - a.y_z * b.x_lift;
  };
  const auto both = [](Lanes a, Lanes b) { return a * filters::exchanged(b); };
  const Lanes sum = (both(minors(p, q), minors(r, s)) - both(minors(p, r), minors(q, s))) +
                    both(minors(p, s), minors(q, r));
  return sum[0] + sum[1];
}

/// How far lifted_determinant may be off, of any rows of one set of points (static_bounds.h).
struct LiftedError {
  double absolute = std::numeric_limits<double>::infinity();  ///< whatever the rows
  double relative = std::numeric_limits<double>::infinity();  ///< times lifted_terms of the rows
};

/// The sum of the sizes of the 24 products that lifted_determinant adds up, infinite if one of the rows is
/// out of range: the coordinates within kLargest as their squares are in the lifts, the sum at least
/// kSmallest^5. Where the maxima of the columns do not meet in one product, it says far more than they do.
inline double lifted_terms(const LiftedRow& p, const LiftedRow& q, const LiftedRow& r, const LiftedRow& s) {
  using filters::Lanes;
  const auto size = [](const LiftedRow& a) -> LiftedRow {
    return {{std::fabs(a.x_lift[0]), std::fabs(a.y_z[0]), std::fabs(a.y_z[1])}, std::fabs(a.x_lift[1])};
  };
  const LiftedRow a = size(p), b = size(q), c = size(r), d = size(s);
  const auto minors = [](const LiftedRow& v, const LiftedRow& w) {
    return v.x_lift * w.y_z + v.y_z * w.x_lift;
  };
  const auto both = [](Lanes v, Lanes w) { return v * filters::exchanged(w); };
  const Lanes sum = (both(minors(a, b), minors(c, d)) + both(minors(a, c), minors(b, d))) +
                    both(minors(a, d), minors(b, c));
  const double largest_lift = filters::largest(a.x_lift[1], b.x_lift[1], c.x_lift[1], d.x_lift[1]);
  const bool in_range = largest_lift <= filters::kLargest * filters::kLargest && sum[0] + sum[1] >= 0x1p-500;
  return in_range ? sum[0] + sum[1] : std::numeric_limits<double>::infinity();
}

}  // namespace crossloft
