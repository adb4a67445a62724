#pragma once
/// Storage of a triangulation of dimension D: 32-bit indices, freed cells used again at once.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "../geom/failing.h"
#include "../geom/ids.h"
#include "in_parallel.h"
#include "large_pages.h"

namespace crossloft::detail {

/// The vertex at infinity. It is always in the last slot of its cell.
inline constexpr std::uint32_t kGhost = kNone;

template <std::size_t D>
using Simplex = std::array<std::uint32_t, D + 1>;

/// A facet as seen from one of its two cells: the one opposite `slot`. Packed, hence fewer than 2^30 cells.
class Facet {
 public:
  constexpr Facet() = default;
  constexpr Facet(std::uint32_t cell, std::size_t slot)
      : code_(cell << 2 | static_cast<std::uint32_t>(slot)) {}
  static constexpr Facet of_code(std::uint32_t code) {
    Facet facet;
    facet.code_ = code;
    return facet;
  }
  constexpr std::uint32_t cell() const { return code_ >> 2; }
  constexpr std::size_t slot() const { return code_ & 3; }
  constexpr std::uint32_t code() const { return code_; }
  friend constexpr bool operator==(Facet, Facet) = default;

 private:
  std::uint32_t code_ = kNone;
};

/// What an insertion knows of a cell.
enum class Mark : std::uint8_t { none, outside, cavity };

/// Cells with vertices, neighbours and marks. Every cell is oriented positively; that of a ghost cell is the
/// one it has when the ghost is replaced by a point outside the hull facet (opposite the last slot).
template <std::size_t D>
class SimplexStore {
 public:
  /// As many as a Facet tells apart, and from none.
  static constexpr std::size_t kMostCells = (std::size_t{1} << 30) - 1;

  std::uint32_t size() const { return static_cast<std::uint32_t>(vertices_.size()); }
  const Simplex<D>& vertices(std::uint32_t cell) const { return vertices_[cell]; }
  /// The same facet seen from the cell on its other side.
  Facet across(Facet f) const { return Facet::of_code(neighbours_[f.cell()][f.slot()]); }
  bool is_ghost(std::uint32_t cell) const { return vertices_[cell][D] == kGhost; }
  bool is_free(std::uint32_t cell) const { return vertices_[cell][0] == kNone; }

  /// Makes room for a number of cells in all: a guess, for speed.
  void reserve(std::size_t cells) {
    cells = std::min(cells, kMostCells);
    reserve_in_large_pages(vertices_, cells);
    reserve_in_large_pages(neighbours_, cells);
    reserve_in_large_pages(marks_, cells);
  }
  /// Room is left for fewer cells than an insertion may need; by so many are few cells doubled early, no
  /// oftener.
  bool is_nearly_full() const {
    return vertices_.capacity() - vertices_.size() < std::min(kManyPerInsertion, vertices_.size() / 4);
  }
  /// A new free cell; fails as an allocation does if there are kMostCells.
  std::uint32_t grow() {
    if (vertices_.size() >= kMostCells) [[unlikely]]
      fail_as_allocation();
    if (vertices_.size() == vertices_.capacity()) [[unlikely]]
      reserve(2 * vertices_.size() + 64);
    vertices_.push_back(free_cell());
    neighbours_.push_back(no_neighbours());
    marks_.push_back(Mark::none);
    return size() - 1;
  }
  /// So many cells in all, those beyond size() free. Fails as grow().
  void grow_to(std::size_t cells, unsigned threads) {
    if (cells > kMostCells) fail_as_allocation();
    if (cells > vertices_.capacity()) reserve(std::max(cells, 2 * vertices_.size()));
    provide_pages_for(vertices_, cells, threads);
    provide_pages_for(neighbours_, cells, threads);
    vertices_.resize(cells, free_cell());
    neighbours_.resize(cells, no_neighbours());
    marks_.resize(cells, Mark::none);
  }
  void set_vertices(std::uint32_t cell, const Simplex<D>& vertices) { vertices_[cell] = vertices; }
  /// With another vertex in one slot. In memory: whole copies of what was just written in part are slow.
  void copy_vertices(std::uint32_t from, std::uint32_t to, std::size_t slot, std::uint32_t vertex) {
    vertices_[to] = vertices_[from];
    vertices_[to][slot] = vertex;
  }
  void set_free(std::uint32_t cell) { vertices_[cell] = free_cell(); }
  void link(Facet a, Facet b) {
    redirect(a, b);
    redirect(b, a);
  }
  /// Across `from` is now `to`, but not the other way round.
  void redirect(Facet from, Facet to) { neighbours_[from.cell()][from.slot()] = to.code(); }

  /// REQUIRES: it is one of the cell's.
  std::size_t slot_of(std::uint32_t cell, std::uint32_t vertex) const {
    const auto& v = vertices(cell);
    std::size_t slot = D;
    for (std::size_t k = 0; k < D; ++k) slot = v[k] == vertex ? k : slot;
    return slot;
  }

  /// Asks for the vertices of a cell that will be looked at soon: no effect but speed.
  void prefetch_vertices([[maybe_unused]] std::uint32_t cell) const {
#if defined(__GNUC__)
    __builtin_prefetch(&vertices_[cell]);
#endif
  }
  void prefetch_neighbours([[maybe_unused]] std::uint32_t cell) const {
#if defined(__GNUC__)
    __builtin_prefetch(&neighbours_[cell]);
#endif
  }

  Mark mark(std::uint32_t cell) const { return marks_[cell]; }
  /// All three without a branch.
  void set_mark(std::uint32_t cell, bool in_cavity) { marks_[cell] = static_cast<Mark>(1 + in_cavity); }
  void clear_mark(std::uint32_t cell) { marks_[cell] = Mark::none; }
  /// Marks it outside unless it has a mark; true iff it had none.
  bool mark_if_new(std::uint32_t cell) {
    const auto mark = static_cast<std::uint8_t>(marks_[cell]);
    marks_[cell] = static_cast<Mark>(mark | (mark == 0));
    return mark == 0;
  }

  /// In the plane: a spoke is the edge from a vertex that runs counter-clockwise before its cell, stored as
  /// the facet opposite the cell's third vertex. `ahead` is its far end, `turn` the next spoke
  /// counter-clockwise around the vertex.
  std::uint32_t ahead(Facet spoke) const requires(D == 2) {
    return vertices(spoke.cell())[(spoke.slot() + 2) % 3];
  }
  Facet turn(Facet spoke) const requires(D == 2) {
    // Cell (v, w, x), spoke vw opposite x. The next one is vx, which the cell across xv sees opposite its
    // third vertex: across the facet opposite w.
    return across({spoke.cell(), (spoke.slot() + 2) % 3});
  }
  Facet spoke_of(std::uint32_t cell, std::uint32_t vertex) const requires(D == 2) {
    const auto& v = vertices(cell);
    const std::size_t at = v[0] == vertex ? 0 : v[1] == vertex ? 1 : 2;
    return {cell, (at + 2) % 3};
  }

  /// Moves the finite cells to the front, one of the last into each gap, and hands out the arrays: vertices,
  /// and neighbours as plain cell numbers, kNone across the hull. The store is empty afterwards. Uses no
  /// memory of its own.
  void release(std::vector<Simplex<D>>& vertices, std::vector<Simplex<D>>& neighbours, unsigned threads = 1);

 private:
  static constexpr std::size_t kManyPerInsertion = 4096;
  static constexpr Simplex<D> free_cell() {
    Simplex<D> cell{};
    cell[0] = kNone;
    return cell;
  }
  static constexpr Simplex<D> no_neighbours() {
    Simplex<D> codes{};
    codes.fill(Facet().code());
    return codes;
  }
  void remove_ghosts();
  void close_gaps();
  void move(std::uint32_t from, std::uint32_t to);

  std::vector<Simplex<D>> vertices_;
  std::vector<Simplex<D>> neighbours_;  ///< codes of facets
  std::vector<Mark> marks_;
};

template <std::size_t D>
void SimplexStore<D>::release(std::vector<Simplex<D>>& vertices, std::vector<Simplex<D>>& neighbours,
                              unsigned threads) {
  marks_ = {};
  remove_ghosts();
  close_gaps();
  in_slices(threads, neighbours_.size(), [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t cell = begin; cell < end; ++cell)
      for (std::uint32_t& code : neighbours_[cell])
        code = code == Facet().code() ? kNone : Facet::of_code(code).cell();
  });
  vertices = std::exchange(vertices_, {});
  neighbours = std::exchange(neighbours_, {});
}

template <std::size_t D>
void SimplexStore<D>::remove_ghosts() {
  for (std::uint32_t cell = 0; cell < size(); ++cell) {
    if (is_free(cell) || !is_ghost(cell)) continue;
    redirect(across({cell, D}), Facet());
    set_free(cell);
  }
}

/// REQUIRES: no ghosts.
template <std::size_t D>
void SimplexStore<D>::close_gaps() {
  std::uint32_t end = size();
  for (std::uint32_t cell = 0; cell < end; ++cell) {
    if (!is_free(cell)) continue;
    while (end > cell && is_free(end - 1)) --end;
    if (end > cell) move(--end, cell);
  }
  vertices_.resize(end);
  neighbours_.resize(end);
}

template <std::size_t D>
void SimplexStore<D>::move(std::uint32_t from, std::uint32_t to) {
  vertices_[to] = vertices_[from];
  neighbours_[to] = neighbours_[from];
  for (std::size_t slot = 0; slot <= D; ++slot)
    if (const Facet twin = across({to, slot}); twin != Facet()) redirect(twin, {to, slot});
}

}  // namespace crossloft::detail
