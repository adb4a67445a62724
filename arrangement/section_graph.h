#pragma once
/// The sections as one exact graph over the arrangement: vertices with their signs against every plane, and
/// contours cut into walls that each lie in one face or on one edge of the arrangement.

#include <cstdint>
#include <span>
#include <vector>

#include "../geom/context.h"
#include "../geom/ids.h"
#include "../geom/lattice.h"
#include "../geom/result.h"
#include "complex.h"
#include "framed_sections.h"
#include "section_locator.h"
#include "sign_rows.h"

namespace crossloft {

/// A piece of a contour between two vertices.
struct Wall {
  std::uint32_t a = 0, b = 0;      ///< vertices, a < b in the finished graph
  std::uint32_t contour = 0;       ///< where it comes from: contour of the input plane, for messages
  std::uint32_t source_plane = 0;  ///< position in the file
  std::uint32_t line = 0;          ///< of the file
  bool inside_left = false;  ///< section on the left of a -> b, seen from the positive side of the plane
};

/// Two sections cross the same arrangement edge at different points, or one alone does.
struct Mismatch {
  std::uint32_t plane = kNone;  ///< canonical number of the plane whose contour crosses
  std::uint32_t other = kNone;  ///< of a plane through the same edge whose contour does not
  LatticePoint point;
};

struct CrossingStatistics {
  std::uint32_t on_line = 0;    ///< contour vertices that were crossings already
  std::uint32_t crossings = 0;  ///< contour vertices on lines, one for each plane they belong to
  std::uint32_t matched = 0;    ///< those that every plane through the line agrees on
  double largest_gap = 0;       ///< lattice units, between crossings that were matched
  double widest_pair = 0;       ///< the same with the matches that were taken back
  std::uint32_t unpaired = 0;   ///< crossings that found no partner, matches taken back not counted
  std::uint32_t undone = 0;     ///< matches taken back because contours would have crossed
  std::uint32_t merged_collinear = 0;
  std::uint32_t simplified = 0;  ///< contour vertices left out within the tolerance
  double deviation = 0;  ///< lattice units: largest distance of one of them from the wall in its place
  std::uint32_t disagreeing = 0;  ///< arrangement vertices inside one section, outside another
  std::vector<Mismatch> unmatched;
};

struct SectionGraph {
  std::vector<LatticePlane> planes;      ///< canonical order; bits of the sign rows
  std::vector<LatticePoint> points;      ///< by vertex, in lexicographic order, all different
  SignRows rows;                         ///< of the vertices, and of some that were tried
  std::vector<std::uint32_t> row_of;     ///< by vertex: its row
  std::vector<Location> locations;       ///< by vertex: the element of the arrangement it lies in
  std::vector<std::vector<Wall>> walls;  ///< by plane, sorted by (a, b)
  std::vector<std::vector<Location>> wall_locations;  ///< by plane and wall: the face or edge that it lies in
  CrossingStatistics statistics;

  std::uint32_t size() const { return static_cast<std::uint32_t>(points.size()); }
  SignView signs_of(std::uint32_t v) const { return rows[row_of[v]]; }
  std::span<const SignWord> positive_of(std::uint32_t v) const { return signs_of(v).pos; }
  std::span<const SignWord> zero_of(std::uint32_t v) const { return signs_of(v).zero; }
  /// -1, 0, +1: the side of plane p that vertex v is on.
  int sign(std::uint32_t v, std::uint32_t p) const { return sign_at(signs_of(v), PlaneId{p}); }
  /// How many planes both vertices are on.
  std::uint32_t common_planes(std::uint32_t u, std::uint32_t v) const;
  /// Whether the vertex is on two planes at least.
  bool on_line(std::uint32_t v) const { return rows.planes_through(row_of[v]) >= 2; }
  /// Whether both are on one line of planes: at least two planes are common.
  bool share_line(std::uint32_t u, std::uint32_t v) const {
    return on_line(u) && on_line(v) && common_planes(u, v) >= 2;
  }
  /// Adds a vertex and its exact signs; equal points are not merged here. Returns its number.
  std::uint32_t add(const LatticePoint& point);
  /// Adds vertices on plane p. `across`: the planes that meet it in a line; the others are parallel to it and
  /// see all of it from one side, so that they are asked once.
  void add_on_plane(std::span<const LatticePoint> list, std::span<const std::uint32_t> across);
  /// Takes out the vertex that was added last. REQUIRES: no wall has it.
  void take_back();
  /// Moves a vertex and renews its signs.
  void move(std::uint32_t v, const LatticePoint& point);
  /// An even-odd tester over the current walls of plane p; `ends` receives them and must outlive the tester.
  SectionLocator locator(std::uint32_t p, std::vector<WallEnds>& ends) const;
};

struct CrossingTolerances {
  double on = 0;     ///< lattice units: a contour vertex this near another plane is a crossing already,
                     ///< this near another wall of its plane it is on it
  double match = 0;  ///< lattice units: crossings of two sections this near are the same
  double simplify =
      0;  ///< lattice units: vertices within faces go if the contour moves no further; 0: all stay
};

/// Builds the graph: vertices near a line go onto it, contours are cut at all planes, crossings of different
/// sections are matched, collinear runs merged, contours simplified if a tolerance is given, arrangement
/// vertices inside closed sections added, walls oriented. `store` owns the new points and must be the one
/// that the arrangement was built with. Errors: self_crossing, cancelled. Complexity: O(n k) sign tests for n
/// vertices and k planes, k counting those that are not parallel; O(n log n) for numbering and matching and,
/// as contours mostly are, for conflicts, inner sides, straightening and simplifying: where many walls share
/// the strips and boxes of their locators, or many vertices lie in the boxes of the pieces that are replaced,
/// O(n^2).
Result<SectionGraph> build_section_graph(const FramedSections& framed, const Arrangement& arrangement,
                                         LatticePointStore& store, const CrossingTolerances& tolerances,
                                         const Context& context);

/// Empty if the graph keeps its invariants: exact signs, walls in one element each, the one it tells, on
/// arrangement edges cut at the vertices of all sections there, even degrees, no conflicts, inner sides as
/// even-odd has them.
std::string verify(const SectionGraph& graph, const Arrangement& arrangement);

}  // namespace crossloft
