#pragma once
/// What a set of sections holds and how well its planes agree, before any reconstruction.

#include <cstdint>
#include <string>
#include <vector>

#include "../arrangement/sections.h"
#include "../geom/context.h"
#include "../geom/result.h"

namespace crossloft {

/// One cutting plane; positions in the file that are the same plane count as one.
struct PlaneInfo {
  std::uint32_t plane = kNone;            ///< first position in the file
  Vec3 normal;                            ///< unit length
  double offset = 0;                      ///< normal.x + offset = 0
  std::uint32_t contours = 0, holes = 0;  ///< contours with the section inside / outside of them
  std::uint32_t vertices = 0, edges = 0;
  double off_plane = 0;                   ///< largest distance of a vertex from the plane as given
  std::uint32_t crossing_edges = 0;       ///< pairs of contour edges that cross or touch within an edge
};

/// Lengths in input units.
struct SectionsInfo {
  std::vector<PlaneInfo> planes;          ///< planes that hold or bound something, by position in the file
  std::uint32_t directions = 0;           ///< classes of parallel planes
  std::uint32_t sections = 0;             ///< planes with a contour
  std::uint32_t contours = 0, holes = 0, vertices = 0, edges = 0, crossing_edges = 0;
  Vec3 low, high;                         ///< extents of all contours
  double diagonal = 0;
  double off_plane = 0;
  std::uint32_t pencils = 0, common_points = 0;  ///< three or more planes through a line, four or more through a point
  bool lines_compared = false;            ///< false if contours cross, then the rest is not known
  std::uint32_t crossings = 0;            ///< contour vertices on common lines, once for each plane
  std::uint32_t unpaired = 0;             ///< crossings that another plane has no partner for at any distance
  double mismatch = 0;                    ///< largest distance along a line between crossings of two sections paired there
  std::vector<std::string> notes, warnings;
};

/// Examines. Errors: those of frame_sections; too_large for a coordinate beyond 1e100. O(n log n + n k) for n
/// vertices and k planes, plus the arrangement.
Result<SectionsInfo> examine(const Sections& sections, double plane_tolerance = 1e-3, const Context& context = {});

}  // namespace crossloft
