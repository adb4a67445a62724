#pragma once
/// Judges a surface from its triangles alone, by index and without welding: is it a closed, oriented
/// 2-manifold, does it cross itself, what is its topology; and does its solid meet the cutting planes in the
/// given sections.

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "../arrangement/sections.h"
#include "../geom/context.h"
#include "../geom/result.h"
#include "../reconstruct/surface.h"

namespace crossloft {

/// Triangles connected by shared vertex indices.
struct ComponentReport {
  std::uint32_t vertices = 0, edges = 0, triangles = 0;
  bool manifold = false;    ///< closed, oriented and manifold: only then are the next two meaningful
  std::int64_t euler = 0;   ///< vertices - edges + triangles
  std::int64_t genus = 0;   ///< 1 - euler / 2 if manifold, else 0
  double volume = 0;        ///< signed, in cubed input units; negative if its inside is on the wrong side
  double volume_rounding = 0;  ///< bound of its error: within that of 0 the sign says nothing
  bool volume_sign_known = false;  ///< told at size 1: also where volume and bound are both infinite or 0
  std::uint32_t depth = 0;  ///< number of other components that enclose it (counted if all are manifold)
  bool depth_known = true;  ///< false if another component touches this one wherever a ray was tried
  std::uint32_t first_triangle = 0;

  /// A hole inside the solid that can't be seen from outside. (A volume too small for a double keeps its
  /// sign.)
  bool cavity() const { return std::signbit(volume) && depth_known && depth % 2 == 1; }
  /// Inside out: its orientation contradicts its depth.
  bool inverted() const {
    return manifold && volume_sign_known && depth_known && std::signbit(volume) != (depth % 2 == 1);
  }
};

struct CheckReport {
  std::uint32_t points = 0, triangles = 0;
  std::uint32_t unused_points = 0;    ///< points of no triangle; harmless
  std::uint32_t bad_indices = 0;      ///< triangles naming a point that is not there; left out of the rest
  std::uint32_t bad_coordinates = 0;  ///< points with NaN or infinity; the geometric counts are then left 0

  std::uint32_t open_edges = 0;            ///< edges of one triangle only
  std::uint32_t crowded_edges = 0;         ///< edges of more than two triangles
  std::uint32_t misoriented_edges = 0;     ///< edges that two triangles run through in the same direction
  std::uint32_t nonmanifold_vertices = 0;  ///< vertices whose triangles don't form a single fan (umbrella)
  std::uint32_t repeated_indices = 0;      ///< triangles that name a vertex twice
  std::uint32_t repeated_points = 0;       ///< triangles with two equal corners under different indices
  std::uint32_t flat_triangles = 0;        ///< three distinct corners exactly on one line

  std::uint64_t crossings = 0;  ///< pairs of triangles that cross properly, see check_surface
  std::uint64_t overlaps = 0;   ///< pairs of coplanar triangles with common interior points
  std::vector<std::array<std::uint32_t, 2>> crossing_pairs;  ///< the first of them (at most 16), ascending

  std::vector<ComponentReport> components;  ///< by first triangle
  std::uint32_t cavities = 0, inverted = 0;  ///< of them, counted if all are manifold
  std::uint32_t unknown_depths = 0;          ///< of them, those that may be either: their depth is not known
  std::int64_t genus = 0;       ///< sum over the components
  /// Signed volume and area of the whole. Doubles have no volume of sizes beyond 1e102 or below 1e-107 and no
  /// area of those beyond 1e154 or below 1e-161: there they are infinite, not a number or 0.
  double volume = 0, area = 0;

  bool closed() const {
    return open_edges == 0 && crowded_edges == 0 && repeated_indices == 0 && bad_indices == 0;
  }
  bool oriented() const { return misoriented_edges == 0; }
  bool manifold() const { return closed() && nonmanifold_vertices == 0; }
  /// Closed, oriented, combinatorial 2-manifold.
  bool good_topology() const { return oriented() && manifold(); }
};

/// Two triangles cross properly iff they lie in two planes and have a point in common that is an inner one of
/// both; one without area, which has no inner points, iff an edge of it passes through the inside of the
/// other. Decided exactly on the double coordinates, without tolerance; whatever only touches, shares a
/// vertex or an edge (by index or by equal coordinates) does not cross there. So surfaces that pass through
/// each other only along edges that both have are not found. Overlaps in a common plane are counted
/// separately. Expected O(n log n) for n triangles of a surface; a million takes seconds. Never fails.
CheckReport check_surface(const Surface& surface);

struct SectionCheckOptions {
  /// Vertices this close to a plane lie on it; a fraction of the diagonal of surface (triangles) and
  /// sections.
  double on_plane = 1e-6;
  /// Of frame_sections(), for check_framed_sections() only; a fraction of the diagonal of the contours.
  double plane_tolerance = 1e-3;
};

/// The solid of a surface against one section.
struct PlaneCheck {
  std::uint32_t plane = 0;  ///< position in the file; the first of those that are one plane
  double section_area = 0;  ///< of the given section (even-odd)
  double surface_area = 0;  ///< of the cross-section of the surface's solid
  double missing_area = 0;  ///< section without solid
  double extra_area = 0;    ///< solid without section
  /// Largest distance from a point of one boundary to the other boundary, both ways; +infinity if exactly one
  /// of the two is empty.
  double distance = 0;
  double off_plane = 0;  ///< largest distance from the plane of a surface vertex taken as lying on it
  // Of check_framed_sections() only:
  double section_off_plane = 0;     ///< largest distance of a section vertex from the plane of the file
  double section_displacement = 0;  ///< largest way of one to where it is compared

  double difference_area() const { return missing_area + extra_area; }
};

struct SectionCheck {
  std::vector<PlaneCheck> planes;                             ///< in the order of the sections
  double section_area = 0, missing_area = 0, extra_area = 0;  ///< sums
  /// The last two as fractions of section_area; infinite where that is 0. They tell what the areas don't at
  /// sizes beyond 1e154 or below 1e-161, where these are infinite or 0.
  double missing_share = 0, extra_share = 0;
  double distance = 0;                                        ///< largest
  double section_off_plane = 0, section_displacement = 0;     ///< largest
  double diagonal = 0;  ///< of the box of triangles and sections, the unit of `on_plane`

  double difference_area() const { return missing_area + extra_area; }
};

/// Cuts the surface's solid (even-odd) with every plane and compares with its section.
///
/// The cross-section is the union of the two limits of slices from above and from below: vertices within
/// `on_plane` of the plane count as lying on it, so a region with solid on one side only belongs to it, and
/// no offset blurs the result. Areas come from a trapezoid sweep, exact but for rounding: floor about 1e-14
/// of the squared diagonal; a vertex that is within `on_plane` by chance adds at most that height times the
/// cotangent of its slope. Distances are sampled at steps of 1/512 of the section's diagonal and at all
/// vertices; pieces of a boundary shorter than 1e-8 of it are not judged.
/// O((n + s) log s) a plane for n triangles and s boundary segments. Planes whose normal is 0 or that are not
/// finite report zeros; triangles and edges that name a point that is not there are left out.
SectionCheck check_sections(const Surface& surface, const Sections& sections,
                            const SectionCheckOptions& options = {});

/// The same with the sections as reconstruct() takes them (arrangement/framed_sections.h): several records of
/// one plane are united, planes fitted to their vertices and vertices brought on to them, contours without
/// area left out. What framing notes and warns of goes to the log of `context`. Errors: of frame_sections();
/// too_large for a coordinate of a section beyond 1e100.
Result<SectionCheck> check_framed_sections(const Surface& surface, const Sections& sections,
                                           const SectionCheckOptions& options = {},
                                           const Context& context = {});

}  // namespace crossloft
