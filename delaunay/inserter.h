#pragma once
/// Inserts points into a triangulation of full dimension: the one loop of the incremental algorithm, for the
/// plane and for space, for points (Delaunay) and for sites with heights of their own (regular).
///
/// A ghost vertex closes the triangulation to a sphere: each hull facet is the finite facet of one ghost
/// cell. A point e is in conflict with a finite cell iff it is inside its perturbed ball, with a ghost cell
/// iff it is strictly beyond the hull facet, or on the facet's plane and in conflict with the finite cell
/// behind it.
///
/// *Why the cell behind can stand in for the facet's own circle.* For e on the plane of the facet f the
/// barycentric coordinate of the apex of the cell behind is 0, so the hyperplane of perturbation.h, taken at
/// e, reads the heights of f alone: the answer is that of the perturbed circle of f in its plane.
///
/// *Why no flat cell is ever made.* A new cell joins e to a facet f between a cell in conflict and one not.
/// If e is on the plane of f, both cells answer by the same perturbed circle of f (the argument above holds
/// for finite cells, ghosts are defined so), hence both alike: f is not on the boundary. Two ghosts that meet
/// over a hull ridge whose line holds e agree for the same reason, one dimension down.
///
/// *Hidden sites.* The lower hull only ever goes down, so a site above it is out for good: one that comes and
/// is not in conflict with the cell that holds it, or one that is a vertex and loses all its cells to the
/// cavity. The vertices of the cavity that are not on its rim are these. The cavity is a ball and its rim a
/// sphere with a known number of vertices (Euler), so counting those of the cavity tells whether there are
/// any. Of sites in one place the lower one is in conflict with every cell of the other: nothing special
/// happens. Sources: Bowyer (1981), Watson (1981).

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../geom/inline_filters.h"
#include "local_vertices.h"
#include "perturbation.h"
#include "scratch.h"
#include "simplex_store.h"
#include "tet_mesh.h"

namespace crossloft::detail {

/// A triangulation of full dimension while it grows; several inserters may share it (division.h).
template <std::size_t D>
struct GrowingTriangulation {
  SimplexStore<D> cells;
  std::vector<std::uint32_t> kept;  ///< grows on the first duplicate or hidden one; identity beyond
  std::vector<std::uint32_t>
      incident;  ///< in the plane only, of vertex v at v + 1: one of its cells, kNone before

  std::uint32_t kept_of(std::uint32_t i) const { return i < kept.size() ? kept[i] : i; }
};

/// The cells that an inserter may look at closely and change: those whose vertices are all its own.
struct Everywhere {
  static constexpr bool kBounded = false;
  template <std::size_t N>
  bool owns(const std::array<std::uint32_t, N>&) const {
    return true;
  }
  bool owns(std::uint32_t) const { return true; }
};

/// Cells that were given back, and a range of cells never used.
struct CellPool {
  std::vector<std::uint32_t> freed;
  std::uint32_t next = 0, end = 0;
  bool ran_dry = false;  ///< too few cells for some insertion

  std::size_t size() const { return freed.size() + (end - next); }
};

template <std::size_t D, class P, class Territory = Everywhere>
class Inserter {
 public:
  Inserter(const P& predicates, GrowingTriangulation<D>& triangulation, Territory territory = {})
      : predicates_(predicates), shared_(triangulation), cells_(triangulation.cells), territory_(territory) {}

  /// Points may have come to the predicates object. Call it before the first insertion too.
  void see_points();
  /// Inserts point i, searching from the hint. False if it was left out because its cavity reaches beyond the
  /// territory, or the pool is empty.
  bool insert(std::uint32_t i) { return insert(i, hint_); }
  /// Whether insertions tell of the edges that they remove (plane only).
  void tell_removed(bool tell) { tells_removed_ = tell; }
  bool insert(std::uint32_t i, std::uint32_t start);

  /// A cell to start the next search from. REQUIRES: it is owned.
  void set_hint(std::uint32_t cell) { hint_ = cell; }
  std::uint32_t hint() const { return hint_; }
  /// A cell that this inserter made is still in the triangulation.
  bool is_there(std::uint32_t cell) const { return !cells_.is_free(cell) && !cells_.is_ghost(cell); }
  CellPool& pool() { return pool_; }
  /// How many vertices have come, less those that were hidden.
  std::int64_t gained() const { return gained_; }
  /// Interior edges of the last cavity (plane only).
  const std::vector<std::array<std::uint32_t, 2>>& removed_ridges() const { return removed_; }

  /// REQUIRES: e is no vertex of a finite cell asked, nor of the one behind a ghost cell.
  bool in_conflict(std::uint32_t cell, std::uint32_t e) const;
  /// True iff a site that is no vertex, nor equal to one, is above the lower hull.
  bool is_hidden(std::uint32_t e) const { return is_above(locate(e, hint_), e); }
  void note_incident(std::uint32_t cell);
  /// Room for what is noted of the vertex, in the plane.
  void expect_incident(std::uint32_t vertex);

 private:
  /// A facet of the cavity's boundary, from both sides.
  struct Rim {
    Facet inside, outside;
  };
  /// A new cell: its facet on the rim from both sides, and the local numbers of that facet's vertices.
  struct StarCell {
    Facet base, outside;
    std::array<std::uint32_t, 3> numbers;
  };
  static constexpr bool kLifts = D == 3 && LiftsPoints<P> && kInlineFilters;
  static constexpr bool kNumbersVertices = D == 3 || HasHeights<P>;

  /// The cell of a facet is owned. REQUIRES: so is the one on its other side: all vertices but one are the
  /// same.
  bool owns_beyond(Facet f) const { return territory_.owns(cells_.vertices(f.cell())[f.slot()]); }
  std::uint32_t locate(std::uint32_t e, std::uint32_t start) const;
  std::uint32_t equal_vertex(std::uint32_t cell, std::uint32_t e) const;
  bool is_above(std::uint32_t cell, std::uint32_t e) const;
  bool ghost_conflict(std::uint32_t cell, std::uint32_t e) const;
  bool keep(std::uint32_t i, std::uint32_t vertex);

  bool dig(std::uint32_t e, std::uint32_t start);
  void start_cavity(std::uint32_t e, std::uint32_t start);
  void expect_vertices(std::size_t more);
  void note_vertex(std::uint32_t v, std::uint32_t e);
  bool look_around(std::uint32_t e, std::size_t begin, std::size_t end);
  void ask(std::uint32_t e);
  void lift_apexes(std::uint32_t e);
  bool conflicts(std::uint32_t cell, std::uint32_t e) const;
  void note_dug(Facet next, std::uint32_t e);
  void collect_rim();
  void note_removed(std::uint32_t cell, std::size_t slot);
  void forget_marks();

  std::uint32_t take_cell();
  Facet make_cell(const Rim& rim, std::uint32_t e);
  void fill(std::uint32_t e);
  void fill_by_table(std::uint32_t e) requires(D == 3);
  void fill_cycle(std::uint32_t e) requires(D == 2);
  void join_by_turning(Facet inside);
  Facet around_ridge(Facet inside, std::size_t slot) const;
  void hide_inner_vertices();
  void give_back();

  const P& predicates_;
  GrowingTriangulation<D>& shared_;
  SimplexStore<D>& cells_;
  Territory territory_;
  CellPool pool_;
  std::uint32_t hint_ = 0;
  std::int64_t gained_ = 0;
  LiftedError lifted_error_;  ///< of a determinant of rows_

  Scratch<std::uint32_t> cavity_, outside_;  ///< cells that are marked
  Scratch<Facet> wave_;                      ///< ways from the cavity to the cells that are asked next
  Scratch<std::uint8_t> answers_;            ///< their answers
  Scratch<Rim> rim_;
  LocalVertices local_;            ///< vertices of the cavity and, if they are lifted, of the cells around it
  std::vector<LiftedRow> rows_;    ///< of the local vertices
  std::size_t dug_vertices_ = 0;   ///< vertices of the cavity, the ghost too, where some can be hidden
  std::vector<std::uint8_t> dug_;  ///< by local number, as far as needed: in the cavity
  Scratch<StarCell> star_;
  std::vector<Facet>
      edges_;  ///< of new cells by the directed edge of the rim that they have; in the plane by its start
  bool tells_removed_ = true;
  std::vector<std::array<std::uint32_t, 2>> removed_;
};

}  // namespace crossloft::detail

#include "inserter_cavity_impl.h"
#include "inserter_impl.h"
