#pragma once
/// Normals that the file's rounding has made different directions.

#include <vector>

#include "../geom/lattice.h"

namespace crossloft {

/// Directions, of quantise_direction, become one if they differ by no more than a unit in each component, up
/// to their sign, or if others lead from one to the other by such steps: all of them get the one that is
/// lexicographically least. So a normal n and 3 n are parallel, though their doubles are rounded differently:
/// that makes a 64th of a unit, but may be on either side of a half. O(k log k).
void unify_directions(std::vector<LatticeVector>& directions);

/// The largest difference of a component, up to the sign of the directions.
std::int64_t difference(const LatticeVector& a, const LatticeVector& b);

}  // namespace crossloft
