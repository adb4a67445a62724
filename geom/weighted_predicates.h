#pragma once
/// Exact power tests on weighted points of arbitrary finite doubles: the in-sphere tests of predicates.h with
/// weights. A point is lifted to the height |x|^2 - weight; no rounding, overflow or underflow can change an
/// answer.
///
/// REQUIRES: all coordinates and weights finite; the answer is 0 if one is not.
///
/// How: a semi-static filter in doubles (weighted_filters.h), then integers on the stack as in predicates.h,
/// with the square of the coordinates' unit dividing the weights too: as many bits as the coordinates span
/// together, or half those of the weights over the square of the unit. All doubles fit into the widest.
///
/// Laws, exact for all finite arguments (tests/geom/weighted_predicates_test.cpp): every exchange of two of
/// the first points negates the answer (for one dimension leaves it); equal weights give the in-sphere test
/// of predicates.h; so do all coordinates times 2^k and all weights times 4^k, in range; raising all weights
/// alike, if the sums are exact, changes nothing.

#include "fp_check.h"
#include "weighted_point.h"

namespace crossloft {

/// +1 if lifted e is strictly below the hyperplane through lifted a, b, c, d, 0 on it. REQUIRES: orient3d(a,
/// b, c, d) > 0 for that meaning; the sign flips with the orientation.
int power_test(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c, const WeightedPoint& d,
               const WeightedPoint& e);
/// Of coplanar points, projected along axis `drop`: +1 if lifted d is strictly below the plane through lifted
/// a, b, c, 0 on it. REQUIRES: orient2d of the projected a, b, c (without_axis) > 0 for that meaning; the
/// sign flips with it.
int power_test2d(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c,
                 const WeightedPoint& d, int drop);
/// Of collinear points: +1 if lifted c is strictly below the line through lifted a and b, 0 on it or if a and
/// b are in one place.
int power_test1d(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c);

}  // namespace crossloft
