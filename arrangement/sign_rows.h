#pragma once
/// The sign vectors of many points over the same planes, each kept once.

#include <cstdint>
#include <span>
#include <vector>

#include "../geom/lattice.h"
#include "../geom/lattice_filters.h"
#include "sign_vector.h"

namespace crossloft {

/// Points of one face, edge or vertex of the arrangement have equal signs. With k planes a row of k signs for
/// each point would be most of a graph, and most of the time it is copied and compared; a number is not.
class SignRows {
 public:
  SignRows() = default;
  explicit SignRows(std::span<const LatticePlane> planes);

  std::uint32_t size() const { return static_cast<std::uint32_t>(planes_through_.size()); }
  std::size_t words() const { return words_; }
  SignView operator[](std::uint32_t row) const {
    return {{pos_.data() + row * words_, words_}, {zero_.data() + row * words_, words_}};
  }
  /// How many planes have the sign 0.
  std::uint32_t planes_through(std::uint32_t row) const { return planes_through_[row]; }

  /// The row of a point: its exact signs. O(k) filtered side tests.
  std::uint32_t of(const LatticePoint& point);
  /// The same where only the signs against the planes of `across` may differ from those of row `like`.
  std::uint32_t of(const LatticePoint& point, std::uint32_t like, std::span<const std::uint32_t> across);

 private:
  void ask(const LatticePoint& point, std::uint32_t plane);
  std::uint32_t keep_asked();
  bool is_asked(std::uint32_t row) const { return equal_signs((*this)[row], {asked_pos_, asked_zero_}); }
  void grow();

  std::vector<LatticePlane> planes_;
  std::vector<PlaneInDoubles> in_doubles_;
  std::size_t words_ = 1;
  std::vector<SignWord> pos_, zero_;              ///< `words_` of each row
  std::vector<std::uint32_t> planes_through_;     ///< by row
  std::vector<std::uint32_t> slots_;              ///< open addressing over the rows, at most half full
  std::vector<SignWord> asked_pos_, asked_zero_;  ///< what ask() has filled in
  std::uint32_t last_ = kNone;  ///< given out last: the next point is mostly of the same element
};

}  // namespace crossloft
