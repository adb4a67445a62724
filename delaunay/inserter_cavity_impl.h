#pragma once
/// The cavity of one insertion: dug, and starred from the new point. Included by inserter.h.

#include "inserter.h"

namespace crossloft::detail {

/// Local vertices up to which cells are joined by a table, of 256 KB then; beyond, a quadratic method is no
/// use.
inline constexpr std::size_t kMostInTable = 256;

/// Floods the cells in conflict with e from `start`, wave by wave, and collects the boundary. In each wave
/// the cells beyond the last ones are marked, then asked, then listed: none of these loops has a branch on
/// what it finds, which no processor would foresee. False, and nothing changed, if a cell in conflict is not
/// owned or the pool has no cells to fill the cavity with.
template <std::size_t D, class P, class T>
bool Inserter<D, P, T>::dig(std::uint32_t e, std::uint32_t start) {
  start_cavity(e, start);
  for (std::size_t done = 0; done < cavity_.size();) {
    const std::size_t end = cavity_.size();
    if (!look_around(e, done, end)) return forget_marks(), false;
    ask(e);
    done = end;
  }
  collect_rim();
  if (!T::kBounded || pool_.size() >= rim_.size()) return true;
  pool_.ran_dry = true;
  forget_marks();
  return false;
}

template <std::size_t D, class P, class T>
void Inserter<D, P, T>::start_cavity(std::uint32_t e, std::uint32_t start) {
  std::uint32_t* first = cavity_.restart(1);
  *first = start;
  cavity_.end_at(first + 1);
  outside_.end_at(outside_.restart(0));
  cells_.set_mark(start, true);
  if constexpr (kNumbersVertices) {
    local_.clear();
    expect_vertices(D + 1);
    for (const std::uint32_t v : cells_.vertices(start)) note_vertex(v, e);
    dug_vertices_ = D + 1;
    if constexpr (HasHeights<P>) dug_.assign(D + 1, 1);
  }
}

/// Gathers the cells beyond the last wave. One that is not owned is never marked: it is asked at once, for
/// each facet that leads there; false if it is in conflict.
template <std::size_t D, class P, class T>
bool Inserter<D, P, T>::look_around(std::uint32_t e, std::size_t begin, std::size_t end) {
  Facet* way = wave_.restart((D + 1) * (end - begin));
  for (std::size_t k = begin; k < end; ++k)
    for (std::size_t slot = 0; slot <= D; ++slot) {
      const Facet next = cells_.across({cavity_[k], slot});
      if (T::kBounded && !owns_beyond(next)) {
        if (!in_conflict(next.cell(), e)) continue;
        for (const Facet* f = wave_.begin(); f != way; ++f) cells_.clear_mark(f->cell());
        return false;
      }
      cells_.prefetch_vertices(next.cell());
      *way = next;
      way += cells_.mark_if_new(next.cell());
    }
  wave_.end_at(way);
  return true;
}

/// Tells the cells of the wave apart.
template <std::size_t D, class P, class T>
void Inserter<D, P, T>::ask(std::uint32_t e) {
  std::uint32_t *in = cavity_.more(wave_.size()), *out = outside_.more(wave_.size());
  std::uint8_t* answer = answers_.restart(wave_.size());
  lift_apexes(e);
  for (const Facet next : wave_) *answer++ = static_cast<std::uint8_t>(conflicts(next.cell(), e));
  answer = answers_.begin();
  for (const Facet next : wave_) {
    const std::uint8_t conflict = *answer++;
    *in = *out = next.cell();
    cells_.prefetch_neighbours(next.cell());
    in += conflict;
    out += 1 - conflict;
    cells_.set_mark(next.cell(), conflict != 0);
    if constexpr (HasHeights<P> || !kLifts)
      if (conflict) note_dug(next, e);
  }
  cavity_.end_at(in);
  outside_.end_at(out);
}

/// All other vertices of the wave's cells are those of cells in the cavity, so they have their rows.
template <std::size_t D, class P, class T>
void Inserter<D, P, T>::lift_apexes(std::uint32_t e) {
  if constexpr (kLifts) {
    expect_vertices(wave_.size());
    for (const Facet next : wave_) note_vertex(cells_.vertices(next.cell())[next.slot()], e);
  }
}

template <std::size_t D, class P, class T>
void Inserter<D, P, T>::expect_vertices(std::size_t more) {
  local_.reserve(more);
  if (kLifts && rows_.size() < local_.size() + more + 1) rows_.resize(2 * (local_.size() + more) + 1);
}

/// A vertex that is there gets its row anew, in the place after the last. REQUIRES: it is expected.
template <std::size_t D, class P, class T>
inline void Inserter<D, P, T>::note_vertex(std::uint32_t v, std::uint32_t e) {
  [[maybe_unused]] const bool added = local_.add(v);
  if constexpr (kLifts) rows_[local_.size() - added] = predicates_.lifted(v == kGhost ? e : v, e);
}

/// REQUIRES: the cell's vertices have their rows.
template <std::size_t D, class P, class T>
inline bool Inserter<D, P, T>::conflicts(std::uint32_t cell, std::uint32_t e) const {
  if constexpr (kLifts) {
    const auto& v = cells_.vertices(cell);
    if (v[D] != kGhost) [[likely]] {
      const auto row = [&](std::size_t slot) -> const LiftedRow& { return rows_[local_.number(v[slot])]; };
      const double determinant = lifted_determinant(row(0), row(1), row(2), row(3));
      if (std::fabs(determinant) > lifted_error_.absolute) [[likely]]
        return determinant > 0;
      const double terms = lifted_terms(row(0), row(1), row(2), row(3));
      if (std::fabs(determinant) > lifted_error_.relative * terms) return determinant > 0;
    }
  }
  return in_conflict(cell, e);
}

/// All facets between the cavity and other cells.
template <std::size_t D, class P, class T>
void Inserter<D, P, T>::collect_rim() {
  Rim* rim = rim_.restart((D + 1) * cavity_.size());
  for (const std::uint32_t cell : cavity_)
    for (std::size_t slot = 0; slot <= D; ++slot) {
      const Facet next = cells_.across({cell, slot});
      const bool is_rim = cells_.mark(next.cell()) != Mark::cavity;
      *rim = {{cell, slot}, next};
      rim += is_rim;
      if (D == 2 && !is_rim && tells_removed_) note_removed(cell, slot);
    }
  rim_.end_at(rim);
}

/// A cell joins the cavity: its apex may be new there, the other vertices are not.
template <std::size_t D, class P, class T>
void Inserter<D, P, T>::note_dug(Facet next, std::uint32_t e) {
  const std::uint32_t apex = cells_.vertices(next.cell())[next.slot()];
  if constexpr (kNumbersVertices && !kLifts) {
    expect_vertices(1);
    note_vertex(apex, e);
  }
  if constexpr (HasHeights<P>) {
    dug_.resize(local_.size());
    std::uint8_t& dug = dug_[local_.number(apex)];
    dug_vertices_ += 1u - dug;
    dug = 1;
  }
}

/// An edge inside the cavity is met from both sides: its lower end first from one of them.
template <std::size_t D, class P, class T>
void Inserter<D, P, T>::note_removed(std::uint32_t cell, std::size_t slot) {
  const auto& v = cells_.vertices(cell);
  const std::uint32_t a = v[(slot + 1) % 3], b = v[(slot + 2) % 3];
  if (a < b && b != kGhost) removed_.push_back({a, b});
}

template <std::size_t D, class P, class T>
void Inserter<D, P, T>::forget_marks() {
  for (const std::uint32_t cell : cavity_) cells_.clear_mark(cell);
  for (const std::uint32_t cell : outside_) cells_.clear_mark(cell);
}

/// REQUIRES: a bounded inserter's pool is not empty.
template <std::size_t D, class P, class T>
std::uint32_t Inserter<D, P, T>::take_cell() {
  if (!pool_.freed.empty()) {
    const std::uint32_t cell = pool_.freed.back();
    pool_.freed.pop_back();
    return cell;
  }
  if (pool_.next != pool_.end) return pool_.next++;
  return cells_.grow();
}

/// Over a facet of the rim a copy of the cell inside it with e in place of the apex, so that orientation,
/// slots and the place of the ghost are inherited. Only the neighbour outside is told.
template <std::size_t D, class P, class T>
inline Facet Inserter<D, P, T>::make_cell(const Rim& rim, std::uint32_t e) {
  const std::uint32_t cell = take_cell();
  cells_.copy_vertices(rim.inside.cell(), cell, rim.inside.slot(), e);
  const Facet base(cell, rim.inside.slot());
  cells_.redirect(rim.outside, base);
  note_incident(cell);
  hint_ = cells_.is_ghost(cell) ? hint_ : cell;
  return base;
}

/// Stars the cavity from e.
template <std::size_t D, class P, class T>
void Inserter<D, P, T>::fill(std::uint32_t e) {
  if constexpr (D == 2) {
    return fill_cycle(e);
  } else {
    if (local_.size() <= kMostInTable) return fill_by_table(e);
  }
  // The cavity stays for the time being; its way across the rim leads to the new cells.
  for (const Rim& rim : rim_) {
    const Facet base = make_cell(rim, e);
    cells_.redirect(base, rim.outside);
    cells_.redirect(rim.inside, base);
  }
  for (const Rim& rim : rim_) join_by_turning(rim.inside);
}

/// The new cells find each other by the edges of the rim, a closed oriented surface: each edge is met once in
/// each direction. The table is square, over the numbers of the local vertices, and needs no clearing: what
/// is read was written. No branch depends on the shape of the cavity, which is what makes this fast.
template <std::size_t D, class P, class T>
void Inserter<D, P, T>::fill_by_table(std::uint32_t e) requires(D == 3) {
  const std::size_t width = local_.size();
  if (edges_.size() < width * width)
    edges_.resize(std::min(2 * width, kMostInTable) * std::min(2 * width, kMostInTable));
  StarCell* star = star_.restart(rim_.size());
  for (const Rim& rim : rim_) {
    const Facet base = make_cell(rim, e);
    const auto& slots = kFacetSlots[base.slot()];
    const auto& vertices = cells_.vertices(base.cell());
    *star = {base, rim.outside, {}};
    for (std::size_t i = 0; i < 3; ++i) star->numbers[i] = local_.number(vertices[slots[i]]);
    for (std::size_t i = 0; i < 3; ++i)
      edges_[star->numbers[i] * width + star->numbers[(i + 1) % 3]] = {base.cell(), slots[(i + 2) % 3]};
    ++star;
  }
  star_.end_at(star);
  for (const auto& [base, outside, numbers] : star_) {
    const auto& slots = kFacetSlots[base.slot()];
    cells_.redirect(base, outside);
    for (std::size_t i = 0; i < 3; ++i)
      cells_.redirect({base.cell(), slots[(i + 2) % 3]}, edges_[numbers[(i + 1) % 3] * width + numbers[i]]);
  }
}

/// In the plane the rim is a cycle: each of its vertices is the start of one edge.
template <std::size_t D, class P, class T>
void Inserter<D, P, T>::fill_cycle(std::uint32_t e) requires(D == 2) {
  StarCell* star = star_.restart(rim_.size());
  for (const Rim& rim : rim_) {
    const Facet base = make_cell(rim, e);
    *star++ = {base, rim.outside, {}};
    const std::uint32_t start = cells_.vertices(base.cell())[(base.slot() + 1) % 3];
    edges_[start + 1u] = {base.cell(), (base.slot() + 2) % 3};  // the edge from e to the start
  }
  star_.end_at(star);
  for (const auto& [base, outside, numbers] : star_) {
    const std::uint32_t end = cells_.vertices(base.cell())[(base.slot() + 2) % 3];
    const Facet beside(base.cell(), (base.slot() + 1) % 3);
    cells_.redirect(base, outside);
    cells_.link(beside, edges_[end + 1u]);
  }
}

/// Links the new cell over a facet of the rim to those over the facets beside it.
template <std::size_t D, class P, class T>
void Inserter<D, P, T>::join_by_turning(Facet inside) {
  const std::uint32_t cell = cells_.across(inside).cell();
  for (std::size_t slot = 0; slot <= D; ++slot)
    if (slot != inside.slot()) cells_.redirect({cell, slot}, around_ridge(inside, slot));
}

/// The facet of the other new cell over a ridge of the rim: that of the cell at neither `slot` nor that of
/// `inside`. Turns around the ridge through the cavity. Each edge of a cell of the cavity is passed twice:
/// linear time in all.
template <std::size_t D, class P, class T>
Facet Inserter<D, P, T>::around_ridge(Facet inside, std::size_t slot) const {
  std::uint32_t cell = inside.cell();
  std::size_t entered = inside.slot();
  for (;;) {
    const Facet next = cells_.across({cell, slot});
    if (cells_.mark(next.cell()) != Mark::cavity)
      return {next.cell(), entered};  // a new cell, of the slots of `cell`
    // The way on is opposite to the vertex that the facet just crossed has besides the ridge.
    slot = cells_.slot_of(next.cell(), cells_.vertices(cell)[entered]);
    cell = next.cell();
    entered = next.slot();
  }
}

}  // namespace crossloft::detail
