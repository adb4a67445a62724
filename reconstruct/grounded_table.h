#pragma once
/// Look-up of the grounded triangles and edges of one cell by their vertices.

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "../geom/ids.h"

namespace crossloft {

/// Open addressing over ascending vertex triples; an edge is a triple that ends in kNone. Only looked up, never
/// iterated, so that the hash decides nothing.
class GroundedTable {
 public:
  using Key = std::array<std::uint32_t, 3>;

  explicit GroundedTable(std::size_t capacity) {
    std::size_t size = 16;
    while (size < capacity * 2) size *= 2;
    slots_.resize(size);
  }
  void insert(Key key, std::uint32_t value) { slot(sorted(key)) = {sorted(key), value}; }
  /// kNone if absent.
  std::uint32_t find(Key key) { return slot(sorted(key)).value; }

 private:
  struct Slot {
    Key key{kNone, kNone, kNone};
    std::uint32_t value = kNone;
  };
  static Key sorted(Key k) {
    if (k[0] > k[1]) std::swap(k[0], k[1]);
    if (k[1] > k[2]) std::swap(k[1], k[2]);
    if (k[0] > k[1]) std::swap(k[0], k[1]);
    return k;
  }
  Slot& slot(const Key& key) {
    std::uint64_t h = key[0] * 0x9E3779B97F4A7C15ull;
    h = (h ^ (h >> 29) ^ key[1]) * 0xBF58476D1CE4E5B9ull;
    h = (h ^ (h >> 32) ^ key[2]) * 0x94D049BB133111EBull;
    std::size_t at = (h ^ (h >> 31)) & (slots_.size() - 1);
    while (slots_[at].value != kNone && slots_[at].key != key) at = (at + 1) & (slots_.size() - 1);
    return slots_[at];
  }
  std::vector<Slot> slots_;
};

}  // namespace crossloft
