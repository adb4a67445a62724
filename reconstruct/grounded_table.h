#pragma once
/// Look-up of the grounded triangles of one cell by their vertices.

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "../geom/ids.h"

namespace crossloft {

/// Triangles by their smallest vertex: two of them as a rule.
class GroundedTable {
 public:
  using Key = std::array<std::uint32_t, 3>;

  GroundedTable(std::size_t vertices, std::size_t triangles) : last_(vertices, kNone) {
    entries_.reserve(triangles);
  }
  /// Its number is how many came before.
  void add(Key key) {
    sort(key);
    entries_.push_back({key[1], key[2], last_[key[0]]});
    last_[key[0]] = static_cast<std::uint32_t>(entries_.size() - 1);
  }
  /// kNone if absent.
  std::uint32_t find(Key key) const {
    sort(key);
    std::uint32_t n = last_[key[0]];
    while (n != kNone && (entries_[n].middle != key[1] || entries_[n].largest != key[2]))
      n = entries_[n].before;
    return n;
  }

 private:
  struct Entry {
    std::uint32_t middle, largest;
    std::uint32_t before;  ///< the triangle with the same smallest vertex that came before it
  };
  static void sort(Key& k) {
    // Without branches: the order can't be predicted.
    const std::uint32_t low = std::min(k[0], k[1]), high = std::max(k[0], k[1]);
    k = {std::min(low, k[2]), std::max(low, std::min(high, k[2])), std::max(high, k[2])};
  }
  std::vector<std::uint32_t> last_;  ///< by vertex
  std::vector<Entry> entries_;
};

}  // namespace crossloft
