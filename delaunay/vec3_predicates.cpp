#include "vec3_predicates.h"

namespace crossloft {

bool Vec3Predicates3::collinear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  // Three points off a line span a plane, which misses one of four points that are affinely independent.
  for (const Vec3& corner : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
    if (crossloft::orient3d(points_[a], points_[b], points_[c], corner) != 0) return false;
  return true;
}

}  // namespace crossloft
