#include "lattice_predicates.h"

namespace crossloft {

bool collinear(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c) {
  // Three points off a line span a plane, which misses one of four points that are affinely independent.
  static constexpr std::int64_t r = kLatticeLimit;
  for (const LatticeVector& corner : {LatticeVector{-r, -r, -r}, {r, -r, -r}, {-r, r, -r}, {-r, -r, r}})
    if (orient3d(a, b, c, make_point(corner)) != 0) return false;
  return true;
}

LatticePredicates2::LatticePredicates2(const LatticePlane& plane, const std::vector<LatticePoint>& points)
    : plane_(plane), points_(&points), projection_(filters::projection(plane.normal)) {}

double LatticePredicates2::squared_distance(std::uint32_t a, std::uint32_t b) const {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = (*points_)[a][axis] - (*points_)[b][axis];
    sum += d * d;
  }
  return sum;
}

}  // namespace crossloft
