#pragma once
/// What one section alone shows.
///
/// A part of a section that a cell joins with nothing else, and a hole in a section that a cell closes over: if
/// the cell on the other side does the same, the result is a body, or a bubble, that only one plane has met.
/// Both are unlikely: what a single plane meets is rather the tip of a bump or of a dent. A cell can't know
/// what the other side does, so it tells what it could do about it, and is asked to on the side that is surer.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cell_complex.h"
#include "ground.h"
#include "joins.h"

namespace crossloft {

/// A body that stands on one part of one face's section only, or the outside under a dome over one face.
struct AlonePart {
  Triangle name{};             ///< the smallest of its hull triangles
  std::uint32_t face = kNone;  ///< bit of the face masks
  bool can_change = false;     ///< there is a way to something else
  std::int32_t confidence = 0; ///< of the weakest tetrahedron that joins it, or of the strongest that closes it
};

struct AloneParts {
  std::vector<AlonePart> bodies, bubbles;
};

/// What a cell is asked to do about them: names of bodies to be joined, and of bubbles to be left open.
struct AloneRequests {
  std::vector<Triangle> joined, opened;
};

/// O(n), and O(n log n) for each that stands beside other bodies or under a dome. REQUIRES: kept within
/// `candidates`, the tetrahedra that a body may be joined by.
AloneParts find_alone(const CellComplex& complex, const Ground& ground, const std::vector<std::uint8_t>& candidates,
                      const std::vector<std::uint8_t>& kept, std::span<const std::int32_t> confidence);

/// Adds the way from a body to another one that is most confident where it is weakest, by simple moves and
/// one join at its end. False, and nothing is added, if there is none.
bool join_alone(const CellComplex& complex, const Ground& ground, const std::vector<std::uint8_t>& candidates,
                std::span<const std::int32_t> confidence, const Triangle& name, std::vector<std::uint8_t>& kept,
                std::vector<Join>& joins);

}  // namespace crossloft
