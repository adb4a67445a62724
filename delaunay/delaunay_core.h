#pragma once
/// A triangulation from its first point on: waits for the first simplex, inserts the rest in a good order,
/// and hands out the result. Once for the plane and for space, for points (Delaunay) and for sites with
/// heights of their own (regular); the insertion itself is inserter.h.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "inserter.h"
#include "insertion_order.h"
#include "parallel_insertion.h"
#include "perturbation.h"
#include "simplex_store.h"

namespace crossloft::detail {

template <std::size_t D, class P>
class DelaunayCore {
 public:
  explicit DelaunayCore(const P& predicates) : predicates_(predicates), inserter_(predicates, growing_) {}
  DelaunayCore(const DelaunayCore&) = delete;  // its parts refer to each other
  DelaunayCore& operator=(const DelaunayCore&) = delete;

  /// Inserts the points of the predicates object from `first` on.
  void build(std::uint32_t first = 0);
  /// Inserts all points in the order of their indices: for points stored in insertion_order.
  void build_in_given_order(unsigned threads = 1);
  /// Inserts point i, searching from vertex `near` if the dimension is 2 and it is given. Returns the vertex
  /// that stands for it.
  std::uint32_t insert(std::uint32_t i, std::uint32_t near = kNone);

  int dimension() const { return basis_size_ - 1; }
  /// The vertex that stands for i, kNone if i is hidden.
  std::uint32_t kept(std::uint32_t i) const { return growing_.kept_of(i); }
  /// Finite cells and, per slot, their finite neighbours or kNone.
  void finite(std::vector<Simplex<D>>& vertices, std::vector<Simplex<D>>& neighbours) const;
  /// The same without a copy. Nothing else may be asked afterwards but the dimension and what is kept.
  void release(std::vector<Simplex<D>>& vertices, std::vector<Simplex<D>>& neighbours, unsigned threads = 1) {
    growing_.cells.release(vertices, neighbours, threads);
  }

  const P& predicates() const { return predicates_; }
  const SimplexStore<D>& cells() const { return growing_.cells; }
  std::uint32_t vertex_count() const {
    return growing_.cells.size() == 0
               ? 0
               : static_cast<std::uint32_t>(D + 1 + inserter_.gained() + gained_in_parallel_);
  }
  /// The first affinely independent points, dimension() + 1 of them.
  const std::array<std::uint32_t, D + 1>& basis() const { return basis_; }
  /// True iff `holds` for one of the inserted points. REQUIRES: less than full dimension.
  template <class Predicate>
  bool any_waiting(Predicate&& holds) const {
    return std::any_of(pending_.begin(), pending_.end(), holds) ||
           std::any_of(basis_.begin(), basis_.begin() + basis_size_, holds);
  }
  /// Interior edges of the last cavity (plane only).
  const std::vector<std::array<std::uint32_t, 2>>& removed_ridges() const {
    return inserter_.removed_ridges();
  }
  /// Some spoke of a vertex.
  Facet spoke(std::uint32_t vertex) const requires(D == 2) {
    return growing_.cells.spoke_of(growing_.incident[vertex + 1u], vertex);
  }
  bool in_conflict(std::uint32_t cell, std::uint32_t e) const { return inserter_.in_conflict(cell, e); }
  bool is_hidden(std::uint32_t e) const { return inserter_.is_hidden(e); }

 private:
  void make_room();
  void insert_the_rest(std::uint32_t i);
  std::uint32_t insert_in_parallel(unsigned threads) requires(D == 3);
  bool extends_basis(std::uint32_t i) const;
  void wait_for_basis(std::uint32_t i);
  void make_first_cells();
  void keep_lowest();

  const P& predicates_;
  GrowingTriangulation<D> growing_;
  Inserter<D, P> inserter_;
  std::array<std::uint32_t, D + 1> basis_{};  ///< the first affinely independent points
  int basis_size_ = 0;
  std::int64_t gained_in_parallel_ = 0;
  std::vector<std::uint32_t> pending_;  ///< points that wait for full dimension, but for the basis
};

}  // namespace crossloft::detail

#include "delaunay_core_impl.h"
