#pragma once
/// The cavity of one insertion: dug, starred, looked through for hidden vertices. Part of delaunay_core.h;
/// include that.

#include "delaunay_core.h"
#include "tet_mesh.h"

namespace crossloft::detail {

/// Vertices of a cavity that is joined by a table of 16 KB; larger ones have no use for a quadratic method.
inline constexpr std::size_t kMostInTable = 64;

/// Floods the cells in conflict with e from `start` and collects the boundary. Marks hold the answers of this
/// insertion, so each cell is asked once.
template <std::size_t D, class P>
void DelaunayCore<D, P>::dig(std::uint32_t e, std::uint32_t start) {
  stamp_ += 2;
  cavity_.assign(1, start);
  rim_.clear();
  cells_.set_mark(start, stamp_);
  if constexpr (kNumbersVertices) {
    dug_vertices_.clear();
    if (dug_marks_.size() <= predicates_.size()) dug_marks_.resize(std::size_t{predicates_.size()} + 1);
    for (const std::uint32_t v : cells_.vertices(start)) note_vertex(v);
  }
  for (std::size_t k = 0; k < cavity_.size(); ++k) {
    const std::uint32_t cell = cavity_[k];
    for (std::size_t slot = 0; slot <= D; ++slot) {
      const Facet next = cells_.across({cell, slot});
      std::uint32_t mark = cells_.mark(next.cell());
      if (mark != stamp_ && mark != stamp_ + 1) {
        mark = in_conflict(next.cell(), e) ? stamp_ : stamp_ + 1;
        cells_.set_mark(next.cell(), mark);
        if (mark == stamp_) {
          cavity_.push_back(next.cell());
          cells_.prefetch_neighbours(next.cell());
          // The other vertices are those of a cell that is in already.
          if constexpr (kNumbersVertices) note_vertex(cells_.vertices(next.cell())[next.slot()]);
        }
      }
      if (mark != stamp_) {
        rim_.push_back({{cell, slot}, next});
      } else if (D == 2) {
        note_removed(cell, slot);
      }
    }
  }
}

/// An edge inside the cavity is met from both sides: its lower end first from one of them.
template <std::size_t D, class P>
void DelaunayCore<D, P>::note_removed(std::uint32_t cell, std::size_t slot) {
  const auto& v = cells_.vertices(cell);
  const std::uint32_t a = v[(slot + 1) % 3], b = v[(slot + 2) % 3];
  if (a < b && b != kGhost) removed_.push_back({a, b});
}

template <std::size_t D, class P>
void DelaunayCore<D, P>::note_vertex(std::uint32_t v) {
  DugMark& mark = dug_marks_[v + 1];  // kGhost + 1 is 0
  if (mark.stamp == stamp_) return;
  mark = {stamp_, static_cast<std::uint32_t>(dug_vertices_.size())};
  dug_vertices_.push_back(v);
}

/// Hides the vertices of the cavity that are not on its rim.
template <std::size_t D, class P>
void DelaunayCore<D, P>::hide_inner_vertices() {
  const std::size_t on_rim = D == 2 ? rim_.size() : rim_.size() / 2 + 2;
  if (dug_vertices_.size() == on_rim) return;
  for (const Rim& rim : rim_)
    for (std::size_t slot = 0; slot <= D; ++slot)
      if (slot != rim.inside.slot())
        dug_marks_[cells_.vertices(rim.inside.cell())[slot] + 1].stamp = stamp_ + 1;
  for (const std::uint32_t v : dug_vertices_) {
    if (dug_marks_[v + 1].stamp != stamp_) continue;
    keep(v, kNone);
    --vertex_count_;
    if (v < incident_.size()) incident_[v] = kNone;
  }
}

/// Stars the cavity from e: over each facet of the rim a copy of the cell inside it with e in place of the
/// apex, so that orientation, slots and the place of the ghost are inherited. The cavity stays for the time
/// being; its way across the rim now leads to the new cell.
template <std::size_t D, class P>
void DelaunayCore<D, P>::fill(std::uint32_t e) {
  for (const auto& [inside, outside] : rim_) {
    hint_ = cells_.add(replaced(cells_.vertices(inside.cell()), inside.slot(), e));
    const Facet base(hint_, inside.slot());
    cells_.link(base, outside);
    cells_.redirect(inside, base);
    note_incident(hint_);
  }
  if constexpr (D == 3)
    if (dug_vertices_.size() <= kMostInTable) return join_by_table();
  for (const Rim& rim : rim_) join_by_turning(rim.inside);
}

/// Links the new cells to each other. The rim is a closed oriented surface: each edge is met once in each
/// direction. The table is square, over the numbers of the cavity's vertices, and needs no clearing: what is
/// read was written. No branch depends on the shape of the cavity, which is what makes this fast.
template <std::size_t D, class P>
void DelaunayCore<D, P>::join_by_table() requires(D == 3) {
  const std::size_t width = dug_vertices_.size();
  edges_.resize(kMostInTable * kMostInTable);
  rim_numbers_.resize(rim_.size());
  for (std::size_t k = 0; k < rim_.size(); ++k) {
    const Facet base = cells_.across(rim_[k].inside);
    const auto& slots = kFacetSlots[base.slot()];
    auto& numbers = rim_numbers_[k];
    for (std::size_t i = 0; i < 3; ++i)
      numbers[i] = dug_marks_[cells_.vertices(base.cell())[slots[i]] + 1].number;
    for (std::size_t i = 0; i < 3; ++i)
      edges_[numbers[i] * width + numbers[(i + 1) % 3]] = {base.cell(), slots[(i + 2) % 3]};
  }
  for (std::size_t k = 0; k < rim_.size(); ++k) {
    const Facet base = cells_.across(rim_[k].inside);
    const auto& slots = kFacetSlots[base.slot()];
    const auto& numbers = rim_numbers_[k];
    for (std::size_t i = 0; i < 3; ++i)
      cells_.redirect({base.cell(), slots[(i + 2) % 3]}, edges_[numbers[(i + 1) % 3] * width + numbers[i]]);
  }
}

/// Links the new cell over a facet of the rim to those over the facets beside it.
template <std::size_t D, class P>
void DelaunayCore<D, P>::join_by_turning(Facet inside) {
  const std::uint32_t cell = cells_.across(inside).cell();
  for (std::size_t slot = 0; slot <= D; ++slot)
    if (slot != inside.slot() && cells_.across({cell, slot}) == Facet())
      cells_.link({cell, slot}, around_ridge(inside, slot));
}

/// The facet of the other new cell over a ridge of the rim: that of the cell at neither `slot` nor that of
/// `inside`. Turns around the ridge through the cavity. Each edge of a cell of the cavity is passed once:
/// linear time in all.
template <std::size_t D, class P>
Facet DelaunayCore<D, P>::around_ridge(Facet inside, std::size_t slot) const {
  std::uint32_t cell = inside.cell();
  std::size_t entered = inside.slot();
  for (;;) {
    const Facet next = cells_.across({cell, slot});
    if (cells_.mark(next.cell()) != stamp_)
      return {next.cell(), entered};  // a new cell, of the slots of `cell`
    // The way on is opposite to the vertex that the facet just crossed has besides the ridge.
    slot = cells_.slot_of(next.cell(), cells_.vertices(cell)[entered]);
    cell = next.cell();
    entered = next.slot();
  }
}

}  // namespace crossloft::detail
