#pragma once
/// The input of a reconstruction: cutting planes with the closed contours of their sections, in input units.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "../geom/bounds.h"
#include "../geom/ids.h"
#include "../geom/vec3.h"

namespace crossloft {

/// One straight piece of a contour. The materials of its two sides tell inside (not 0) from outside (0); which
/// side is left does not matter: an edge is a wall iff exactly one of the two is 0, and inside is even-odd.
struct ContourEdge {
  std::uint32_t a = 0, b = 0;             ///< vertices of the same plane
  std::int32_t material_a = 1;            ///< material on one side, 0 = outside the solid
  std::int32_t material_b = 0;            ///< material on the other side
  std::uint32_t contour = 0;              ///< 0-based contour of its plane, for messages
  std::uint32_t line = 0;                 ///< line of the file, 0 if none
};

/// A cutting plane { x : normal.x + offset = 0 } (any length of normal but 0) and its section.
struct PlaneSection {
  Vec3 normal;
  double offset = 0;
  std::vector<Vec3> vertices;
  std::vector<ContourEdge> edges;         ///< closed chains; holes are told by even-odd
  std::uint32_t line = 0;                 ///< line of the file where the plane is given, 0 if none
};

/// What some sections are part of: they are framed as if the rest were there.
struct PartOf {
  std::vector<std::uint32_t> positions;   ///< for each plane of the part: its position in the file
  Bounds extent;                          ///< of all walls of the file, also of contours without area
  Bounds wide = {};                       ///< of those that have one; if none has, of all
  /// Of quantise_direction(): that all planes of the file have, if they are a stack.
  std::optional<std::array<std::int64_t, 3>> direction = {};
};

struct Sections {
  std::string source;                     ///< file name for messages, may be empty
  std::vector<PlaneSection> planes;       ///< in file order
  std::optional<PartOf> part_of = std::nullopt;  ///< if these are not all planes of the file
};

/// Where the file has the plane.
inline std::uint32_t position_of(const Sections& sections, std::uint32_t plane) {
  return sections.part_of ? sections.part_of->positions[plane] : plane;
}

/// The plane that the file has there; null if it is not among these.
const PlaneSection* plane_at(const Sections& sections, std::uint32_t position);

}  // namespace crossloft
