#pragma once
/// Exact geometric predicates on arbitrary finite doubles. No rounding, overflow or underflow can change an
/// answer: 1e300 and denormals may be mixed in one call. Signs as for lattice points (lattice.h).
///
/// REQUIRES: all coordinates finite. A NaN or an infinity has no place on the line of numbers; the answer is
/// then 0, whatever the other coordinates are.
///
/// How: a semi-static filter in doubles; if it cannot tell, coordinates that are integers of at most 61 bits
/// over a common power of two become just that, and the determinant is evaluated in as few limbs as the
/// filter's bound leaves (small_integers.h); all others become multiples of the smallest power of two among
/// them, in a fixed width integer that holds their span (61, 124, 252 or 2098 bits; the last holds every
/// double). No allocation, no state, any thread. The filter takes a few nanoseconds, the second stage some
/// tens, the widest case some microseconds. Callers with many questions about one set of points use
/// static_bounds.h.
///
/// Laws, exact for all finite arguments (tests/geom/predicates_test.cpp):
///  (1) orient2d(b,a,c) == -orient2d(a,b,c); likewise every exchange of two points in every predicate;
///  (2) hence even permutations leave the sign alone; two equal points give 0;
///  (3) orient2d == 0 iff the points are collinear, orient3d == 0 iff coplanar, incircle == 0 iff the four
///      points lie on a circle or line or two of them are equal, insphere == 0 likewise with sphere or plane;
///  (4) negating every x (or y, or z) negates every answer;
///  (5) scaling all coordinates by a power of two, without overflow or underflow, changes nothing.

#include "fp_check.h"
#include "vec2.h"
#include "vec3.h"

namespace crossloft {

/// +1 if a, b, c turn counter-clockwise.
int orient2d(Vec2 a, Vec2 b, Vec2 c);
/// Sign of det(b-a, c-a, d-a): +1 if d is on the side from which a, b, c turn counter-clockwise.
int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
/// +1 if d is inside the circle through a, b, c, 0 on it. REQUIRES: orient2d(a,b,c) > 0 for that meaning; the
/// sign flips with the orientation.
int incircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d);
/// +1 if e is inside the sphere through a, b, c, d, 0 on it. REQUIRES: orient3d(a,b,c,d) > 0 for that
/// meaning; the sign flips with the orientation.
int insphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e);

}  // namespace crossloft
