#pragma once
/// Coplanar sites in space as sites of a plane.

#include <cstdint>

#include "point_predicates.h"

namespace crossloft::detail {

/// The sites of `P` projected along an axis that keeps their plane a plane. A lower hull is affinely
/// invariant, so the heights stay as they are. Ranks stay those in space. `P` must outlive it.
template <PowerPredicates3 P>
class PowerProjection {
 public:
  PowerProjection(const P& predicates, int dropped_axis) : sites_(predicates), drop_(dropped_axis) {}

  int dropped_axis() const { return drop_; }
  std::uint32_t size() const { return sites_.size(); }
  double coordinate(std::uint32_t i, int axis) const { return sites_.coordinate(i, (drop_ + 1 + axis) % 3); }
  int orient2d(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return sites_.orient2d(a, b, c, drop_);
  }
  int power_test(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    return sites_.power_test2d(a, b, c, d, drop_);
  }
  int compare_lex(std::uint32_t a, std::uint32_t b) const { return sites_.compare_lex(a, b); }
  int compare_height(std::uint32_t a, std::uint32_t b) const { return sites_.compare_height(a, b); }

 private:
  const P& sites_;
  int drop_;
};

}  // namespace crossloft::detail
