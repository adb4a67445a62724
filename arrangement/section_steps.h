#pragma once
/// The steps of build_section_graph, in order; internal to arrangement/. What a step leaves is of no use if
/// the context has been cancelled.

#include "section_graph.h"

namespace crossloft::section_steps {

/// Vertices of the framed sections and their walls, nothing moved.
SectionGraph start(const FramedSections& framed);

/// A few steps of a plane's lattice: how far snapping may bend what was straight, lattice units.
double snapping_tolerance(const LatticePlane& plane);

/// Equal walls cancel in pairs: a point crosses both or none. Sorts by (a, b), a < b; drops walls without
/// length.
void cancel_pairs(std::vector<Wall>& walls);

/// Contours of one plane that touch: a wall within `tolerance`, or the snapping tolerance, of another vertex
/// is led through that vertex, so that the touch survives all later rounding. Beyond the snapping tolerance
/// only as far as a quarter of the shortest edge there, and in no wall of the plane if contours would cross
/// by it. False if cancelled. REQUIRES:
/// nothing cut or moved yet.
bool join_touching(SectionGraph& graph, double tolerance, const Context& context);

/// On: a contour vertex within `tolerance` of another plane, measured on the input coordinates, is a crossing
/// that the slicer wrote; it moves onto the common line, or onto the arrangement vertex of two such lines.
/// Not if the way is longer than a quarter of its shorter edge or leads out of data_box(). REQUIRES: vertices
/// numbered as start() left them.
void move_onto_lines(SectionGraph& graph, const FramedSections& framed, LatticePointStore& store,
                     double tolerance, const Context& context);

/// Cuts every wall at every plane that it crosses. New vertices are line points, rounded along the line to an
/// integer coordinate such that no sign against another plane changes, else the arrangement vertex in the
/// way. False if a wall could not be brought to an end (a defect).
bool cut_at_planes(SectionGraph& graph, LatticePointStore& store, double snap, const Context& context);

/// Match: crossings of different sections on one arrangement edge merge by growing gap.
void match_crossings(SectionGraph& graph, const Arrangement& arrangement, LatticePointStore& store,
                     double tolerance, const Context& context);

/// Drops vertices of degree 2 that lie in the interior of a face and within a few lattice steps of the
/// segment that replaces them, but not exactly on it.
void merge_collinear_runs(SectionGraph& graph, const Context& context);

/// The arrangement vertices on a plane but not on the box, and which of them are outside of its closed
/// section.
struct PlaneCorners {
  std::vector<ArrVertexId> vertices;
  std::vector<std::uint8_t> outside;
};
/// Finds the inner sides of a plane's walls and its corners. REQUIRES: a locator of these walls, which don't
/// cross.
PlaneCorners orient_walls(SectionGraph& graph, const Arrangement& arrangement, std::uint32_t p,
                          const SectionLocator& locator);

/// What unify() knows of a plane.
struct SoundPlane {
  bool is_sound = false;  ///< its walls are known to be without conflicts, and oriented
  PlaneCorners corners;   ///< if so
};

/// Equal points become one vertex, walls that touch are cut there, doubled walls cancel, unused vertices go,
/// and everything is put into lexicographic order. `planes`: by plane. False if cancelled.
bool unify(SectionGraph& graph, const Arrangement& arrangement, std::vector<SoundPlane>& planes,
           const Context& context);

/// Drops contour vertices in the interior of faces as long as all that were dropped stay within `tolerance`
/// of the wall in their place, contours neither cross nor vanish, and sections stay the same on the lines of
/// planes: see section_simplify.cpp. REQUIRES: unify() done, contours don't cross.
void simplify_contours(SectionGraph& graph, double tolerance, const Context& context = {});

/// Takes out the vertices without a wall.
void drop_bare_vertices(SectionGraph& graph, const Context& context);

/// Adds the arrangement vertices that lie in the closed section of one of their planes. Walls stay what they
/// are, inner sides too: none has such a vertex in its interior, and their ends keep their order.
void add_arrangement_vertices(SectionGraph& graph, const Arrangement& arrangement,
                              std::span<const SoundPlane> planes, const Context& context);

/// True iff the ends of the wall are on different sides of a plane.
bool crosses_a_plane(const SectionGraph& graph, const Wall& wall);

/// Where vertices lie, asked once for all of one row. REQUIRES: none is added or moved meanwhile.
class RowLocations {
 public:
  RowLocations(const SectionGraph& graph, const Arrangement& arrangement)
      : graph_(graph), arrangement_(arrangement), of_(graph.rows.size()), known_(graph.rows.size(), 0) {}
  Location of(std::uint32_t v) {
    const std::uint32_t row = graph_.row_of[v];
    if (known_[row] == 0) of_[row] = arrangement_.locate(graph_.rows[row]), known_[row] = 1;
    return of_[row];
  }

 private:
  const SectionGraph& graph_;
  const Arrangement& arrangement_;
  std::vector<Location> of_;  ///< by row, like known_
  std::vector<std::uint8_t> known_;
};

/// The face or edge of the arrangement that holds the open wall; not found if the wall crosses a plane. The
/// finished graph keeps it by wall.
Location wall_location(const SectionGraph& graph, const Arrangement& arrangement, const Wall& wall);

}  // namespace crossloft::section_steps
