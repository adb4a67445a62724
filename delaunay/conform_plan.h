#pragma once
/// Where conforming edge recovery splits, and what it reports.

#include <array>
#include <cstdint>
#include <vector>

#include "../geom/ids.h"

namespace crossloft {

/// Asks for a point near from + t (to - from), 0 < t < 1.
struct SplitRequest {
  std::uint32_t segment = kNone;  ///< input segment that the piece came from
  std::uint32_t from = kNone;  ///< the acute corner if t is a shell, else the lexicographically smaller end
  std::uint32_t to = kNone;
  bool reversed = false;  ///< from -> to runs against the direction of the input segment
  bool shell = false;  ///< t puts the point on a shell around `from`: keep the distance as well as possible
  double t = 0.5;
};

struct ConformResult {
  std::uint32_t splits = 0;           ///< pieces split
  std::vector<std::uint32_t> source;  ///< per piece: the input segment it came from
  std::vector<std::uint32_t> failed;  ///< pieces (indices into the new segments) that are not edges
  bool limit_reached = false;
};

namespace detail {

/// 2^k / length for the power of two nearest to length / 2: between sqrt(1/8) and sqrt(1/2). A piece that
/// ends on a shell is halved onto the next one, so pieces that share an acute corner are cut at equal
/// distances. REQUIRES: length > 0.
double shell_fraction(double length);

}  // namespace detail
}  // namespace crossloft
