#include "ground.h"

#include <utility>

#include "../geom/disjoint_sets.h"

namespace crossloft {
namespace {

/// [facet][corner]: the side of the facet that the edge is.
constexpr std::array<std::array<std::uint8_t, kCorners>, 4> side_table() {
  std::array<std::array<std::uint8_t, kCorners>, 4> table{};
  for (unsigned i = 0; i < 4; ++i)
    for (unsigned k = 0; k < 3; ++k)
      table[i][kEdgeCorner[kFacetSlots[i][k]][kFacetSlots[i][(k + 1) % 3]]] = static_cast<std::uint8_t>(k);
  return table;
}
constexpr auto kSides = side_table();

/// Finds the other triangle at a side: on the hull each edge has two. Sides wait at the vertex of theirs that
/// fewer triangles have: over the edges of a planar graph the smaller degrees add up to O(n) (Chiba and
/// Nishizeki 1985), however many sides a hub has.
class SideMatcher {
 public:
  /// `degrees`: of the vertices, in triangles.
  SideMatcher(std::vector<std::uint32_t> degrees, std::uint32_t sides)
      : degrees_(std::move(degrees)), last_(degrees_.size(), kNone), sides_(sides) {}

  /// The other triangle's side from b to a if it came before, else kNone and this one waits for it.
  std::uint32_t match(std::uint32_t side, std::uint32_t a, std::uint32_t b) {
    if (degrees_[b] < degrees_[a] || (degrees_[b] == degrees_[a] && b < a)) std::swap(a, b);
    for (std::uint32_t s = last_[a]; s != kNone; s = sides_[s].before)
      if (sides_[s].other == b) return s;
    sides_[side] = {b, last_[a]};
    last_[a] = side;
    return kNone;
  }

 private:
  struct Side {
    std::uint32_t other, before;  ///< `before`: the side that waits there since before it
  };
  std::vector<std::uint32_t> degrees_;
  std::vector<std::uint32_t> last_;  ///< by vertex
  std::vector<Side> sides_;
};

}  // namespace

unsigned Ground::side_of(unsigned i, unsigned corner) { return kSides[i][corner]; }

Ground::Ground(const CellComplex& complex) : complex_(complex), first_(complex.mesh.size(), kNone) {
  for (std::uint32_t t = 0; t < complex.mesh.size(); ++t) {
    if (!stands_on_section(complex, t)) continue;
    first_[t] = size();
    for (std::uint8_t i = 0; i < 4; ++i)
      if (is_ground(t, i)) facets_.push_back({t, i});
  }
  neighbours_.assign(size(), {kNone, kNone, kNone});
  DisjointSets parts(size());
  std::vector<std::uint32_t> degrees(complex.vertex_count, 0);
  for (const Facet& f : facets_)
    for (const unsigned slot : kFacetSlots[f.facet]) ++degrees[complex.mesh.vertices[f.tet][slot]];
  SideMatcher matcher(std::move(degrees), 3 * size());
  for (std::uint32_t g = 0; g < size(); ++g) {
    const auto& v = complex.mesh.vertices[facets_[g].tet];
    const auto& slots = kFacetSlots[facets_[g].facet];
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t met = matcher.match(3 * g + k, v[slots[k]], v[slots[(k + 1) % 3]]);
      if (met == kNone) continue;
      neighbours_[g][k] = met / 3;
      neighbours_[met / 3][met % 3] = g;
      parts.join(g, met / 3);
    }
  }
  parts_.reserve(size());
  for (std::uint32_t g = 0; g < size(); ++g) parts_.push_back(parts.find(g));
}

std::uint32_t Ground::part_count() const {
  std::uint32_t count = 0;
  for (std::uint32_t g = 0; g < size(); ++g) count += parts_[g] == g ? 1U : 0U;
  return count;
}

Facet turn_through_solid(const CellComplex& complex, const Ground& ground,
                         const std::vector<std::uint8_t>& kept, Facet from, unsigned corner) {
  return turn_through_solid(complex, ground, kept,
                            Turn(from.tet, from.facet, other_facet(from.facet, corner)));
}

Facet turn_through_solid(const CellComplex& complex, const Ground& ground,
                         const std::vector<std::uint8_t>& kept, Turn turn) {
  const TetMesh& mesh = complex.mesh;
  for (;;) {
    const std::uint32_t n = turn.next(mesh);
    if (n != kNone && kept[n] != 0) {
      turn.enter(mesh, n);
      continue;
    }
    const Facet out{turn.tet(), turn.out()};
    const std::uint32_t g = n == kNone ? ground.at(out.tet, out.facet) : kNone;
    if (g == kNone) return out;
    const std::uint32_t beyond = ground.across(g, turn.corner());
    if (beyond == kNone) return {};
    const Facet next = ground.facet(beyond);
    if (kept[next.tet] == 0) return next;
    const unsigned there = same_corner(mesh, out.tet, turn.corner(), next.tet);
    turn = Turn(next.tet, other_facet(next.facet, there), next.facet);
  }
}

}  // namespace crossloft
