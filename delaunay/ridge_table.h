#pragma once
/// Pairs up the facets of new cells around a point.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "simplex_store.h"

namespace crossloft::detail {

/// A ridge of the cavity's boundary (edge in space, vertex in the plane) is shared by two new cells. The
/// first to come leaves its facet here, the second finds it. Open addressing at a load of at most a half; a
/// stamp empties it in constant time. Deterministic: nobody iterates over it.
class RidgeTable {
 public:
  static std::uint64_t key(std::uint32_t u, std::uint32_t v) {
    return u < v ? std::uint64_t{u} << 32 | v : std::uint64_t{v} << 32 | u;
  }

  /// Empties the table and makes room for `ridges`.
  void reset(std::size_t ridges) {
    if (slots_.size() < 2 * ridges) {
      std::size_t size = 256;
      while (size < 2 * ridges) size *= 2;
      slots_.assign(size, {});
      stamp_ = 0;
    }
    ++stamp_;
  }

  /// True and `other` filled in if the ridge was here, else remembers `facet` for it.
  bool match(std::uint64_t key, Facet facet, Facet& other) {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t at = (key * 0x9E3779B97F4A7C15u >> 32) & mask;; at = (at + 1) & mask) {
      Slot& slot = slots_[at];
      if (slot.stamp != stamp_) {
        slot = {key, stamp_, facet};
        return false;
      }
      if (slot.key == key) {
        other = slot.facet;
        return true;
      }
    }
  }

 private:
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t stamp = 0;
    Facet facet;
  };
  std::vector<Slot> slots_;
  std::uint32_t stamp_ = 0;
};

}  // namespace crossloft::detail
