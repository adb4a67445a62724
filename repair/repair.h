#pragma once
/// Dirty sections made fit for reconstruction: planes, chains, crossing contours, tiny loops, and sections
/// that disagree on the common lines of their planes. Every change is listed.

#include <cstdint>
#include <string>
#include <vector>

#include "../arrangement/sections.h"
#include "../geom/context.h"
#include "../geom/result.h"
#include "../geom/vec3.h"

namespace crossloft {

/// Lengths are fractions of the diagonal of the box around all contours that enclose an area. Open ones
/// count, but where all others together were no more than a tiny loop beside them. Each step can be switched
/// off.
struct RepairOptions {
  /// No vertex or contour that stays moves further, nor does a plane that is turned, whatever the tolerances
  /// below allow; what would have to is left as it is and listed. But for steps of the grid, 2^-28.
  double limit = 0.1;

  bool planes = true;             ///< sign of D, planes that miss their vertices, nearly equal planes
  double plane_tolerance = 1e-6;  ///< vertices further from their plane are moved onto it
  double same_plane = 1e-6;       ///< planes nearer than this over the data become one

  bool chains = true;       ///< open chains, repeated vertices, spikes
  double close_gap = 1e-2;  ///< ends of open chains nearer than this are joined
  double repeated = 1e-9;   ///< neighbours on a contour nearer than this become the first, in x, y, z
  double spike = 1e-7;      ///< a vertex where the contour turns back on itself within this width goes

  bool crossings = true;  ///< contours that cross or overlap: even-odd

  bool loops = true;        ///< contours without area, tiny loops, runs that are nearly straight
  double tiny_loop = 1e-6;  ///< loops that a box of this size holds go
  double collinear =
      1e-10;  ///< a vertex that is no further off the line of its neighbours, and not on it, goes

  bool agreement = true;  ///< sections that disagree on common lines
  double agree = 1e-5;    ///< crossings that differ by less are left to the matching of the reconstruction
};

enum class RepairKind : std::uint8_t {
  offset_sign,        ///< D of a plane had the wrong sign
  plane_fitted,       ///< normal or D of a plane fitted to its vertices
  onto_plane,         ///< vertices of a contour moved onto their plane
  planes_united,      ///< the sections of nearly equal planes united, those within others read by even-odd
  contour_closed,     ///< ends of a chain joined
  contour_left_out,   ///< a chain that does not close, or a contour gone as planes or vertices were united
  repeated_vertices,  ///< vertices of a contour in the place of their neighbour
  spikes,             ///< vertices where a contour turned back on itself
  crossings,          ///< a contour that crossed itself or others, read by even-odd
  no_area,            ///< a contour on a line or a point, as the reconstruction drops it
  tiny_loop,          ///< a loop too small to be meant, also one whose vertices became one
  nearly_straight,    ///< vertices of a contour that bent a straight run by a hair
  agreed,             ///< a section changed next to a common line, so that it agrees with the others there
  pieces_left_out,    ///< small loops that remained where a section was changed to agree
  borders_left_out,   ///< borders between two materials of a section that was changed
  left_as_it_is,      ///< needs more than the limit, or no way was found: not repaired
};

/// True of what a repair leaves undone: good data would not have it.
constexpr bool is_left(RepairKind kind) {
  return kind == RepairKind::left_as_it_is || kind == RepairKind::contour_left_out;
}

/// The name of a kind in reports, "offset-sign" and so on.
const char* name_of(RepairKind kind);

/// One change. Planes, contours and vertices count from 0 as in the file; kNone where they do not apply, and
/// where they are new.
struct RepairChange {
  RepairKind kind = RepairKind::left_as_it_is;
  std::uint32_t plane = kNone, contour = kNone, vertex = kNone;
  std::uint32_t count = 1;  ///< of the vertices, pieces of contour or lines it is about
  double distance = 0;      ///< input units: the longest way of a point; of what is left: that it would need
  Vec3 point;               ///< where, or where first
  std::string text;         ///< one sentence
};

struct Repair {
  Sections sections;                   ///< planes in the order of the file, those that were united left out
  std::vector<std::uint32_t> sources;  ///< by plane of `sections`: its position in the file
  std::vector<RepairChange> changes;   ///< in the order of the steps, within a step by plane as it is now
  double diagonal = 0;                 ///< input units
  double largest_displacement = 0;     ///< input units: of a contour, from where it was to where it is
  std::uint32_t rounds = 0;            ///< of the agreement: in each one all lines were looked at
  std::uint32_t left = 0;              ///< changes that is_left() holds for
};

/// Repairs. What no step has a reason to touch stays as it is to the bit, and repairing the result again
/// changes nothing, but where the diagonal is another one since contours went, where something was left
/// because of the limit, which counts from where things are, or with tolerances far above the default ones.
/// The geometry of the result does not depend on the order of planes, contours and vertices. Errors: usage
/// (an option out of range), no_plane, not_finite, zero_normal, index_out_of_range, too_large, out_of_memory,
/// cancelled. O(n log n) for n vertices where there is nothing to repair, plus O(k^2) common lines of k
/// planes with O(n) each.
Result<Repair> repair_sections(const Sections& sections, const RepairOptions& options = {},
                               const Context& context = {});

}  // namespace crossloft
