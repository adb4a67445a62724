#pragma once
/// The incremental algorithm, once for the plane and for space, for points (Delaunay) and for sites with
/// heights of their own (regular).
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

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "insertion_order.h"
#include "perturbation.h"
#include "simplex_store.h"

namespace crossloft::detail {

template <std::size_t D, class P>
class DelaunayCore {
 public:
  explicit DelaunayCore(const P& predicates) : predicates_(predicates) {}

  /// Inserts the points of the predicates object from `first` on.
  void build(std::uint32_t first = 0);
  /// Inserts all points in the order of their indices: for points stored in insertion_order.
  void build_in_given_order();
  /// Inserts point i, searching from vertex `near` if the dimension is 2 and it is given.
  std::uint32_t insert(std::uint32_t i, std::uint32_t near = kNone);

  int dimension() const { return basis_size_ - 1; }
  /// The vertex that stands for i, kNone if i is hidden.
  std::uint32_t kept(std::uint32_t i) const { return i < kept_.size() ? kept_[i] : i; }
  /// Finite cells and, per slot, their finite neighbours or kNone.
  void finite(std::vector<Simplex<D>>& vertices, std::vector<Simplex<D>>& neighbours) const;

  const P& predicates() const { return predicates_; }
  const SimplexStore<D>& cells() const { return cells_; }
  std::uint32_t vertex_count() const { return vertex_count_; }
  /// The first affinely independent points, dimension() + 1 of them.
  const std::array<std::uint32_t, D + 1>& basis() const { return basis_; }
  /// True iff `holds` for one of the inserted points. REQUIRES: less than full dimension.
  template <class Predicate>
  bool any_waiting(Predicate&& holds) const {
    return std::any_of(pending_.begin(), pending_.end(), holds) ||
           std::any_of(basis_.begin(), basis_.begin() + basis_size_, holds);
  }
  /// Interior edges of the last cavity (plane only).
  const std::vector<std::array<std::uint32_t, 2>>& removed_ridges() const { return removed_; }
  /// Some spoke of a vertex.
  Facet spoke(std::uint32_t vertex) const requires(D == 2) {
    return cells_.spoke_of(incident_[vertex], vertex);
  }

  /// REQUIRES: e is no vertex of a finite cell asked, nor of the one behind a ghost cell.
  bool in_conflict(std::uint32_t cell, std::uint32_t e) const;
  /// True iff a site that is no vertex, nor equal to one, is above the lower hull. REQUIRES: full dimension.
  bool is_hidden(std::uint32_t e) const { return is_above(locate(e, hint_), e); }

 private:
  /// A facet of the cavity's boundary, from both sides.
  struct Rim {
    Facet inside, outside;
  };

  void make_room();
  /// A vertex of the cavity has the stamp of the insertion and its place in dug_vertices_.
  struct DugMark {
    std::uint32_t stamp = 0, number = 0;
  };
  static constexpr bool kNumbersVertices = D == 3 || HasHeights<P>;

  bool extends_basis(std::uint32_t i) const;
  void wait_for_basis(std::uint32_t i);
  void make_first_cells();
  std::uint32_t insert_in_full_dimension(std::uint32_t i, std::uint32_t start);
  std::uint32_t locate(std::uint32_t e, std::uint32_t start) const;
  std::uint32_t equal_vertex(std::uint32_t cell, std::uint32_t e) const;
  bool is_above(std::uint32_t cell, std::uint32_t e) const;
  std::uint32_t keep(std::uint32_t i, std::uint32_t vertex);
  bool ghost_conflict(std::uint32_t cell, std::uint32_t e) const;
  void dig(std::uint32_t e, std::uint32_t start);
  void note_removed(std::uint32_t cell, std::size_t slot);
  void note_vertex(std::uint32_t v);
  void fill(std::uint32_t e);
  void join_by_table() requires(D == 3);
  void join_by_turning(Facet inside);
  Facet around_ridge(Facet inside, std::size_t slot) const;
  void hide_inner_vertices();
  void note_incident(std::uint32_t cell);
  void keep_lowest();

  const P& predicates_;
  SimplexStore<D> cells_;
  std::array<std::uint32_t, D + 1> basis_{};  ///< the first affinely independent points
  int basis_size_ = 0;
  std::vector<std::uint32_t> pending_;   ///< points that wait for full dimension, but for the basis
  std::vector<std::uint32_t> kept_;      ///< grows on the first duplicate or hidden one; identity beyond
  std::vector<std::uint32_t> incident_;  ///< a cell of each vertex, in the plane only
  std::vector<std::array<std::uint32_t, 2>> removed_;
  std::vector<std::uint32_t> cavity_;
  std::vector<Rim> rim_;
  std::vector<std::uint32_t>
      dug_vertices_;                ///< of the cavity, the ghost too; in space or if some can be hidden
  std::vector<DugMark> dug_marks_;  ///< by vertex + 1, the ghost in front
  std::vector<std::array<std::uint32_t, 3>> rim_numbers_;  ///< of the vertices of each facet of the rim
  std::vector<Facet> edges_;  ///< of new cells by the directed edge of the rim that they have
  std::uint32_t vertex_count_ = 0;
  std::uint32_t stamp_ = 0;  ///< mark of cells in the cavity; stamp_ + 1 of cells found outside it
  std::uint32_t hint_ = 0;
};

}  // namespace crossloft::detail

#include "delaunay_cavity_impl.h"
#include "delaunay_core_impl.h"
