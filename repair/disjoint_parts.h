#pragma once
/// Parts that are united one by one.

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace crossloft {

/// The smallest member names a part. Amortised O(log n) for each call, by path halving.
class DisjointParts {
 public:
  explicit DisjointParts(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::uint32_t find(std::uint32_t v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }
  void unite(std::uint32_t v, std::uint32_t w) {
    parent_[std::max(find(v), find(w))] = std::min(find(v), find(w));
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace crossloft
