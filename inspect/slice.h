#pragma once
/// Cross-sections of a closed mesh, consistent on the common lines of the planes; and sets of planes.

#include <cstdint>
#include <span>
#include <vector>

#include "../arrangement/sections.h"
#include "../geom/result.h"
#include "../reconstruct/surface.h"
#include "../geom/bounds.h"

namespace crossloft {

/// { x : normal.x + offset = 0 }, any length of normal but 0.
struct CuttingPlane {
  Vec3 normal;
  double offset = 0;
};

/// Cuts the solid of a closed mesh with planes; section k belongs to plane k, an empty one if it misses.
///
/// (1) Contours close: every vertex is made once per mesh edge or per crossing. No edge is degenerate or
/// double;
///     loops are simple as index sequences and numbered from 0 in `contour`.
/// (2) Consistent: where a triangle meets the line of planes i and j, both sections have a vertex with
///     bitwise the same coordinates. Both decide that from the same signs, so neither has it alone.
///     Parallel planes have no line.
/// (3) A mesh vertex on a plane (within 1e-13 of the diagonal of the triangles' box) counts as above it: the
/// section is the limit of slices from below
///     the plane, as seen along the normal. Pieces that thereby collapse to a point or a segment vanish.
/// The same at any size: cut at size 1 and scaled back. Points of no triangle don't count, but must be
/// finite. Errors: not_closed (an edge in an odd number of triangles), index_out_of_range, not_finite,
/// zero_normal (with the plane's number), no_plane. O(n k + c log c + p) for n triangles, k planes, c pairs
/// of a triangle and a plane that cuts it, p triples of a triangle and two planes of different normals that
/// cut it.
Result<Sections> slice(const Surface& closed_mesh, std::span<const CuttingPlane> planes);

// Sets of planes for a box; the same on every platform. Empty for k = 0 or an empty box.

/// k planes orthogonal to `direction` (of any length but 0), at the middles of k equal parts of the box's
/// extent along it.
std::vector<CuttingPlane> parallel_planes(const Bounds& box, std::uint32_t k, Vec3 direction = {0, 0, 1});
/// Directions uniform on the sphere, distances from the centre uniform within 0.6 of half the diagonal.
std::vector<CuttingPlane> random_planes(const Bounds& box, std::uint32_t k, std::uint64_t seed);
/// k planes at equal angles through the line along `axis` (of any length but 0) through the centre.
std::vector<CuttingPlane> rotational_planes(const Bounds& box, std::uint32_t k, Vec3 axis = {0, 0, 1});
/// As an ultrasound sweep: from planes over the low end of x to its high end, tilted up to 25 degrees towards
/// both ends, with directions and places jittered by a fifth of the step.
std::vector<CuttingPlane> fan_planes(const Bounds& box, std::uint32_t k, std::uint64_t seed);

}  // namespace crossloft
