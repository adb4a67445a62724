#pragma once
/// side_of_meet in doubles for the static filter: its bound is made of the largest values of all data, that of
/// plane_predicates.h of the columns of each call.
///
/// Normals and differences of origins are integers that doubles hold. With n the largest |N_k| and d the
/// largest difference, `a : b` as in difference_filters.h: offset, in n d: products 1 : 1, first sum 2 : 4,
/// whole sum 3 : 8. Its product with det3 (6 : 28, in n^3): 18 : 3*28 + 6*8 + 18 = 150; two terms 36 : 336;
/// three 54 : 336 + 150 + 54. Nothing underflows: all are integers.

#include "../difference_filters.h"
#include "lattice_formulas.h"
#include "naive_double.h"

namespace crossloft::strategies {

inline constexpr double kMeetError = 540 * filters::kU * filters::kRoom;

/// Both determinants.
struct MeetEstimate {
  double orientation, value;
};

inline MeetEstimate meet_estimate(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c,
                                  const LatticePlane& q) {
  using D = DoubleArithmetic;
  const auto na = normal_row<D>(a), nb = normal_row<D>(b), nc = normal_row<D>(c), nq = normal_row<D>(q);
  const LatticePoint origin = make_point(q.origin);
  const auto from = [&](const LatticePlane& p) {
    return explicit_row<D>(kSpace, make_point(p.origin), origin);
  };
  const auto da = from(a), db = from(b), dc = from(c);
  return {det3(na, nb, nc),
          dot3(na, da) * det3(nb, nc, nq) + dot3(nb, db) * det3(nc, na, nq) + dot3(nc, dc) * det3(na, nb, nq)};
}

/// +-1, or 0 if it cannot tell, for bounds on the normals and differences.
inline int meet_verdict(const MeetEstimate& e, double n, double d) {
  const double cube = n * n * n;
  return filters::decide(e.orientation, filters::kOrient3dError * cube) *
         filters::decide(e.value, kMeetError * (cube * (n * d)));
}

}  // namespace crossloft::strategies
