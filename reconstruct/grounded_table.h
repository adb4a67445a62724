#pragma once
/// Look-up of the grounded triangles of one cell by their vertices.

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
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
    if (k[0] > k[1]) std::swap(k[0], k[1]);
    if (k[1] > k[2]) std::swap(k[1], k[2]);
    if (k[0] > k[1]) std::swap(k[0], k[1]);
  }
  std::vector<std::uint32_t> last_;  ///< by vertex
  std::vector<Entry> entries_;
};

}  // namespace crossloft
