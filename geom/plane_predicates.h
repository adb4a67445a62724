#pragma once
/// Predicates on planes alone: points are named by the planes they lie on and never get coordinates, so
/// that no rounding and no growth of coordinates can enter. Arrangement::verify() checks every vertex by them.

#include "lattice_filters.h"

namespace crossloft {

namespace filters {
/// Notation of difference_filters.h. Normals and differences of origins are exact, with column maxima X, Y, Z
/// over the normals; an offset N.d has the sum of its |terms| as size, at most S, and 3 u of it as error
/// (kSideOfPlaneError). In units of S X Y Z: det3 6 : 28, times offset 6 : 28 + 6*3 + 6 = 52; two terms
/// 12 : 104 + 12 = 116; all three 18 : 116 + 52 + 18.
inline constexpr double kSideOfMeetError = 186 * kU * kRoom;
}  // namespace filters

/// The side of q on which the common point of a, b and c lies: +1 where q's normal points to, 0 on q.
/// Exact for all lattice planes, also when the point is outside |x| <= 2^50. With the normals of a, b, c
/// dependent there is no such point and the answer is 0.
///
/// Laws: antisymmetric in q -> -q; symmetric in a, b, c and blind to the signs of their normals;
/// agrees with side_of_plane(q, p) for p = meet(a, b, c).
///
/// Sign of a 4x4 determinant of plane coefficients over the 3x3 determinant of the normals (dual form): in
/// doubles, then in 220-bit integers on the stack, no allocation.
int side_of_meet(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c, const LatticePlane& q);

/// The two stages of side_of_meet: the first is 0 where it cannot tell, the second exact alone.
int side_of_meet_filter(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c,
                        const LatticePlane& q);
int side_of_meet_exact(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c,
                       const LatticePlane& q);

/// Sign of det(N_a, N_b, N_c): 0 iff the planes do not meet in exactly one point.
int orient_normals(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c);

}  // namespace crossloft
