#include "broken_fans.h"

#include <algorithm>

namespace crossloft {
namespace {

/// All tetrahedra around an edge on the hull, from the facet `start` on.
std::vector<GapTet> fan_from(const TetMesh& mesh, Facet start, unsigned corner) {
  std::vector<GapTet> fan;
  Turn turn(start.tet, other_facet(start.facet, corner), start.facet);
  for (;;) {
    fan.push_back({turn.tet(), turn.in(), turn.out()});
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

/// The fan without what is kept at its two ends; nothing if something is kept in between.
std::vector<GapTet> only_gap(const std::vector<GapTet>& fan, const std::vector<std::uint8_t>& kept) {
  const auto is_kept = [&](const GapTet& g) { return kept[g.tet] != 0; };
  const auto first = std::find_if_not(fan.begin(), fan.end(), is_kept);
  const auto last = std::find_if_not(fan.rbegin(), fan.rend(), is_kept).base();
  if (std::any_of(first, last, is_kept)) return {};
  return {first, last};
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
      broken.push_back({{std::min(v[i], v[j]), std::max(v[i], v[j])}, {g, other}, only_gap(fan, kept)});
    }
  return broken;
}

}  // namespace crossloft
