#pragma once
/// Roofs: thin pieces of solid over section triangles that nothing stands on, so that the solid has them.
///
/// Over each flat triangle a point is raised, over each edge between two of them another, and over each
/// vertex that is surrounded by them a third: the tetrahedra between them and the section are a plate with
/// slopes along its border. It meets the plane in the flat triangles and, all raised points being strictly
/// inside the cell, no other plane in more than vertices and edges of theirs. Seen from above each
/// tetrahedron stays over its own triangle, but for the rounding to the grid; so the pieces of one plate
/// can't get into each other, and all of it is tested exactly.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "../geom/lattice.h"
#include "../geom/vec3.h"

namespace crossloft {

/// Vertices of a roof from here on are raised points; below, numbers of the points given.
inline constexpr std::uint32_t kFirstRaisedPoint = std::uint32_t{1} << 31;

/// A section triangle that no tetrahedron stands on, as a cell sees it.
struct FlatTriangle {
  std::uint32_t face = 0;            ///< triangles of one face are plates together
  std::array<std::uint32_t, 3> v{};  ///< by number, counter-clockwise seen from inside the cell
};

/// A plane of the cell's boundary and the side on which the cell is.
struct CellSide {
  LatticePlane plane;
  int side = 0;
};

/// What the roofs of a cell are made for and must keep clear of.
struct RoofSite {
  std::span<const FlatTriangle> triangles;
  std::span<const LatticePoint> points;                 ///< by number
  std::vector<CellSide> sides;                          ///< convex: all that bounds the cell
  std::vector<std::array<std::uint32_t, 4>> obstacles;  ///< tetrahedra of the solid in the cell
  double height = 0;                                    ///< largest, lattice units
};

struct CellRoofs {
  std::vector<LatticePoint> points;  ///< number kFirstRaisedPoint + position; strictly inside the cell
  std::vector<std::array<std::uint32_t, 4>> tets;  ///< positively oriented; may end at an obstacle's corner
  std::vector<std::uint8_t> built;                 ///< by triangle: 1 if it has got a roof
  double height = 0;                               ///< of the highest point raised, lattice units
};

/// Rounds in which a point over a triangle may come down by half: from any height to less than a unit.
inline constexpr int kRoofRounds = 52;

/// Builds what can be built. A raised point starts at the full height, or lower where the cell ends; where a
/// tetrahedron overlaps an obstacle or another one, or is turned over by rounding, its raised points come
/// down by half, all in one round, and again; two units over a triangle its point looks for room all over
/// it, with 256 feet, then towards the corners of obstacles that touch the triangle: a corner inside the
/// cell and no higher than asked may be the point itself, else one of 16 on the way to each. Who fails in
/// too many rounds is left out, and the heights start anew: what fills the fan of a vertex first, then that
/// of an edge, then a triangle: there was no lattice point over it, or none found that has room. No
/// tetrahedra overlap in the result; plates of different faces, and a plate and the solid beside it, meet at
/// the section's edges and vertices, or in triangles up to a common corner. Does not depend on the order of
/// the obstacles.
/// Expected O(n log n) each round.
CellRoofs build_roofs(const RoofSite& site);

}  // namespace crossloft
