#include "voronoi_facet.h"

#include <algorithm>
#include <array>

namespace crossloft {
namespace {

/// Of an edge from slot a to slot b of a positive tetrahedron: the slot that is behind it and the edge's
/// number. The fourth slot is ahead: (a, b, behind, ahead) is an even permutation.
struct SlotTurn {
  std::uint8_t behind, edge;
};
constexpr std::array<std::array<SlotTurn, 4>, 4> kTurns{{{{{0, 0}, {2, 0}, {3, 1}, {1, 2}}},
                                                         {{{3, 0}, {0, 0}, {0, 3}, {2, 4}}},
                                                         {{{1, 1}, {3, 3}, {0, 0}, {0, 5}}},
                                                         {{{2, 2}, {0, 4}, {1, 5}, {0, 0}}}}};

std::size_t slot_of(const std::array<std::uint32_t, 4>& vertices, std::uint32_t v) {
  return v == vertices[0] ? 0 : v == vertices[1] ? 1 : v == vertices[2] ? 2 : 3;
}

}  // namespace

EdgeWedge VoronoiFacet::wedge(const TetMesh& mesh, std::uint32_t tet) const {
  const auto& v = mesh.vertices[tet];
  const std::size_t a = slot_of(v, i), b = slot_of(v, j);
  const SlotTurn turn = kTurns[a][b];
  return {tet, v[turn.behind], v[6 - a - b - turn.behind], turn.edge};
}

/// From `start` on until the walk closes (true) or leaves the hull (false).
bool VoronoiFacet::go_round(const TetMesh& mesh, EdgeWedge start) {
  wedges.assign(1, start);
  for (;;) {
    const EdgeWedge& last = wedges.back();
    const std::uint32_t next = mesh.neighbours[last.tet][slot_of(mesh.vertices[last.tet], last.behind)];
    if (next == kNone) return false;
    if (next == start.tet) return true;
    wedges.push_back(wedge(mesh, next));
  }
}

void VoronoiFacet::walk(const TetMesh& mesh, std::uint32_t tet, std::size_t edge) {
  const auto& v = mesh.vertices[tet];
  const std::uint32_t a = v[kEdgeSlots[edge][0]], b = v[kEdgeSlots[edge][1]];
  i = std::min(a, b);
  j = std::max(a, b);
  EdgeWedge first = wedge(mesh, tet);
  on_hull = !go_round(mesh, first);
  if (on_hull) {
    const auto previous = [&] {
      return mesh.neighbours[first.tet][slot_of(mesh.vertices[first.tet], first.ahead)];
    };
    while (previous() != kNone) first = wedge(mesh, previous());
    go_round(mesh, first);
  }
  set_sides();
}

void VoronoiFacet::set_sides() {
  sides.clear();
  if (on_hull) sides.push_back({wedges[0].behind, kNone, wedges[0].tet, kNone, wedges[0].ahead});
  for (std::size_t k = 0; k + 1 < wedges.size(); ++k)
    sides.push_back(
        {wedges[k].ahead, wedges[k].tet, wedges[k + 1].tet, wedges[k].behind, wedges[k + 1].ahead});
  const EdgeWedge &last = wedges.back(), &first = wedges.front();
  if (on_hull)
    sides.push_back({last.ahead, last.tet, kNone, last.behind, kNone});
  else
    sides.push_back({last.ahead, last.tet, first.tet, last.behind, first.ahead});
}

}  // namespace crossloft
