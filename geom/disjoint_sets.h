#pragma once
/// Disjoint sets of 0..n-1 with path halving.

#include <cstdint>
#include <numeric>
#include <vector>

namespace crossloft {

/// The root of a set is its smallest element: it depends on the set alone, not on the order of the joins.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size = 0) { reset(size); }

  void reset(std::size_t size) {
    parent_.resize(size);
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  /// One more element, a set of its own; its number.
  std::uint32_t add() {
    parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
    return parent_.back();
  }

  /// Amortised O(log n).
  std::uint32_t find(std::uint32_t x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }

  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a < b) parent_[b] = a;
    if (b < a) parent_[a] = b;
  }

  /// find() without shortening the path: what has been joined can still be parted.
  std::uint32_t root(std::uint32_t x) const {
    while (parent_[x] != x) x = parent_[x];
    return x;
  }

  /// Takes back a join by which x has lost its place as a root. REQUIRES: since then root() instead of
  /// find(), and later joins are taken back.
  void part(std::uint32_t x) { parent_[x] = x; }

  bool is_root(std::uint32_t x) const { return parent_[x] == x; }

  /// Number of sets. O(n).
  std::uint32_t count() const {
    std::uint32_t roots = 0;
    for (std::uint32_t x = 0; x < parent_.size(); ++x) roots += is_root(x) ? 1U : 0U;
    return roots;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace crossloft
