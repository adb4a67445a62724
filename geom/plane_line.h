#pragma once
/// Magnitudes along planes and their common lines, where a sign is not enough.

#include "lattice.h"

namespace crossloft {

/// N.p - N.o rounded: the relative error is at most 2^-51 (2^-53 for an explicit point), also next to the plane,
/// where doubles alone would cancel. Sign as side_of_plane.
double plane_value(const LatticePlane& plane, const LatticePoint& p);

/// The dominant axis of the direction N_a x N_b of the common line, exact; -1 if the planes are parallel.
/// The line meets { x_axis = t } in one point for every t.
int line_axis(const LatticePlane& a, const LatticePlane& b);

/// The point of the common line of a and b with the integer coordinate t along line_axis(a, b).
/// False if the planes are parallel or the point is outside the lattice.
bool line_point(LatticePointStore& store, const LatticePlane& a, const LatticePlane& b, std::int64_t t,
                LatticePoint& point);

}  // namespace crossloft
