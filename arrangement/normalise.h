#pragma once
/// The checked input: per plane distinct vertices and the walls between inside and outside, still in doubles.

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "../geom/context.h"
#include "../geom/result.h"
#include "framed_sections.h"
#include "sections.h"

namespace crossloft {

/// A plane of the file with what is left of its section.
struct WallSection {
  std::uint32_t source = kNone;  ///< position in the file
  Vec3 normal;                   ///< scaled by a power of two: largest component in [0.5, 1)
  double offset = 0;             ///< scaled alike
  std::vector<Vec3> vertices;    ///< distinct, in lexicographic order, no isolated one; no negative zero
  std::vector<WallEdge> walls;   ///< distinct, ordered by (a, b); every vertex has even degree >= 2
  double off_plane = 0;          ///< largest distance of a vertex from the plane
};

struct NormalisedSections {
  std::vector<WallSection> sections;  ///< one for each plane of the file, in file order
  Bounds extent;                 ///< of all vertices, also of those not in this part
  double diagonal = 0;           ///< of that box
  std::vector<std::string> notes, warnings;
};

/// That `part_of`, if it is set, has a position for each plane. Error: usage.
Result<Done> check_part(const Sections& sections);

/// That planes have a direction, numbers are finite and edges name vertices that are there. Errors: usage
/// (check_part), not_finite, zero_normal, index_out_of_range, with their place.
Result<Done> check_numbers(const Sections& sections);

/// Volumes and areas of coordinates beyond this would overflow a double.
inline constexpr double kLargestCoordinate = 1e100;

/// That no coordinate is beyond kLargestCoordinate; those that are no finite number are left to
/// check_numbers(). Errors: usage (check_part), too_large.
Result<Done> check_size(const Sections& sections);

/// Checks the input and reduces it to walls, as frame_sections() says; see there for the errors.
/// O(v log v) for v vertices and edges; planes on several threads. Error cancelled.
Result<NormalisedSections> normalise(const Sections& sections, double plane_tolerance,
                                     const Context& context = {});

/// The walls of each plane, also of contours without area. Errors: those of numbers and of open contours.
/// O(v log v).
Result<std::vector<WallSection>> walls_of(const Sections& sections);

/// How large sections are that need not be fit for frames: their contours may be open.
struct WallExtent {
  Bounds wide;    ///< as NormalisedSections::extent: of all walls if no contour has an area
  Bounds closed;  ///< likewise, of contours that close by themselves alone
  std::vector<std::vector<std::uint32_t>> flat;  ///< by plane: contours that have no area, ascending
};

/// REQUIRES: finite numbers, edges between vertices that are there. O(v log v) for v vertices and edges.
WallExtent wall_extent(const Sections& sections);

/// Adds those of a plane, but for the outside.
void add_materials(const PlaneSection& plane, std::set<std::int32_t>& materials);

/// What is told of several materials, by all in the same words, so that it is told once.
std::string note_of_materials(std::size_t count);

/// Drops contours that have no area in data with this diagonal: those so near to one line that frames can't
/// tell. O(w log w) for w walls.
void drop_flat(WallSection& section, double diagonal);

/// What most contours are told by at first sight: twice the area of a large triangle of its vertices, of
/// the section's contours the least; infinity if there is none. O(w log w).
double least_triangle(const WallSection& section);

/// False if no contour of a section with that least triangle can be dropped: points within a width w of a
/// line span triangles of less than 8 w diagonal, and roundings are far below the room that is left.
bool may_be_flat(double least_triangle, double diagonal);

/// The contours that have a wall, ascending.
std::vector<std::uint32_t> contours_of(const std::vector<WallEdge>& walls);

/// Cancels equal walls in pairs and drops those of zero length; of an odd number of equal ones the first in
/// the file remains. Brings the rest into order. O(w log w).
void cancel_pairs(std::vector<WallEdge>& walls);

}  // namespace crossloft
