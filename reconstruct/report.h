#pragma once
/// What a reconstruction tells about itself, as plain numbers. Lengths in input units, seconds of wall clock,
/// `delaunay` and `pruning` added up over cells (and so over threads). Where a double is too small for an
/// area (of data below some 1e-154) or a volume (below 1e-103), it has few digits or is 0.

#include <cstdint>
#include <string>
#include <vector>

#include "../geom/ids.h"
#include "../geom/vec3.h"
#include "../prune/cell_topology.h"

namespace crossloft {

/// A crossing of one section's contour with the line of two planes that the other section does not have.
struct UnmatchedCrossing {
  std::uint32_t plane = kNone;        ///< position in the file of the plane whose contour crosses
  std::uint32_t other_plane = kNone;  ///< position in the file of the plane that it crosses
  double x = 0, y = 0, z = 0;
};

/// One plane of the input, after framing.
struct PlaneReport {
  std::uint32_t plane = kNone;  ///< position in the file
  std::uint32_t vertices = 0, edges = 0;
  double area = 0;          ///< of its section
  double flat_area = 0;     ///< part of it that no tetrahedron touches
  std::uint32_t flat_regions = 0;       ///< connected parts of that
  std::uint32_t thickened_regions = 0;  ///< connected parts of the section that were flat and got a plate
  double displacement = 0;  ///< largest way of a vertex from input to lattice
  double off_plane = 0;     ///< largest input distance of a vertex from its plane
};

/// Two parts of a cell's solid that became one, or did not for lack of confidence (prune/joins.h).
struct JoinReport {
  Vec3 a, b;              ///< a section vertex of each
  double confidence = 0;  ///< -1..1, of the weakest tetrahedron of the best way
  bool done = false;
};

/// One cell of the arrangement that holds section vertices.
struct CellReport {
  std::uint32_t faces = 0, vertices = 0;
  std::uint32_t tets_r0 = 0, tets_r1 = 0, tets_r2 = 0, tets_r3 = 0;  ///< after each step of pruning
  std::uint32_t bad_links = 0;     ///< vertices whose extended link is neither a disk nor a sphere
  CellTopology topology;           ///< of the solid with the sections
  std::uint32_t genus_before = 0;  ///< handles within the cell before growth
  std::uint32_t handles_asked = 0;  ///< that the sections ask for, mode natural
  bool grown = false;              ///< mode natural: growth had to decide
  std::uint32_t joined_alone = 0;  ///< by the second look, mode natural
  std::uint32_t opened = 0;        ///< walls of cavities, by the second look
  std::uint32_t dropped = 0;       ///< spikes (prune/spikes.h), mode natural
  std::vector<JoinReport> joins;   ///< mode natural
  std::vector<double> domes;       ///< confidences of the walls and domes that growth closed
};

struct StageSeconds {
  double input = 0, arrangement = 0, crossings = 0, faces = 0, cells = 0, branching = 0, delaunay = 0,
         pruning = 0, gluing = 0, separating = 0, total = 0;
};

/// Sums over the cells.
struct TopologyReport {
  std::uint32_t handles = 0;         ///< genus of cells
  std::uint32_t handles_before = 0;  ///< the same before growth took them out
  std::uint32_t handles_asked = 0;   ///< that the sections ask for: mode natural makes no others
  std::uint32_t grown_cells = 0;
  std::uint32_t bodies_joined = 0;  ///< small ones that nothing was joined with in any cell
  std::uint32_t walls_opened = 0;   ///< of cavities that one plane has seen or whose walls were not sure
  std::uint32_t spikes_dropped = 0;  ///< where a body ended in a tip that led far away
  std::uint32_t bridges = 0;        ///< edges within sections at which a bridge was built
  std::uint32_t bridge_handles = 0;  ///< handles that bridges have made instead of slits
  /// Of the edges that no cell holds together, those that stay pinched. Wedges of a cell's solid that reach
  /// such an edge without a section triangle of it are apart in the cell's count, too, and not counted here.
  std::uint32_t open_edges = 0;
  std::uint32_t joins = 0, refused_joins = 0;  ///< of sections within a cell
  double weakest_join = 1;                     ///< confidence
  std::uint32_t walls = 0;                     ///< parts of the outside beyond one a cell
  std::uint32_t voids = 0;                     ///< closed surfaces within one cell
};

/// Adds the figures of a cell to the sums.
void add_up(const CellReport& cell, TopologyReport& sum);

struct Report {
  std::string mode;  ///< natural, joint, paper or paper-literal
  StageSeconds seconds;
  double diagonal = 0;  ///< of the bounding box of all contours
  std::vector<PlaneReport> planes;
  std::vector<CellReport> cells;  ///< only cells with tetrahedra, in canonical order
  std::uint32_t arrangement_cells = 0, arrangement_faces = 0, arrangement_vertices = 0;

  double displacement = 0;  ///< largest over all planes, snapping to the lattice
  double off_plane = 0;
  std::uint32_t on_line_vertices =
      0;  ///< contour vertices that were crossings already and moved onto the line
  std::uint32_t crossings = 0, matched_crossings = 0;
  std::vector<UnmatchedCrossing> unmatched;
  double largest_match_gap = 0;  ///< longest way between two crossings that were matched
  std::uint32_t undone_matches = 0;  ///< taken back because contours of a section would have crossed
  std::uint32_t disagreeing_vertices =
      0;  ///< arrangement vertices that are inside one section and outside another
  std::uint32_t merged_collinear = 0;     ///< vertices dropped that snapping bent off a straight run
  std::uint32_t simplified_vertices = 0;  ///< contour vertices left out for Options::simplify
  double simplify_deviation = 0;  ///< largest distance of one of them from the contour edge in its place
  std::uint32_t branching_samples = 0;  ///< vertices added on branching and cutting diagrams
  std::uint32_t interior_points = 0;    ///< vertices added inside cells, mode natural
  std::uint32_t branching_faces = 0;    ///< faces that got some
  std::uint32_t edge_splits = 0;        ///< vertices added to make contours Delaunay-conforming

  double section_area = 0, flat_area = 0;
  std::uint32_t flat_regions = 0;  ///< connected section regions bare on both sides
  std::uint32_t thickened_regions =
      0;                 ///< section regions that were bare and got a plate for Options::thicken
  double thickness = 0;  ///< of the thickest plate
  std::uint32_t pinched_vertices = 0, pinched_edges = 0, split_edges = 0;
  std::uint64_t crossing_pairs =
      0;  ///< of triangles that crossed or overlapped when vertices had been rounded
  std::uint64_t crossing_pairs_left = 0;  ///< those that no short move could mend
  std::uint32_t mended_vertices = 0;      ///< moved for that
  std::uint32_t merged_vertices = 0;      ///< of these, at the places of others: triangles there have no area
  double mending = 0;                     ///< longest of these moves
  std::uint32_t vertex_copies = 0;        ///< vertices of the surface beyond one a point
  std::uint32_t separated_copies = 0;     ///< copies that moved away from the others
  std::uint32_t touching_copies = 0;      ///< copies left at the same place, beyond one each
  double separation = 0;                  ///< longest move
  std::uint64_t contacts =
      0;  ///< pairs of triangles that touch in the end; counted for Options::separation alone
  std::uint32_t solid_tets = 0, surface_triangles = 0, surface_vertices = 0;
  std::uint32_t bad_links = 0;
  double volume = 0;
  TopologyReport topology;
  std::vector<std::string> notes;  ///< everything the user should be told, one sentence each
  std::vector<std::string> warnings;
};

}  // namespace crossloft
