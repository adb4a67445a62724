#pragma once
/// orient3d of points with any finite double coordinates.

#include "../geom/vec3.h"

namespace crossloft {

/// Sign of det(b-a, c-a, d-a), exact.
int exact_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace crossloft
