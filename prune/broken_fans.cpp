#include "broken_fans.h"

#include <algorithm>

namespace crossloft {
namespace {

/// All tetrahedra around an edge on the hull, from the facet `start` on.
std::vector<GapTet> fan_from(const TetMesh& mesh, Facet start, unsigned corner) {
  std::vector<GapTet> fan;
  for (std::uint32_t t = start.tet, from = start.facet;;) {
    const std::uint8_t to = other_facet(from, corner);
    fan.push_back({t, static_cast<std::uint8_t>(from), to});
    const std::uint32_t n = mesh.neighbours[t][to];
    if (n == kNone) return fan;
    corner = same_corner(mesh, t, corner, n);
    from = facet_towards(mesh, n, t);
    t = n;
  }
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
      const std::vector<GapTet> fan = fan_from(complex.mesh, start, kEdgeCorner[i][j]);
      if (std::all_of(fan.begin(), fan.end(), [&](const GapTet& t) { return kept[t.tet] != 0; })) continue;
      const auto& v = complex.mesh.vertices[start.tet];
      broken.push_back({{std::min(v[i], v[j]), std::max(v[i], v[j])}, {g, other}, only_gap(fan, kept)});
    }
  return broken;
}

}  // namespace crossloft
