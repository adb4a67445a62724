#pragma once
/// Implementation of delaunay_core.h; include that.

#include "delaunay_core.h"

namespace crossloft::detail {

template <std::size_t D, class P>
void DelaunayCore<D, P>::build(std::uint32_t first) {
  std::vector<std::array<double, D>> points(predicates_.size() - first);
  for (std::uint32_t i = 0; i < points.size(); ++i)
    for (std::size_t axis = 0; axis < D; ++axis)
      points[i][axis] = predicates_.coordinate(first + i, static_cast<int>(axis));
  if (first == 0) make_room();
  for (const std::uint32_t i : insertion_order(std::span<const std::array<double, D>>(points)))
    insert(first + i);
  if (!kept_.empty()) keep_lowest();
}

template <std::size_t D, class P>
void DelaunayCore<D, P>::build_in_given_order() {
  make_room();
  for (std::uint32_t i = 0; i < predicates_.size(); ++i) insert(i);
  if (!kept_.empty()) keep_lowest();
}

/// For twice as many triangles as points, or seven times as many tetrahedra: as of points spread evenly.
template <std::size_t D, class P>
void DelaunayCore<D, P>::make_room() {
  cells_.reserve(std::size_t{predicates_.size()} * (D == 2 ? 2 : 7));
}

template <std::size_t D, class P>
std::uint32_t DelaunayCore<D, P>::insert(std::uint32_t i, std::uint32_t near) {
  if (basis_size_ <= static_cast<int>(D)) {
    wait_for_basis(i);
    return i;
  }
  std::uint32_t start = hint_;
  if (D == 2 && near < incident_.size() && incident_[near] != kNone) start = incident_[near];
  return insert_in_full_dimension(i, start);
}

// ---- until the first simplex

template <std::size_t D, class P>
bool DelaunayCore<D, P>::extends_basis(std::uint32_t i) const {
  const auto& b = basis_;
  if (basis_size_ == 0) return true;
  if (basis_size_ == 1) return predicates_.compare_lex(b[0], i) != 0;
  if constexpr (D == 2) {
    return predicates_.orient2d(b[0], b[1], i) != 0;
  } else {
    if (basis_size_ == 2) return !collinear(predicates_, b[0], b[1], i);
    return predicates_.orient3d(b[0], b[1], b[2], i) != 0;
  }
}

template <std::size_t D, class P>
void DelaunayCore<D, P>::wait_for_basis(std::uint32_t i) {
  if (!extends_basis(i)) {
    pending_.push_back(i);
    return;
  }
  basis_[static_cast<std::size_t>(basis_size_++)] = i;
  if (basis_size_ <= static_cast<int>(D)) return;
  make_first_cells();
  for (const std::uint32_t p : pending_) insert_in_full_dimension(p, hint_);
  pending_.clear();
}

/// The first simplex and a ghost cell over each of its facets: the boundary of a simplex one dimension up,
/// whose D + 2 cells miss one vertex each.
template <std::size_t D, class P>
void DelaunayCore<D, P>::make_first_cells() {
  if (orient(predicates_, basis_) < 0) std::swap(basis_[0], basis_[1]);
  std::array<std::uint32_t, D + 2> missing{};
  missing[0] = kGhost;
  cells_.add(basis_);
  for (std::size_t slot = 0; slot <= D; ++slot) {
    Simplex<D> ghost = basis_;
    missing[slot + 1] = ghost[slot];
    // A point beyond the facet in place of its opposite vertex turns the cell negative; one swap mends it.
    ghost[slot] = ghost[D];
    ghost[D] = kGhost;
    if (slot == D) std::swap(ghost[0], ghost[1]);
    cells_.add(ghost);
  }
  const auto slot_of = [&](std::uint32_t cell, std::uint32_t vertex) {
    return Facet(cell, cells_.slot_of(cell, vertex));
  };
  for (std::uint32_t a = 0; a < missing.size(); ++a)
    for (std::uint32_t b = 0; b < a; ++b) cells_.link(slot_of(a, missing[b]), slot_of(b, missing[a]));
  vertex_count_ = D + 1;
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) note_incident(cell);
}

// ---- one point

template <std::size_t D, class P>
std::uint32_t DelaunayCore<D, P>::insert_in_full_dimension(std::uint32_t i, std::uint32_t start) {
  const std::uint32_t at = locate(i, start);
  hint_ = at;
  removed_.clear();
  if (const std::uint32_t twin = equal_vertex(at, i); twin != kNone) return keep(i, twin);
  if constexpr (HasHeights<P>) {
    if (is_above(at, i)) return keep(i, kNone);
  }
  dig(i, at);
  fill(i);
  ++vertex_count_;
  if constexpr (HasHeights<P>) hide_inner_vertices();
  for (std::size_t k = cavity_.size(); k-- > 0;) cells_.release(cavity_[k]);
  return i;
}

template <std::size_t D, class P>
std::uint32_t DelaunayCore<D, P>::keep(std::uint32_t i, std::uint32_t vertex) {
  for (auto k = static_cast<std::uint32_t>(kept_.size()); k <= i; ++k) kept_.push_back(k);
  return kept_[i] = vertex;
}

/// Visibility walk: it cannot cycle, since the perturbed triangulation is regular. Returns a finite cell that
/// holds e, or a ghost cell that e is beyond. It is in conflict with e unless it has a vertex equal to e or e
/// is hidden.
template <std::size_t D, class P>
std::uint32_t DelaunayCore<D, P>::locate(std::uint32_t e, std::uint32_t start) const {
  std::uint32_t cell = cells_.is_ghost(start) ? cells_.across({start, D}).cell() : start;
  std::size_t entered = D + 1;
  for (bool inside = false; !inside;) {
    inside = true;
    for (std::size_t slot = 0; slot <= D; ++slot) {
      if (slot == entered || orient(predicates_, replaced(cells_.vertices(cell), slot, e)) >= 0) continue;
      const Facet next = cells_.across({cell, slot});
      cell = next.cell();
      entered = next.slot();
      inside = cells_.is_ghost(cell);
      break;
    }
  }
  return cell;
}

template <std::size_t D, class P>
std::uint32_t DelaunayCore<D, P>::equal_vertex(std::uint32_t cell, std::uint32_t e) const {
  if (cells_.is_ghost(cell)) return kNone;  // e is strictly beyond the hull
  for (const std::uint32_t v : cells_.vertices(cell))
    if (predicates_.coordinate(v, 0) == predicates_.coordinate(e, 0) && predicates_.compare_lex(v, e) == 0)
      return equal_heights(predicates_, v, e) ? v : kNone;
  return kNone;
}

/// REQUIRES: `cell` is that of locate(e). Whether e is above the hull is whether it is above the hyperplane
/// of the cell that holds it; on a common face of several, they agree. Beyond the hull nothing is hidden.
template <std::size_t D, class P>
bool DelaunayCore<D, P>::is_above(std::uint32_t cell, std::uint32_t e) const {
  return !cells_.is_ghost(cell) && !in_conflict(cell, e);
}

template <std::size_t D, class P>
bool DelaunayCore<D, P>::in_conflict(std::uint32_t cell, std::uint32_t e) const {
  if (cells_.is_ghost(cell)) return ghost_conflict(cell, e);
  return in_ball(predicates_, cells_.vertices(cell), e) > 0;
}

template <std::size_t D, class P>
bool DelaunayCore<D, P>::ghost_conflict(std::uint32_t cell, std::uint32_t e) const {
  if (const int side = orient(predicates_, replaced(cells_.vertices(cell), D, e))) return side > 0;
  const std::uint32_t behind = cells_.across({cell, D}).cell();
  return in_ball(predicates_, cells_.vertices(behind), e) > 0;
}

template <std::size_t D, class P>
void DelaunayCore<D, P>::note_incident(std::uint32_t cell) {
  if (D != 2) return;
  for (const std::uint32_t v : cells_.vertices(cell)) {
    if (v == kGhost) continue;
    if (v >= incident_.size()) incident_.resize(std::size_t{v} + 1, kNone);
    incident_[v] = cell;
  }
}

// ---- results

/// Renames each vertex with duplicates to the lowest index of its equals: the insertion order kept another.
/// Those of a vertex that was hidden later are hidden too.
template <std::size_t D, class P>
void DelaunayCore<D, P>::keep_lowest() {
  for (auto k = static_cast<std::uint32_t>(kept_.size()); k < predicates_.size(); ++k) kept_.push_back(k);
  std::vector<std::uint32_t> lowest(kept_.size(), kNone);
  bool renames = false;
  for (std::uint32_t i = 0; i < kept_.size(); ++i) {
    if (kept_[i] != kNone) kept_[i] = kept_[kept_[i]];
    if (kept_[i] == kNone || lowest[kept_[i]] != kNone) continue;
    lowest[kept_[i]] = i;
    renames |= kept_[i] != i;
  }
  if (!renames) return;
  const auto renamed = [&](std::uint32_t v) { return v == kNone ? v : lowest[v]; };
  for (std::uint32_t& k : kept_) k = renamed(k);
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
    Simplex<D> v = cells_.vertices(cell);
    for (std::uint32_t& k : v) k = renamed(k);
    cells_.rename(cell, v);
    if (!cells_.is_free(cell)) note_incident(cell);
  }
}

template <std::size_t D, class P>
void DelaunayCore<D, P>::finite(std::vector<Simplex<D>>& vertices,
                                std::vector<Simplex<D>>& neighbours) const {
  std::vector<std::uint32_t> number(cells_.size(), kNone);
  vertices.reserve(cells_.size());
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
    if (cells_.is_free(cell) || cells_.is_ghost(cell)) continue;
    number[cell] = static_cast<std::uint32_t>(vertices.size());
    vertices.push_back(cells_.vertices(cell));
  }
  neighbours.reserve(vertices.size());
  for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
    if (number[cell] == kNone) continue;
    auto& n = neighbours.emplace_back();
    for (std::size_t slot = 0; slot <= D; ++slot) n[slot] = number[cells_.across({cell, slot}).cell()];
  }
}

}  // namespace crossloft::detail
