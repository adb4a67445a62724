#pragma once
/// From sections as a file gives them to exact ones: integer planes with the section vertices exactly on
/// them.

#include <cstdint>
#include <string>
#include <vector>

#include "../geom/context.h"
#include "../geom/grid.h"
#include "../geom/lattice.h"
#include "../geom/result.h"
#include "sections.h"

namespace crossloft {

/// A piece of the boundary of a section: inside on one side, outside on the other (told by even-odd).
struct WallEdge {
  std::uint32_t a = 0, b = 0;  ///< vertices of the same FramedPlane, a < b
  std::uint32_t plane = 0;     ///< where it comes from: position of its plane in the file,
  std::uint32_t contour = 0;   ///< of its contour in that plane,
  std::uint32_t line = 0;      ///< and line of the file (0 if none); for messages only
};

/// A cutting plane in the exact model. `plane.normal` is primitive with a positive first component that is
/// not 0, so the lattice points of the plane are all its integer points.
struct FramedPlane {
  LatticePlane plane;
  std::vector<std::uint32_t> sources;  ///< positions in the file of the planes that are this one, ascending
  std::vector<LatticePoint> vertices;  ///< explicit, exactly on the plane, distinct, in lexicographic order
  std::vector<Vec3> input;             ///< [vertex] where the file has it; the smallest of those merged
  std::vector<WallEdge> walls;         ///< distinct, ordered by (a, b); every vertex has even degree >= 2
  double displacement = 0;             ///< largest |vertex - input|, input units
  double off_plane = 0;                ///< largest distance of an input vertex from the plane of the file
};

struct FramedSections {
  WorldGrid grid;
  double diagonal = 0;                       ///< of the bounding box of all walls, input units
  Bounds whole;                              ///< that box, also of walls that are not in this part
  std::vector<FramedPlane> planes;           ///< distinct planes, in canonical order: by (normal, offset)
  std::uint32_t pencils = 0;                 ///< lines that three or more planes share exactly
  std::uint32_t common_points = 0;           ///< points near the data that four or more planes share exactly,
                                             ///< where that does not follow from the pencils
  std::vector<std::string> notes, warnings;  ///< one sentence each
};

/// The plane in input units, still without its section.
PlaneSection plane_in_input(const LatticePlane& plane, const WorldGrid& grid);

/// Warnings of a result without planes: there was no wall at all, or none that was left.
inline constexpr const char* kNoContour = "no section has a contour";
inline constexpr const char* kNoWideContour = "no contour is wide enough to be told from a line";

/// That it is a fraction of the diagonal that frame_sections() takes. Error: usage.
Result<Done> check_plane_tolerance(double tolerance);

/// Checks the sections and brings them into the exact model.
///
/// Walls are the edges with exactly one material 0; edges of equal coordinates cancel in pairs. Contours with
/// less than three distinct vertices or without area are dropped with a warning. Planes that agree within
/// 1e-9 of the diagonal over the extent of the data become one; normals that rounding keeps from being
/// parallel are (directions.h); planes through one line or one point within
/// that tolerance keep it exactly where the integers allow. All vertices lie within |x| <= 1.25 * 2^48. A
/// plane without walls that stays outside the cube |x| <= 2^49 is dropped with a note. Without any wall the
/// result has no planes and a warning.
///
/// The geometry of the result is canonical: the order of planes, contours and vertices, the direction of
/// contours and the sign and length of normals do not change a bit of `plane`, `vertices`, `input` and the
/// ends of `walls` (normals up to the rounding of the file's own numbers).
///
/// `plane_tolerance`, 0..0.1: a vertex further than this fraction of the diagonal from its plane is an error.
/// Errors: usage (tolerance, part_of), no_plane, not_finite, zero_normal, index_out_of_range, off_plane,
/// open_chain, contradicting_planes, too_large (data smaller than some 1e-309, where the grid would be finer
/// than doubles), cancelled; each with file, line, plane and contour where they apply.
/// O(v log v + k^3) for v vertices and k planes that are not parallel; the arrangement of k planes is as
/// large.
Result<FramedSections> frame_sections(const Sections& sections, double plane_tolerance,
                                      const Context& context = {});

}  // namespace crossloft
