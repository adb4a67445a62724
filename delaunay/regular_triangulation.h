#pragma once
/// The regular triangulation of weighted points in one call.

#include <cstdint>
#include <span>
#include <vector>

#include "../geom/weighted_point.h"
#include "tet_mesh.h"
#include "tri_mesh.h"

namespace crossloft {

/// What Regular3 says, in the numbers of the points given; contracts there.
struct RegularTriangulation {
  int dimension = -1;               ///< of the affine hull, -1 for no points
  std::vector<std::uint32_t> kept;  ///< per point: the vertex that stands for it, kNone if it is hidden
  TetMesh tets;                     ///< dimension 3
  TriMesh triangles;                ///< dimension 2, projected along dropped_axis
  int dropped_axis = -1;
  std::vector<std::uint32_t> chain;  ///< dimension 1 and 0
};

/// The regular triangulation of the points, exact for all finite doubles. Stores them in insertion_order for
/// the while, which makes it faster than Regular3 on points in no particular order. Besides the result, 36
/// bytes a tetrahedron and 52 a point. REQUIRES: finite coordinates and weights.
RegularTriangulation regular_triangulation(std::span<const WeightedPoint> points);

}  // namespace crossloft
