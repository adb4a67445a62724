#pragma once
/// One insertion from search to end; included by inserter.h.

#include <algorithm>
#include <iterator>

#include "inserter.h"

namespace crossloft::detail {

template <std::size_t D, class P, class T>
void Inserter<D, P, T>::see_points() {
  if constexpr (kNumbersVertices) local_.make_room(predicates_.size());
  if constexpr (kLifts) lifted_error_ = predicates_.lifted_error();
}

template <std::size_t D, class P, class T>
bool Inserter<D, P, T>::insert(std::uint32_t i, std::uint32_t start) {
  const std::uint32_t at = locate(i, start);
  if (!territory_.owns(cells_.vertices(at))) return false;
  if (!cells_.is_ghost(at)) hint_ = at;  // behind a ghost may be a cell that is not owned
  removed_.clear();
  if (const std::uint32_t twin = equal_vertex(at, i); twin != kNone) return keep(i, twin);
  if constexpr (HasHeights<P>) {
    if (is_above(at, i)) return keep(i, kNone);
  }
  if (!dig(i, at)) return false;
  expect_incident(i);
  fill(i);
  ++gained_;
  if constexpr (HasHeights<P>) hide_inner_vertices();
  give_back();
  return true;
}

template <std::size_t D, class P, class T>
bool Inserter<D, P, T>::keep(std::uint32_t i, std::uint32_t vertex) {
  auto& kept = shared_.kept;
  for (auto k = static_cast<std::uint32_t>(kept.size()); k <= i; ++k) kept.push_back(k);
  kept[i] = vertex;
  return true;
}

/// Visibility walk: it cannot cycle, since the perturbed triangulation is regular. Returns a finite cell that
/// holds e, or a ghost cell that e is beyond, or the first cell on the way that is not owned. It is in
/// conflict with e unless it has a vertex equal to e or e is hidden.
template <std::size_t D, class P, class T>
std::uint32_t Inserter<D, P, T>::locate(std::uint32_t e, std::uint32_t start) const {
  std::uint32_t cell = cells_.is_ghost(start) ? cells_.across({start, D}).cell() : start;
  std::size_t entered = D + 1;
  for (bool inside = !territory_.owns(cells_.vertices(cell)); !inside;) {
    inside = true;
    for (std::size_t slot = 0; slot <= D; ++slot) {
      if (slot == entered || orient(predicates_, replaced(cells_.vertices(cell), slot, e)) >= 0) continue;
      const Facet next = cells_.across({cell, slot});
      cell = next.cell();
      entered = next.slot();
      inside = cells_.is_ghost(cell) || !owns_beyond(next);
      break;
    }
  }
  return cell;
}

template <std::size_t D, class P, class T>
std::uint32_t Inserter<D, P, T>::equal_vertex(std::uint32_t cell, std::uint32_t e) const {
  if (cells_.is_ghost(cell)) return kNone;  // e is strictly beyond the hull
  for (const std::uint32_t v : cells_.vertices(cell))
    if (predicates_.coordinate(v, 0) == predicates_.coordinate(e, 0) && predicates_.compare_lex(v, e) == 0)
      return equal_heights(predicates_, v, e) ? v : kNone;
  return kNone;
}

/// REQUIRES: `cell` is that of locate(e). Whether e is above the hull is whether it is above the hyperplane
/// of the cell that holds it; on a common face of several, they agree. Beyond the hull nothing is hidden.
template <std::size_t D, class P, class T>
bool Inserter<D, P, T>::is_above(std::uint32_t cell, std::uint32_t e) const {
  return !cells_.is_ghost(cell) && !in_conflict(cell, e);
}

template <std::size_t D, class P, class T>
bool Inserter<D, P, T>::in_conflict(std::uint32_t cell, std::uint32_t e) const {
  if (cells_.is_ghost(cell)) return ghost_conflict(cell, e);
  return in_ball(predicates_, cells_.vertices(cell), e) > 0;
}

template <std::size_t D, class P, class T>
bool Inserter<D, P, T>::ghost_conflict(std::uint32_t cell, std::uint32_t e) const {
  if (const int side = orient(predicates_, replaced(cells_.vertices(cell), D, e))) return side > 0;
  const std::uint32_t behind = cells_.across({cell, D}).cell();
  return in_ball(predicates_, cells_.vertices(behind), e) > 0;
}

template <std::size_t D, class P, class T>
inline void Inserter<D, P, T>::note_incident(std::uint32_t cell) {
  if constexpr (D == 2)
    for (const std::uint32_t v : cells_.vertices(cell))
      shared_.incident[v + 1u] = cell;  // the ghost in front
}

template <std::size_t D, class P, class T>
inline void Inserter<D, P, T>::expect_incident(std::uint32_t vertex) {
  if (D != 2 || vertex + std::size_t{1} < shared_.incident.size()) return;
  shared_.incident.resize(std::max<std::size_t>(predicates_.size(), vertex + std::size_t{1}) + 1, kNone);
  edges_.resize(shared_.incident.size());
}

/// Hides the vertices of the cavity that are not on its rim.
template <std::size_t D, class P, class T>
void Inserter<D, P, T>::hide_inner_vertices() {
  const std::size_t on_rim = D == 2 ? rim_.size() : rim_.size() / 2 + 2;
  if (dug_vertices_ == on_rim) return;
  for (const Rim& rim : rim_)
    for (std::size_t slot = 0; slot <= D; ++slot)
      if (slot != rim.inside.slot()) dug_[local_.number(cells_.vertices(rim.inside.cell())[slot])] = 0;
  for (std::size_t k = 0; k < dug_.size(); ++k) {
    if (!dug_[k]) continue;
    const std::uint32_t v = local_[k];
    keep(v, kNone);
    --gained_;
    if constexpr (D == 2) shared_.incident[v + 1u] = kNone;
  }
}

/// The cavity's cells back to the pool, all marks away.
template <std::size_t D, class P, class T>
void Inserter<D, P, T>::give_back() {
  forget_marks();
  for (const std::uint32_t cell : cavity_) cells_.set_free(cell);
  pool_.freed.insert(pool_.freed.end(), std::make_reverse_iterator(cavity_.end()),
                     std::make_reverse_iterator(cavity_.begin()));
}

}  // namespace crossloft::detail
