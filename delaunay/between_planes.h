#pragma once
/// Delaunay tetrahedra of points on two planes, from the Delaunay triangulations within the planes.
///
/// Seen from a slice to the next, all that is new is how the two triangulations lie over each other. Each
/// triangle is a facet of the hull and belongs to one tetrahedron, whose *apex* is in the other plane; all
/// others have an edge in each plane. Around an edge of the first plane the tetrahedra are a fan, from the
/// triangle on its left to the one on its right:
///
///     facet (a1, a2, b): the next vertex is the third one of the triangle on the right, or a neighbour of b,
///
/// since the spheres through the facet meet the first plane in circles through a1 and a2, and the second one
/// in circles through b, of which the empty ones are empty in a Delaunay triangulation. Where the neighbours
/// of b are seen from the facet they are a convex chain, as the link of b in the lifted triangulation is
/// convex: the first of them that a growing sphere meets is found by going along the chain as long as it gets
/// better. The other way round, an edge of the second plane has the fan of those that were found at it, which
/// tells the apexes of the triangles on both sides; from there they spread over edges without any.
///
/// Ties are those of perturbation.h, in the planes as well: so these are the tetrahedra of `Delaunay3`.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "../geom/lattice.h"
#include "tet_mesh.h"

namespace crossloft {

/// A planar Delaunay triangulation of all points on one of the planes.
struct PlaneSide {
  std::span<const std::array<std::uint32_t, 3>> triangles;  ///< by local vertices
  std::span<const std::array<std::uint32_t, 3>> sides;  ///< by triangle: its edges, opposite to its vertices
  std::uint32_t edge_count = 0;
  std::span<const std::uint32_t> numbers;  ///< by local vertex: which of the points it is
  bool clockwise = false;                  ///< the triangles are, seen from the other plane
};

struct BetweenPlanes {
  /// One tetrahedron for each triangle of the first plane, then of the second one, with its corners in slots
  /// 0 to 2 in order, 1 and 2 swapped if they are clockwise; then those with an edge of the first plane in
  /// slots 0 and 1 and one of the second plane in slots 2 and 3.
  TetMesh mesh;
  /// By such a tetrahedron: these edges.
  std::vector<std::array<std::uint32_t, 2>> edges;
};

/// False if that takes far more than linear time in the tetrahedra (vertices of large degree that are turned
/// around again and again), or if the triangulations don't fit. REQUIRES: points are distinct, each on one of
/// the planes alone, and there are triangles in both; the points of a plane are all strictly on one side of
/// the other.
bool delaunay_between_planes(std::span<const LatticePoint> points, const std::array<PlaneSide, 2>& planes,
                             BetweenPlanes& result);

}  // namespace crossloft
