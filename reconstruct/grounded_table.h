#pragma once
/// Look-up of the grounded triangles of one cell by their vertices.

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "../geom/ids.h"

namespace crossloft {

/// Triangles by their smallest vertex, two of them as a rule, then by the others: a hub may have thousands.
/// O(n log n) to make, O(log k) to find one of k.
class GroundedTable {
 public:
  using Key = std::array<std::uint32_t, 3>;

  GroundedTable(std::size_t vertices, std::span<const Key> triangles)
      : begin_(vertices + 2), entries_(triangles.size()) {
    for (const Key& key : triangles) ++begin_[sorted(key)[0] + std::size_t{2}];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    for (std::uint32_t n = 0; n < triangles.size(); ++n) {
      const Key key = sorted(triangles[n]);
      entries_[begin_[key[0] + std::size_t{1}]++] = {key[1], key[2], n};
    }
    for (std::size_t v = 0; v < vertices; ++v)
      if (begin_[v + 1] > begin_[v] + 1) std::sort(at(begin_[v]), at(begin_[v + 1]));
  }
  /// Its number; kNone if absent.
  std::uint32_t find(Key key) const {
    key = sorted(key);
    const auto end = at(begin_[key[0] + std::size_t{1}]);
    const auto found = std::lower_bound(at(begin_[key[0]]), end, Entry{key[1], key[2], 0});
    return found != end && found->middle == key[1] && found->largest == key[2] ? found->number : kNone;
  }

 private:
  struct Entry {
    std::uint32_t middle, largest, number;
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };
  static Key sorted(const Key& k) {
    // Without branches: the order can't be predicted.
    const std::uint32_t low = std::min(k[0], k[1]), high = std::max(k[0], k[1]);
    return {std::min(low, k[2]), std::max(low, std::min(high, k[2])), std::max(high, k[2])};
  }
  std::vector<Entry>::iterator at(std::uint32_t i) { return entries_.begin() + i; }
  std::vector<Entry>::const_iterator at(std::uint32_t i) const { return entries_.begin() + i; }

  std::vector<std::uint32_t> begin_;  ///< by vertex: its first entry; two more at the end
  std::vector<Entry> entries_;
};

}  // namespace crossloft
