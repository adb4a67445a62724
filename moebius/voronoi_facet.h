#pragma once
/// The facets of a Voronoi diagram, one at a time: the tetrahedra around an edge of the Delaunay
/// triangulation.

#include <cstdint>
#include <vector>

#include "../delaunay/tet_mesh.h"

namespace crossloft {

/// A side of a facet: the Voronoi edge of the Delaunay edge and `apex`, from one tetrahedron to the next
/// around the edge.
struct VoronoiSide {
  std::uint32_t apex = kNone;
  std::uint32_t from = kNone, to = kNone;                ///< tetrahedra, kNone at infinity
  std::uint32_t from_vertex = kNone, to_vertex = kNone;  ///< the fourth vertex of each, kNone at infinity
};

/// A tetrahedron (i, j, behind, ahead) of positive orientation around the edge ij.
struct EdgeWedge {
  std::uint32_t tet = kNone, behind = kNone, ahead = kNone;
  std::uint8_t edge = 0;  ///< number of the edge ij in it (kEdgeSlots)
};

/// The facet of the edge ij, counter-clockwise seen from j. On an edge of the hull the first side comes from
/// infinity and the last one goes there; the gap between them is no side.
struct VoronoiFacet {
  std::uint32_t i = kNone, j = kNone;  ///< i < j
  bool on_hull = false;
  std::vector<EdgeWedge> wedges;  ///< one per corner of the facet
  std::vector<VoronoiSide>
      sides;  ///< on the hull one more than wedges; side s ends at wedge s there, else begins at it

  /// Becomes the facet of an edge (kEdgeSlots) of a tetrahedron. Time linear in the sides.
  void walk(const TetMesh& mesh, std::uint32_t tet, std::size_t edge);

 private:
  EdgeWedge wedge(const TetMesh& mesh, std::uint32_t tet) const;
  bool go_round(const TetMesh& mesh, EdgeWedge start);
  void set_sides();
};

}  // namespace crossloft
