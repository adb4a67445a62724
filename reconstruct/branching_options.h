#pragma once
/// Which samples of the branching and cutting diagrams a reconstruction takes.

#include <cstdint>

namespace crossloft {

/// Where branching samples are taken (paper, section 2).
enum class Branching : std::uint8_t {
  off,        ///< nowhere: the vertices of the sections alone
  automatic,  ///< where a section faces two or more other sections
  all         ///< everywhere on the branching diagram
};

struct BranchingOptions {
  Branching mode = Branching::automatic;
  bool cutting = false;  ///< also samples of the cutting diagram

  /// Only cells that leave something bare are looked at.
  bool only_where_lacking() const { return mode == Branching::automatic && !cutting; }
  /// A cell with no more section components than these gets no samples.
  std::uint32_t most_without_samples() const { return only_where_lacking() ? 2 : 0; }
};

}  // namespace crossloft
