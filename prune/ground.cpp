#include "ground.h"

#include "disjoint_sets.h"

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

}  // namespace

unsigned Ground::side_of(unsigned i, unsigned corner) { return kSides[i][corner]; }

Ground::Ground(const CellComplex& complex) : complex_(complex), of_facet_(complex.mesh.size()) {
  for (std::uint32_t t = 0; t < complex.mesh.size(); ++t)
    for (std::uint8_t i = 0; i < 4; ++i) {
      const bool internal = complex.facets[t][i] == FacetKind::internal;
      of_facet_[t][i] = internal ? size() : kNone;
      if (internal) facets_.push_back({t, i});
    }
  neighbours_.assign(size(), {kNone, kNone, kNone});
  DisjointSets parts(size());
  for (std::uint32_t g = 0; g < size(); ++g)
    for (unsigned k = 0; k < 3; ++k) {
      if (neighbours_[g][k] != kNone) continue;  // found from the other side
      const auto& slots = kFacetSlots[facets_[g].facet];
      unsigned corner = kEdgeCorner[slots[k]][slots[(k + 1) % 3]];
      const Facet end = other_end(facets_[g], corner);
      const std::uint32_t other = at(end.tet, end.facet);
      if (other == kNone) continue;
      neighbours_[g][k] = other;
      neighbours_[other][side_of(end.facet, corner)] = g;
      parts.join(g, other);
    }
  for (std::uint32_t g = 0; g < size(); ++g) parts_.push_back(parts.find(g));
}

std::uint32_t Ground::part_count() const {
  std::uint32_t count = 0;
  for (std::uint32_t g = 0; g < size(); ++g) count += parts_[g] == g ? 1U : 0U;
  return count;
}

/// The hull facet at the other end of the fan around an edge on the hull; `corner` becomes the edge there.
Facet Ground::other_end(Facet from, unsigned& corner) const {
  const TetMesh& mesh = complex_.mesh;
  for (std::uint32_t t = from.tet, i = from.facet;;) {
    const unsigned out = other_facet(i, corner);
    const std::uint32_t n = mesh.neighbours[t][out];
    if (n == kNone) return {t, static_cast<std::uint8_t>(out)};
    corner = same_corner(mesh, t, corner, n);
    i = facet_towards(mesh, n, t);
    t = n;
  }
}

Facet turn_through_solid(const CellComplex& complex, const Ground& ground,
                         const std::vector<std::uint8_t>& kept, Facet from, unsigned corner) {
  const TetMesh& mesh = complex.mesh;
  for (std::uint32_t t = from.tet, i = from.facet;;) {
    if (const std::uint32_t g = ground.at(t, i); g != kNone) {
      const std::uint32_t beyond = ground.across(g, corner);
      if (beyond == kNone) return {};
      const Facet next = ground.facet(beyond);
      corner = same_corner(mesh, t, corner, next.tet);
      t = next.tet;
      if (kept[t] == 0) return next;
      i = other_facet(next.facet, corner);
      continue;
    }
    const std::uint32_t n = mesh.neighbours[t][i];
    if (n == kNone || kept[n] == 0) return {t, static_cast<std::uint8_t>(i)};
    corner = same_corner(mesh, t, corner, n);
    i = other_facet(facet_towards(mesh, n, t), corner);
    t = n;
  }
}

}  // namespace crossloft
