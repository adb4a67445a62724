#pragma once
/// Delaunay and regular triangulations of points in space in one call, as plain arrays.

#include <cstdint>
#include <span>
#include <vector>

#include "../geom/vec3.h"
#include "../geom/weighted_point.h"
#include "tet_mesh.h"
#include "tri_mesh.h"

namespace crossloft {

/// A triangulation in the numbers of the points given, of the dimension that they have.
struct Triangulation {
  int dimension = -1;               ///< of the affine hull, -1 for no points and for what is not finite
  std::vector<std::uint32_t> kept;  ///< per point: the vertex that stands for it, kNone if it is hidden
  TetMesh tets;                     ///< dimension 3: orient3d > 0
  TriMesh triangles;                ///< dimension 2: counter-clockwise in the projection along dropped_axis
  int dropped_axis = -1;
  std::vector<std::uint32_t> chain;  ///< dimension 1 and 0: the vertices along the line
};

/// The Delaunay triangulation, ties broken as in Delaunay3: exact for all finite doubles, the same set of
/// simplices for any number of threads. Of equal points the one of lowest index is the vertex. Points on one
/// plane or line get the triangulation of that plane or line. The simplices come in no particular order
/// (sort_simplices).
///
/// The points are taken over and stored in insertion_order for the while: besides the result 32 bytes a point
/// and 1 a tetrahedron, with several threads 2 a point more and 4 for each. Expected O(n log n) plus the
/// tetrahedra made. `threads`: 0 counts as 1; few points use fewer, and no more than four a core are made.
/// Coordinates that are not finite have no triangulation: then there are no simplices, the dimension is -1
/// and no point is kept. 2^30 tetrahedra or more, hull facets included, are a failed
/// allocation.
Triangulation delaunay_triangulation(std::vector<Vec3> points, unsigned threads = 1);

/// The regular triangulation (contracts in regular3.h) in the same way; weights, too, have to be finite.
Triangulation regular_triangulation(std::span<const WeightedPoint> points);

/// Puts the simplices into the order of their vertices, and the vertices of each into the ascending order, or
/// that with the last two exchanged, whichever has its orientation: then the arrays are a function of the
/// points alone. O(n) expected, 8 bytes a tetrahedron and 4 a point for the while.
void sort_simplices(Triangulation& triangulation);

}  // namespace crossloft
