#pragma once
/// Storage of a triangulation of dimension D: 32-bit indices, freed cells used again at once.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../geom/ids.h"

namespace crossloft::detail {

/// The vertex at infinity. It is always in the last slot of its cell.
inline constexpr std::uint32_t kGhost = kNone;

template <std::size_t D>
using Simplex = std::array<std::uint32_t, D + 1>;

/// A facet as seen from one of its two cells: the one opposite `slot`. Packed, hence at most 2^30 cells.
class Facet {
 public:
  constexpr Facet() = default;
  constexpr Facet(std::uint32_t cell, std::size_t slot)
      : code_(cell << 2 | static_cast<std::uint32_t>(slot)) {}
  constexpr std::uint32_t cell() const { return code_ >> 2; }
  constexpr std::size_t slot() const { return code_ & 3; }
  friend constexpr bool operator==(Facet, Facet) = default;

 private:
  std::uint32_t code_ = kNone;
};

/// Cells with vertices and neighbours. Every cell is oriented positively; that of a ghost cell is the one it
/// has when the ghost is replaced by a point outside the hull facet (opposite the last slot).
template <std::size_t D>
class SimplexStore {
 public:
  std::uint32_t size() const { return static_cast<std::uint32_t>(cells_.size()); }
  const Simplex<D>& vertices(std::uint32_t cell) const { return cells_[cell].vertices; }
  /// The same facet seen from the cell on its other side; Facet() in a cell just added.
  Facet across(Facet f) const { return cells_[f.cell()].neighbours[f.slot()]; }
  bool is_ghost(std::uint32_t cell) const { return cells_[cell].vertices[D] == kGhost; }
  bool is_free(std::uint32_t cell) const { return cells_[cell].vertices[0] == kNone; }

  /// Makes room for a number of cells in all: a guess, for speed.
  void reserve(std::size_t cells) {
    cells_.reserve(cells);
    marks_.reserve(cells);
  }
  std::uint32_t add(const Simplex<D>& vertices) {
    if (free_.empty()) {
      cells_.push_back({vertices, {}});
      marks_.push_back(0);
      return size() - 1;
    }
    const std::uint32_t cell = free_.back();
    free_.pop_back();
    cells_[cell] = {vertices, {}};
    return cell;
  }
  void release(std::uint32_t cell) {
    cells_[cell].vertices[0] = kNone;
    free_.push_back(cell);
  }
  void link(Facet a, Facet b) {
    cells_[a.cell()].neighbours[a.slot()] = b;
    cells_[b.cell()].neighbours[b.slot()] = a;
  }
  /// Across `from` is now `to`, but not the other way round.
  void redirect(Facet from, Facet to) { cells_[from.cell()].neighbours[from.slot()] = to; }
  void rename(std::uint32_t cell, const Simplex<D>& vertices) { cells_[cell].vertices = vertices; }

  /// REQUIRES: it is one of the cell's.
  std::size_t slot_of(std::uint32_t cell, std::uint32_t vertex) const {
    const auto& v = vertices(cell);
    std::size_t slot = D;
    for (std::size_t k = 0; k < D; ++k) slot = v[k] == vertex ? k : slot;
    return slot;
  }

  /// Asks for the neighbours of a cell that will be visited soon: no effect but speed.
  void prefetch_neighbours(std::uint32_t cell) const {
#if defined(__GNUC__)
    for (const Facet f : cells_[cell].neighbours) {
      __builtin_prefetch(&cells_[f.cell()]);
      __builtin_prefetch(&marks_[f.cell()]);
    }
#endif
  }

  std::uint32_t mark(std::uint32_t cell) const { return marks_[cell]; }
  void set_mark(std::uint32_t cell, std::uint32_t mark) { marks_[cell] = mark; }

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

 private:
  /// In space a cell is half a cache line, and should not lie across two.
  struct alignas(D == 3 ? 32 : alignof(std::uint32_t)) Cell {
    Simplex<D> vertices;
    std::array<Facet, D + 1> neighbours;
  };
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> marks_;
  std::vector<std::uint32_t> free_;
};

}  // namespace crossloft::detail
