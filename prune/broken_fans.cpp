#include "broken_fans.h"

#include <algorithm>

namespace crossloft {
namespace {

/// All tetrahedra around an edge on the hull, from the facet `start` on.
std::vector<GapTet> fan_from(const TetMesh& mesh, Facet start, unsigned corner) {
  std::vector<GapTet> fan;
  Turn turn(start.tet, other_facet(start.facet, corner), start.facet);
  for (;;) {
    fan.push_back({turn.tet(), turn.in(), turn.out(), false, false});
    const std::uint32_t n = turn.next(mesh);
    if (n == kNone) return fan;
    turn.enter(mesh, n);
  }
}

/// Most fans are.
bool is_kept_whole(const TetMesh& mesh, const std::vector<std::uint8_t>& kept, Facet start, unsigned corner) {
  Turn turn(start.tet, other_facet(start.facet, corner), start.facet);
  while (kept[turn.tet()] != 0) {
    const std::uint32_t n = turn.next(mesh);
    if (n == kNone) return true;
    turn.enter(mesh, n);
  }
  return false;
}

/// What of a fan is not kept.
std::vector<GapTet> gaps_of(const std::vector<GapTet>& fan, const std::vector<std::uint8_t>& kept) {
  const auto is_open = [&](std::size_t i) { return i < fan.size() && kept[fan[i].tet] == 0; };
  std::vector<GapTet> gaps;
  for (std::size_t i = 0; i < fan.size(); ++i) {
    if (!is_open(i)) continue;
    gaps.push_back(fan[i]);
    gaps.back().is_first = i == 0 || !is_open(i - 1);
    gaps.back().is_last = !is_open(i + 1);
  }
  return gaps;
}

}  // namespace

std::vector<BrokenFan> broken_fans(const CellComplex& complex, const Ground& ground,
                                   const std::vector<std::uint8_t>& kept) {
  std::vector<BrokenFan> broken;
  for (std::uint32_t g = 0; g < ground.size(); ++g)
    for (unsigned k = 0; k < 3; ++k) {
      const std::uint32_t other = ground.neighbour(g, k);
      if (other == kNone || other < g) continue;
      const Facet& start = ground.facet(g);
      const auto& slots = kFacetSlots[start.facet];
      const unsigned i = slots[k], j = slots[(k + 1) % 3];
      if (is_kept_whole(complex.mesh, kept, start, kEdgeCorner[i][j])) continue;
      const std::vector<GapTet> fan = fan_from(complex.mesh, start, kEdgeCorner[i][j]);
      const auto& v = complex.mesh.vertices[start.tet];
      broken.push_back({{std::min(v[i], v[j]), std::max(v[i], v[j])}, {g, other}, gaps_of(fan, kept)});
    }
  return broken;
}

}  // namespace crossloft
