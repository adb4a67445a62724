#pragma once
/// Where copies of a vertex may go without changing what the solid has in common with the planes.
///
/// A copy may move iff all triangles of its umbrella lie in one closed cell of the arrangement, none of them
/// in a plane, and no edge at it is a contour edge; and then to any place in the open cell. The solid changes
/// only within the tetrahedra (old place, new place, a, b) over the triangles (old place, a, b). These stay
/// in the closed cell, which is convex. A plane supports the cell and does not hold the new place, so it
/// meets such a tetrahedron in the part of (old place, a, b) that it holds: an edge at most, without area and
/// no contour.

#include <span>

#include "../arrangement/section_graph.h"
#include "../geom/grid.h"
#include "numbering.h"
#include "separate.h"

namespace crossloft {

/// All exact: signs of the lattice points that the surface is made from; new places are lattice points.
class SectionConfinement : public Confinement {
 public:
  /// `surface` as glued, of the vertices of `numbering`. All must outlive the object. Only of its copies may
  /// be asked.
  SectionConfinement(const SectionGraph& graph, std::span<const FaceTriangulation> faces,
                     const Numbering& numbering, const WorldGrid& grid, const GluedSurface& surface);
  bool may_move(const Umbrella& umbrella) const override;
  bool admit(const Umbrella& umbrella, Vec3& place) const override;

 private:
  int side(std::uint32_t plane, std::uint32_t number) const;
  int side_of_surface_vertex(std::uint32_t plane, std::uint32_t vertex) const;
  int side_of_umbrella(std::uint32_t plane, const Umbrella& umbrella) const;
  bool is_contour_edge(const SurfaceVertex& a, const SurfaceVertex& b) const;

  const SectionGraph& graph_;
  const Numbering& numbering_;
  const WorldGrid& grid_;
  const GluedSurface& surface_;
  std::vector<std::array<std::uint32_t, 2>> contour_edges_;  ///< at copies: numbers a < b, sorted
};

}  // namespace crossloft
