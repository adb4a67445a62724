#pragma once
/// The way from rounded positions back to lattice points of a plane.

#include <array>
#include <cstdint>

#include "lattice.h"
#include "vec3.h"

namespace crossloft {

/// Rounded coordinates.
inline Vec3 real(const LatticePoint& p) { return {p.x, p.y, p.z}; }
Vec3 real(const LatticeVector& v);

/// Coordinates (u, v) over the plane's e1, e2 of the lattice point nearest to `target`, up to one step: e1
/// and e2 are Gauss-reduced, so their Gram matrix is well conditioned and the error of the coefficients
/// that are rounded stays below half a step for |target| <= 2^50.
std::array<std::int64_t, 2> nearest_coordinates(const LatticePlane& plane, Vec3 target);
/// The point origin + u e1 + v e2. REQUIRES: within the lattice.
LatticePoint plane_point(const LatticePlane& plane, std::int64_t u, std::int64_t v);

}  // namespace crossloft
