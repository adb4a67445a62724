// Ground and the topology of a cell, against their definitions on sets of vertices.
#include "prune/cell_topology.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "brute_solid.h"
#include "cells.h"
#include "prune/links.h"
#include "prune/prune.h"

namespace {

using namespace crossloft;
using namespace crossloft::test;

Simplex triangle_of(const CellComplex& cell, Facet f) {
  Simplex s;
  for (const std::uint8_t slot : kFacetSlots[f.facet]) s.push_back(cell.mesh.vertices[f.tet][slot]);
  return sorted(s);
}

/// Random subsets of R1, all of it, none, and what the mode `joint` keeps.
std::vector<Flags> solids(const CellComplex& cell, std::mt19937& random) {
  const Flags r1 = r1_of(cell);
  std::vector<Flags> list{r1, Flags(r1.size(), 0), prune(cell, PruneMode::joint).kept};
  for (const std::uint32_t share : {2U, 5U, 8U, 9U}) {
    list.push_back(r1);
    for (std::uint8_t& k : list.back()) k = k != 0 && random() % 10 < share;
  }
  return list;
}

void check_same(const CellTopology& t, const BruteSolid::Counts& brute) {
  CHECK(brute.every_part_is_a_surface);
  CHECK(t.sections == brute.sections);
  CHECK(t.bodies == brute.bodies);
  CHECK(t.outsides == brute.outsides);
  CHECK(t.voids == brute.voids);
  CHECK(std::int64_t{t.genus} == brute.genus);
  CHECK(t.euler == brute.euler);
  CHECK(t.curves == brute.curves);
  CHECK(t.bare == brute.bare);
}

/// Six tetrahedra around the edge 0-1.
CellComplex ring(const std::set<Triangle>& internal, std::vector<std::uint64_t> masks) {
  std::vector<Tet> tets;
  for (std::uint32_t i = 0; i < 6; ++i) tets.push_back({0, 1, 2 + i, 2 + (i + 1) % 6});
  return make_cell(tets, masks, internal);
}

}  // namespace

TEST_CASE("random cells: the ground is the internal hull triangles and how they hang together") {
  std::size_t seen = 0, parts_seen = 0;
  for (std::uint32_t seed = 0; seed < 150; ++seed) {
    CAPTURE(seed);
    const CellComplex cell = random_cell(seed);
    const Ground ground(cell);
    const BruteSolid brute(cell);
    const std::vector<std::size_t> prisms = brute.ground();
    REQUIRE(ground.size() == prisms.size());
    const Groups sections = brute.bodies(Flags(cell.mesh.size(), 0));
    std::map<Simplex, std::size_t> prism_of;
    for (const std::size_t p : prisms) prism_of[brute.pieces()[p]] = p;
    for (std::uint32_t g = 0; g < ground.size(); ++g) {
      const Facet f = ground.facet(g);
      const Simplex triangle = triangle_of(cell, f);
      REQUIRE(prism_of.count(triangle) == 1);
      CHECK(ground.at(f.tet, f.facet) == g);
      for (std::uint32_t h = 0; h < ground.size(); ++h) {
        const bool together =
            sections.of(prism_of[triangle]) == sections.of(prism_of[triangle_of(cell, ground.facet(h))]);
        CHECK((ground.part(g) == ground.part(h)) == together);
      }
      CHECK(ground.part(g) <= g);
      for (unsigned k = 0; k < 3; ++k) {
        const auto& v = cell.mesh.vertices[f.tet];
        const unsigned a = kFacetSlots[f.facet][k], b = kFacetSlots[f.facet][(k + 1) % 3];
        const Simplex side = sorted({v[a], v[b]});
        std::uint32_t other = kNone;
        for (std::uint32_t h = 0; h < ground.size(); ++h) {
          const Simplex there = triangle_of(cell, ground.facet(h));
          if (h != g && std::includes(there.begin(), there.end(), side.begin(), side.end())) other = h;
        }
        CHECK(ground.neighbour(g, k) == other);
        CHECK(ground.across(g, kEdgeCorner[a][b]) == other);
        ++seen;
      }
    }
    CHECK(ground.part_count() == brute.count(Flags(cell.mesh.size(), 0)).sections);
    parts_seen += ground.part_count() > 1 ? 1U : 0U;
  }
  CHECK(seen > 1000);
  CHECK(parts_seen > 20);
}

TEST_CASE("random cells: all counts are those of the definition") {
  CellTopology sum;
  for (std::uint32_t seed = 0; seed < 250; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const CellComplex cell = random_cell(seed);
    const Ground ground(cell);
    const BruteSolid brute(cell);
    for (const Flags& kept : solids(cell, random)) {
      CAPTURE(kept);
      const CellTopology t = count_topology(cell, ground, kept);
      CHECK(t.bad_links == census_links(cell, kept, Flags(cell.vertex_count, 1)).bad_links());
      check_same(t, brute.count(kept));
      sum.genus += t.genus;
      sum.voids += t.voids;
      sum.bare += t.bare;
      sum.outsides += t.outsides - std::min(t.outsides, 1U);
      sum.bodies += t.bodies < t.sections ? 1U : 0U;
    }
  }
  MESSAGE("handles " << sum.genus << ", voids " << sum.voids << ", bare " << sum.bare
                     << ", parts of the outside but one " << sum.outsides << ", joined " << sum.bodies);
  // Everything that is counted occurred, or the comparison above is empty.
  CHECK(sum.genus > 20);
  CHECK(sum.voids > 50);
  CHECK(sum.bare > 500);
  CHECK(sum.outsides > 50);
  CHECK(sum.bodies > 50);
}

TEST_CASE("random cells: the counts do not depend on the numbers of the tetrahedra") {
  for (std::uint32_t seed = 500; seed < 560; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const CellComplex cell = random_cell(seed);
    std::vector<std::uint32_t> from;
    const CellComplex other = shuffled(cell, random, from);
    const Ground ground(cell), other_ground(other);
    for (const Flags& kept : solids(cell, random)) {
      Flags moved;
      for (const std::uint32_t t : from) moved.push_back(kept[t]);
      CHECK(count_topology(cell, ground, kept) == count_topology(other, other_ground, moved));
    }
  }
}

TEST_CASE("bodies without ground have walls without boundary, and wedges at an edge are apart") {
  const CellComplex cell = ring({}, std::vector<std::uint64_t>(8, 0));
  const CellTopology some = count_topology(cell, Ground(cell), {1, 1, 1, 1, 0, 0});
  CHECK(some.sections == 0);
  CHECK(some.bodies == 1);
  CHECK(some.outsides == 1);
  CHECK(some.voids == 1);
  CHECK(some.genus == 0);
  CHECK(some.euler == 2);
  CHECK(some.curves == 0);
  // Two opposite ones touch along the edge 0-1 alone: gluing takes them apart there.
  const CellTopology two = count_topology(cell, Ground(cell), {1, 0, 0, 1, 0, 0});
  CHECK(two.bodies == 2);
  CHECK(two.euler == 4);
  CHECK(two.voids == 2);
  CHECK(two.outsides == 1);
}

TEST_CASE("over a disk of section the solid is a disk, whether tetrahedra stand on it or not") {
  // A fan of five triangles around vertex 0 on face 0, one short of a full turn; 0-1 leads inwards.
  const CellComplex cell =
      ring({{0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 7}}, {1, 2, 1, 1, 1, 1, 1, 1});
  const CellTopology all = count_topology(cell, Ground(cell), {1, 1, 1, 1, 1, 0});
  CHECK(all.sections == 1);
  CHECK(all.bodies == 1);
  CHECK(all.curves == 1);
  CHECK(all.genus == 0);
  CHECK(all.euler == 1);
  CHECK(all.bare == 0);
  const CellTopology bare = count_topology(cell, Ground(cell), {1, 1, 0, 1, 1, 0});
  CHECK(bare.bare == 1);
  CHECK(bare.euler == 1);
  CHECK(bare.genus == 0);
}
