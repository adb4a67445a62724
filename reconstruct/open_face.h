#pragma once
/// The interior of a face of the arrangement.

#include <algorithm>
#include <utility>
#include <vector>

#include "../arrangement/section_graph.h"

namespace crossloft {

class OpenFace {
 public:
  OpenFace(const SectionGraph& graph, const Arrangement& arrangement, FaceId face) {
    const std::uint32_t own = arrangement.plane_of(face).value;
    for (const ArrEdgeId edge : arrangement.edges_of(face))
      for (const PlaneId p : arrangement.planes_of(edge))
        if (p.value != own && !arrangement.is_box(p))
          sides_.emplace_back(graph.planes[p.value], sign_at(arrangement.signs(face), p));
  }
  /// True iff a point of the face's plane is strictly inside the face; borders on the box do not count.
  bool contains(const LatticePoint& p) const {
    return std::all_of(sides_.begin(), sides_.end(),
                       [&](const auto& side) { return side_of_plane(side.first, p) == side.second; });
  }

 private:
  std::vector<std::pair<LatticePlane, int>> sides_;  ///< planes that bound the face, and its side of each
};

}  // namespace crossloft
