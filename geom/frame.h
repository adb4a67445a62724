#pragma once
/// Plane frames: integer planes that are as good as a wanted plane and have integer points close to
/// everywhere.
///
/// A lattice plane is its primitive normal N and its offset: its lattice points are all its integer points,
/// one for each |N| square units. A long N meets the wanted direction better and leaves points further apart;
/// the fits below balance the two.

#include <span>

#include "lattice.h"
#include "vec3.h"

namespace crossloft {

/// The direction in integers, |d_k| <= 2^46, with its first component that is not 0 positive: the largest
/// component is 2^46, the others are rounded, so that v and a multiple of v agree but for the rounding of v
/// itself. REQUIRES: finite, not 0.
LatticeVector quantise_direction(Vec3 v);

// Fits. Directions are results of quantise_direction; `radius` is how far from the plane's origin the plane
// is used, in lattice units, 1..2^51. Results are primitive, their first component that is not 0 is positive,
// and |N_k| <= 2^40.

/// The normal with the least max(radius x angle to the direction, covering radius of the plane's lattice).
LatticeVector fit_normal(const LatticeVector& direction, std::int64_t radius);
/// The vector with the least max(radius x angle to the direction, half its length): the axis of a pencil.
LatticeVector fit_axis(const LatticeVector& direction, std::int64_t radius);
/// As before among the vectors of a plane with this normal; false if of those that are short enough to be an
/// axis, 2^30, none is within 45 degrees of the direction. REQUIRES: not along the normal.
bool fit_axis_in_plane(const LatticeVector& direction, const LatticeVector& normal, std::int64_t radius,
                       LatticeVector& axis);
/// As fit_normal among the normals of planes that contain the axis. REQUIRES: not along the axis.
LatticeVector fit_normal_around(const LatticeVector& direction, const LatticeVector& axis,
                                std::int64_t radius);

/// The plane with this normal through a point; its origin is its lattice point nearest to `centre`.
LatticePlane plane_through(const LatticeVector& normal, const LatticeVector& point,
                           const LatticeVector& centre);
/// The plane with this normal half way between the first and the last of the points along it.
/// REQUIRES: at least one point.
LatticePlane plane_amid(const LatticeVector& normal, std::span<const LatticeVector> points,
                        const LatticeVector& centre);

/// The lattice point of the plane nearest to p, the lexicographically first of several.
/// REQUIRES: a plane of the two functions above, |coordinates of p| <= 2^50.
LatticeVector snap_to_plane(const LatticePlane& plane, const LatticeVector& p);

// Exact tests.

/// True iff N and offset agree up to a factor.
bool same_plane(const LatticePlane& a, const LatticePlane& b);
/// True iff the planes, pairwise different, have a common line. Parallel planes have none.
bool share_line(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c);
/// The primitive direction of the common line; false if the planes are parallel or a component exceeds 2^30.
bool axis_of(const LatticePlane& a, const LatticePlane& b, LatticeVector& axis);
/// Sign of the offset of a less that of b along their normal. REQUIRES: equal normals.
int compare_offsets(const LatticePlane& a, const LatticePlane& b);

}  // namespace crossloft
