#include "data_box.h"

#include <algorithm>

namespace crossloft {

LatticeBox data_box(const FramedSections& framed) {
  constexpr std::int64_t kBound = kLatticeLimit / 2;
  LatticeBox box{{kBound, kBound, kBound}, {-kBound, -kBound, -kBound}};
  const auto add = [&](const LatticeVector& c, std::int64_t room) {
    for (std::size_t k = 0; k < 3; ++k) {
      box.lower[k] = std::max(-kBound, std::min(box.lower[k], c[k] - room));
      box.upper[k] = std::min(kBound, std::max(box.upper[k], c[k] + room));
    }
  };
  const LatticeVector low = framed.grid.to_lattice(framed.whole.low),
                      high = framed.grid.to_lattice(framed.whole.high);
  std::int64_t extent = 16;
  for (std::size_t k = 0; k < 3; ++k) extent = std::max(extent, high[k] - low[k]);
  add(low, extent / 8), add(high, extent / 8);
  // Snapped to their planes they are in there, unless the file has them far off their planes.
  for (const FramedPlane& plane : framed.planes)
    for (const LatticePoint& p : plane.vertices) add(to_vector(p), extent / 16);
  return box;
}

}  // namespace crossloft
