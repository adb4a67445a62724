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
  inserter_.see_points();
  inserter_.tell_removed(false);
  for (const std::uint32_t i : insertion_order(std::span<const std::array<double, D>>(points)))
    insert(first + i);
  inserter_.tell_removed(true);
  if (!growing_.kept.empty()) keep_lowest();
}

template <std::size_t D, class P>
void DelaunayCore<D, P>::build_in_given_order([[maybe_unused]] unsigned threads) {
  make_room();
  inserter_.see_points();
  std::uint32_t done = 0;
  if constexpr (D == 3 && !HasHeights<P>) done = insert_in_parallel(threads);
  insert_the_rest(done);
  if (!growing_.kept.empty()) keep_lowest();
}

/// Inserts points from i on. The last round of insertion_order, 7/8 of the points, runs along a curve, and
/// each part of it makes about as many cells a point as those before: from these follows for how many to make
/// room when it becomes scarce. Half as much again in vain costs addresses, not memory; doubling cost page
/// faults.
template <std::size_t D, class P>
void DelaunayCore<D, P>::insert_the_rest(std::uint32_t i) {
  const std::uint32_t count = predicates_.size(), last_round = std::max(i, count / 8);
  auto& cells = growing_.cells;
  for (; i < last_round; ++i) insert(i);
  for (const double before = cells.size(); i < count; ++i) {
    insert(i);
    if (!cells.is_nearly_full()) [[likely]]
      continue;
    const double size = cells.size(), per_point = (size - before) / (i + 1 - last_round);
    cells.reserve(
        static_cast<std::size_t>(size + std::clamp(1.5 * per_point * (count - i), size, 31 * size)));
  }
}

/// Inserts points from the first on; returns how many. Rounds as in insertion_order keep what is left over to
/// be inserted soon.
template <std::size_t D, class P>
std::uint32_t DelaunayCore<D, P>::insert_in_parallel(unsigned threads) requires(D == 3) {
  const std::uint32_t count = predicates_.size();
  threads = useful_threads(threads, count);
  std::uint32_t done = 0;
  if (threads < 2) return done;
  for (; done < threads * (kPointsPerThread / 4); ++done) insert(done);
  while (done < count && dimension() < 3) insert(done++);
  if (done == count) return done;
  ParallelInsertion<P> parallel(predicates_, growing_, threads);
  while (done < count) {
    const auto end = static_cast<std::uint32_t>(std::min(std::uint64_t{8} * done, std::uint64_t{count}));
    const std::vector<std::uint32_t> left = parallel.insert(done, end);
    inserter_.set_hint(parallel.some_finite_cell());  // the last one may be gone
    for (const std::uint32_t i : left) inserter_.insert(i);
    done = end;
  }
  gained_in_parallel_ = parallel.gained();
  return done;
}

/// For twice as many triangles as points, or seven times as many tetrahedra: as of points spread evenly.
template <std::size_t D, class P>
void DelaunayCore<D, P>::make_room() {
  growing_.cells.reserve(std::size_t{predicates_.size()} * (D == 2 ? 2 : 7));
}

template <std::size_t D, class P>
std::uint32_t DelaunayCore<D, P>::insert(std::uint32_t i, std::uint32_t near) {
  if (basis_size_ <= static_cast<int>(D)) {
    wait_for_basis(i);
    return i;
  }
  const auto& incident = growing_.incident;
  near = kept(near);  // others have no cell, or that of before they were renamed
  if (D == 2 && near + std::size_t{1} < incident.size() && incident[near + 1u] != kNone)
    inserter_.insert(i, incident[near + 1u]);
  else
    inserter_.insert(i);
  return kept(i);
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
  inserter_.see_points();
  for (const std::uint32_t p : pending_) inserter_.insert(p);
  pending_.clear();
}

/// The first simplex and a ghost cell over each of its facets: the boundary of a simplex one dimension up,
/// whose D + 2 cells miss one vertex each.
template <std::size_t D, class P>
void DelaunayCore<D, P>::make_first_cells() {
  auto& cells = growing_.cells;
  const auto add = [&](const Simplex<D>& vertices) { cells.set_vertices(cells.grow(), vertices); };
  if (orient(predicates_, basis_) < 0) std::swap(basis_[0], basis_[1]);
  std::array<std::uint32_t, D + 2> missing{};
  missing[0] = kGhost;
  add(basis_);
  for (std::size_t slot = 0; slot <= D; ++slot) {
    Simplex<D> ghost = basis_;
    missing[slot + 1] = ghost[slot];
    // A point beyond the facet in place of its opposite vertex turns the cell negative; one swap mends it.
    ghost[slot] = ghost[D];
    ghost[D] = kGhost;
    if (slot == D) std::swap(ghost[0], ghost[1]);
    add(ghost);
  }
  const auto slot_of = [&](std::uint32_t cell, std::uint32_t vertex) {
    return Facet(cell, cells.slot_of(cell, vertex));
  };
  for (std::uint32_t a = 0; a < missing.size(); ++a)
    for (std::uint32_t b = 0; b < a; ++b) cells.link(slot_of(a, missing[b]), slot_of(b, missing[a]));
  for (const std::uint32_t v : basis_) inserter_.expect_incident(v);
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) inserter_.note_incident(cell);
}

// ---- results

/// Renames each vertex with duplicates to the lowest index of its equals: the insertion order kept another.
/// Those of a vertex that was hidden later are hidden too.
template <std::size_t D, class P>
void DelaunayCore<D, P>::keep_lowest() {
  auto& kept = growing_.kept;
  for (auto k = static_cast<std::uint32_t>(kept.size()); k < predicates_.size(); ++k) kept.push_back(k);
  std::vector<std::uint32_t> lowest(kept.size(), kNone);
  bool renames = false;
  for (std::uint32_t i = 0; i < kept.size(); ++i) {
    if (kept[i] != kNone) kept[i] = kept[kept[i]];
    if (kept[i] == kNone || lowest[kept[i]] != kNone) continue;
    lowest[kept[i]] = i;
    renames |= kept[i] != i;
  }
  if (!renames) return;
  const auto renamed = [&](std::uint32_t v) { return v == kNone ? v : lowest[v]; };
  for (std::uint32_t& k : kept) k = renamed(k);
  auto& cells = growing_.cells;
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    if (cells.is_free(cell)) continue;
    Simplex<D> v = cells.vertices(cell);
    for (std::uint32_t& k : v) k = renamed(k);
    cells.set_vertices(cell, v);
    inserter_.note_incident(cell);
  }
}

template <std::size_t D, class P>
void DelaunayCore<D, P>::finite(std::vector<Simplex<D>>& vertices,
                                std::vector<Simplex<D>>& neighbours) const {
  const auto& cells = growing_.cells;
  std::vector<std::uint32_t> number(cells.size(), kNone);
  std::uint32_t count = 0;
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell)
    if (!cells.is_free(cell) && !cells.is_ghost(cell)) number[cell] = count++;
  vertices.reserve(count);
  neighbours.reserve(count);
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell)
    if (number[cell] != kNone) vertices.push_back(cells.vertices(cell));
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    if (number[cell] == kNone) continue;
    auto& n = neighbours.emplace_back();
    for (std::size_t slot = 0; slot <= D; ++slot) n[slot] = number[cells.across({cell, slot}).cell()];
  }
}

}  // namespace crossloft::detail
