#include "data_box.h"

#include <algorithm>

namespace crossloft {

LatticeBox data_box(const FramedSections& framed) {
  constexpr std::int64_t kBound = kLatticeLimit / 2;
  LatticeBox box{{kBound, kBound, kBound}, {-kBound, -kBound, -kBound}};
  const auto add = [&](const LatticeVector& c) {
    for (std::size_t k = 0; k < 3; ++k) {
      box.lower[k] = std::min(box.lower[k], c[k]);
      box.upper[k] = std::max(box.upper[k], c[k]);
    }
  };
  for (const FramedPlane& plane : framed.planes)
    for (const LatticePoint& p : plane.vertices) add(to_vector(p));
  if (!framed.whole.empty()) {
    add(framed.grid.to_lattice(framed.whole.low));
    add(framed.grid.to_lattice(framed.whole.high));
  }
  std::int64_t extent = 16;
  for (std::size_t k = 0; k < 3; ++k) extent = std::max(extent, box.upper[k] - box.lower[k]);
  for (std::size_t k = 0; k < 3; ++k) {
    box.lower[k] = std::max(-kBound, box.lower[k] - extent / 8);
    box.upper[k] = std::min(kBound, box.upper[k] + extent / 8);
  }
  return box;
}

}  // namespace crossloft
