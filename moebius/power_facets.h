#pragma once
/// The power diagram of lifted sites, dual to their regular triangulation: its edges and facets, cut by the
/// paraboloid.
///
/// A power edge is dual to a triangle and ends at the power vertices of the tetrahedra on both sides, or at
/// infinity. There the direction alone counts: straight up is inside the paraboloid, all others are outside.
/// Straight up leads to where the least lambda wins.

#include "../delaunay/tet_mesh.h"
#include "../delaunay/tri_mesh.h"
#include "diagram_builder.h"

namespace crossloft {

/// Dimension 3: facets are polygons, bounded or not. O(tetrahedra).
void add_facets(const SitePredicates& sites, const TetMesh& mesh, DiagramBuilder& builder);
/// Dimension 2: all power edges are parallel lines, facets are strips and half planes. O(triangles).
void add_facets(const SitePredicates& sites, const TriMesh& mesh, DiagramBuilder& builder);

}  // namespace crossloft
