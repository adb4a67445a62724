#include "ground.h"

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

/// A place on the way around an edge: in a tetrahedron, from one of its facets at the edge to the other one.
/// Facets are also the slots opposite to them, whose vertices are not on the edge.
class Turn {
 public:
  Turn(std::uint32_t tet, unsigned out, unsigned in) : tet_(tet), out_(out), in_(in) {}

  Facet out() const { return {tet_, static_cast<std::uint8_t>(out_)}; }
  unsigned corner() const { return opposite_edge(out_, in_); }
  std::uint32_t next(const TetMesh& mesh) const { return mesh.neighbours[tet_][out_]; }

  /// The vertex opposite to where it came in stays; what is opposite to that is the way out.
  void enter(const TetMesh& mesh, std::uint32_t n) {
    const std::uint32_t stays = mesh.vertices[tet_][in_];
    in_ = facet_towards(mesh, n, tet_);
    out_ = slot_of(mesh.vertices[n], stays);
    tet_ = n;
  }

 private:
  std::uint32_t tet_;
  unsigned out_, in_;
};

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
  Turn turn(from.tet, other_facet(from.facet, corner), from.facet);
  for (std::uint32_t n; (n = turn.next(complex_.mesh)) != kNone;) turn.enter(complex_.mesh, n);
  corner = turn.corner();
  return turn.out();
}

Facet turn_through_solid(const CellComplex& complex, const Ground& ground,
                         const std::vector<std::uint8_t>& kept, Facet from, unsigned corner) {
  const TetMesh& mesh = complex.mesh;
  for (Turn turn(from.tet, from.facet, other_facet(from.facet, corner));;) {
    const std::uint32_t n = turn.next(mesh);
    if (n != kNone && kept[n] != 0) {
      turn.enter(mesh, n);
      continue;
    }
    const Facet out = turn.out();
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
