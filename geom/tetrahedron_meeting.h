#pragma once
/// Whether two tetrahedra have common interior points, decided exactly on lattice points.

#include <array>

#include "lattice.h"

namespace crossloft {

using LatticeTet = std::array<LatticePoint, 4>;

/// True iff the open tetrahedra have a common point; what only touches does not overlap. REQUIRES: neither is
/// flat. Up to 56 planes through three of the eight corners: two convex polyhedra without common interior
/// points are separated by a plane, and the planes that separate form a cone whose extreme ones hold three of
/// the corners.
bool overlap(const LatticeTet& a, const LatticeTet& b);

}  // namespace crossloft
