// Parts of links and bodies against what hangs together by definition.
#include "prune/link_parts.h"

#include <doctest/doctest.h>

#include <map>
#include <random>
#include <set>

#include "brute_solid.h"
#include "cells.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

/// By piece of the brute solid: what is asked of it. Tetrahedra come first, then the prisms of the hull.
struct Asked {
  const LinkParts& parts;
  const CellComplex& cell;
  std::map<std::size_t, std::uint32_t> ground_of;  ///< by piece

  std::uint32_t part(std::size_t piece, std::uint32_t v) const {
    if (piece < cell.mesh.size()) return parts.of_tet(static_cast<std::uint32_t>(piece), v);
    return parts.of_ground(ground_of.at(piece), v);
  }
  std::uint32_t body(std::size_t piece) const {
    if (piece < cell.mesh.size()) return parts.body_of_tet(static_cast<std::uint32_t>(piece));
    return parts.body_of_ground(ground_of.at(piece));
  }
};

std::map<std::size_t, std::uint32_t> ground_numbers(const CellComplex& cell, const Ground& ground,
                                                    const BruteSolid& solid) {
  std::map<std::size_t, std::uint32_t> numbers;
  for (std::uint32_t g = 0; g < ground.size(); ++g) {
    const Triangle t = facet_vertices(cell.mesh, ground.facet(g).tet, ground.facet(g).facet);
    numbers[solid.across(ground.facet(g).tet, Simplex(t.begin(), t.end()))] = g;
  }
  return numbers;
}

/// Counts that show that the cells are not all alike.
struct Seen {
  std::size_t apart_at_vertex = 0, several_bodies = 0;
};

std::vector<std::size_t> pieces_at(const BruteSolid& solid, const Flags& kept, const Simplex& simplex) {
  std::vector<std::size_t> at;
  for (std::size_t p = 0; p < solid.pieces().size(); ++p)
    if (solid.is_solid(kept, p) && has(solid.pieces()[p], simplex)) at.push_back(p);
  return at;
}

void check_parts(const CellComplex& cell, const Flags& kept, Seen& seen) {
  const Ground ground(cell);
  const BruteSolid solid(cell);
  const LinkParts parts(cell, ground, kept);
  const Asked asked{parts, cell, ground_numbers(cell, ground, solid)};
  const std::vector<std::size_t> inside = pieces_at(solid, kept, {});
  const Groups bodies = solid.bodies(kept);
  std::set<std::uint32_t> different;
  for (const std::size_t p : inside) {
    different.insert(asked.body(p));
    CHECK((asked.body(p) == asked.body(inside[0])) == (bodies.of(p) == bodies.of(inside[0])));
  }
  seen.several_bodies += different.size() > 1 ? 1U : 0U;
  for (std::uint32_t v = 0; v < cell.vertex_count; ++v) {
    const std::vector<std::size_t> at = pieces_at(solid, kept, {v});
    const Groups star = solid.star(kept, {v});
    for (std::size_t i = 0; i < at.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const bool same = asked.part(at[i], v) == asked.part(at[j], v);
        CHECK(same == (star.of(at[i]) == star.of(at[j])));
        seen.apart_at_vertex += same ? 0U : 1U;
      }
  }
}

}  // namespace

TEST_CASE("random cells: parts of links and bodies hang together through triangles") {
  Seen seen;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const CellComplex cell = seed % 2 == 0 ? random_cell(seed) : deep_cell(seed);
    for (const std::uint32_t share : {0U, 3U, 6U, 10U}) {
      Flags kept(cell.mesh.size());
      for (std::uint8_t& k : kept) k = random() % 10 < share;
      check_parts(cell, kept, seen);
    }
  }
  CHECK(seen.apart_at_vertex > 1000);
  CHECK(seen.several_bodies > 50);
}
