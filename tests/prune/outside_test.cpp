// Domes over holes and the filling of cracks, against the outside put together anew.
#include "prune/outside.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "brute_solid.h"
#include "cells.h"
#include "prune/cracks.h"
#include "prune/simple_growth.h"

namespace {

using namespace crossloft;
using namespace crossloft::test;

std::uint64_t faces_through(const CellComplex& cell, std::uint32_t t, unsigned i) {
  std::uint64_t common = ~std::uint64_t{0};
  for (const std::uint8_t slot : kFacetSlots[i]) common &= cell.faces_of(cell.mesh.vertices[t][slot])[0];
  return common;
}

/// Parts of the outside by common edges, and for each the faces that it opens to; 0 stands for the space
/// beyond the hull.
std::vector<std::set<std::uint64_t>> openings(const CellComplex& cell, const Flags& kept) {
  const std::uint32_t n = cell.mesh.size();
  Groups parts(n);
  for (std::uint32_t a = 0; a < n; ++a)
    for (std::uint32_t b = 0; b < a; ++b) {
      int common = 0;
      for (const std::uint32_t v : cell.mesh.vertices[a])
        for (const std::uint32_t w : cell.mesh.vertices[b]) common += v == w ? 1 : 0;
      if (common >= 2 && kept[a] == 0 && kept[b] == 0) parts.put_together(a, b);
    }
  std::map<std::size_t, std::set<std::uint64_t>> open;
  for (std::uint32_t t = 0; t < n; ++t) {
    if (kept[t] != 0) continue;
    auto& list = open[parts.of(t)];
    for (unsigned i = 0; i < 4; ++i) {
      if (cell.mesh.neighbours[t][i] != kNone || cell.facets[t][i] == FacetKind::internal) continue;
      list.insert(faces_through(cell, t, i));
    }
  }
  std::vector<std::set<std::uint64_t>> result;
  for (const auto& [part, list] : open) result.push_back(list);
  return result;
}

bool has_hole(const std::vector<std::set<std::uint64_t>>& openings) {
  return std::any_of(openings.begin(), openings.end(),
                     [](const auto& list) { return list.size() == 1 && *list.begin() != 0; });
}

}  // namespace

TEST_CASE("random solids: there is a dome iff a part of the outside opens to one face alone") {
  int with = 0, without = 0;
  for (std::uint32_t seed = 0; seed < 120; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    PlacedCell placed = placed_cell(seed);
    if (seed % 2 != 0) placed.complex = deep_cell(seed);
    const CellComplex& cell = placed.complex;
    for (std::uint32_t i = 0; i < 6; ++i) {
      Flags kept;  // what has no external facet, less some
      for (const auto& f : cell.facets)
        kept.push_back(std::count(f.begin(), f.end(), FacetKind::external) == 0);
      for (std::uint8_t& k : kept) k = k != 0 && random() % 100 >= 3 * i;
      const bool expected = has_hole(openings(cell, kept));
      CHECK(has_dome(cell, kept) == expected);
      CHECK(has_dome(with_many_faces(placed).complex, kept) == expected);
      ++(expected ? with : without);
    }
  }
  MESSAGE("with a dome " << with << ", without " << without);
  CHECK(with > 50);
  CHECK(without > 50);
}

TEST_CASE("what one tetrahedron opens to") {
  const CellComplex cell =
      make_cell({{0, 1, 2, 3}, {1, 2, 3, 4}, {2, 3, 4, 5}}, {1, 1, 1, 2, 2, 2}, {{3, 4, 5}});
  OpeningOf none(cell);
  CHECK(none.kind() == Opening::none);
  OpeningOf lower(cell);  // the triangle 0 1 2 is external; the sides are free
  lower.add(0);
  CHECK(lower.kind() == Opening::wide);
  const CellComplex tent = make_cell({{0, 1, 2, 3}, {0, 2, 1, 4}}, {3, 3, 3, 1, 2}, {});
  OpeningOf hole(tent);
  hole.add(0);  // its three hull facets are all on face 0
  CHECK(hole.kind() == Opening::hole);
  hole.add(1);
  CHECK(hole.kind() == Opening::wide);
}

static Flags refilled(const CellComplex& cell, const Flags& allowed, const Flags& kept) {
  const Ground ground(cell);
  GrowingSolid solid(cell, ground);
  for (std::uint32_t t = 0; t < kept.size(); ++t)
    if (kept[t] != 0) solid.add(t);
  refill_cracks(cell, ground, allowed, solid);
  return solid.kept();
}

TEST_CASE("random solids: cracks are filled only where the solid gets no worse") {
  std::size_t filled = 0, left = 0;
  for (std::uint32_t seed = 200; seed < 500; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const CellComplex cell = seed % 2 == 0 ? random_cell(seed) : deep_cell(seed);
    const BruteSolid brute(cell);
    const Flags allowed = r1_of(cell);
    Flags before = allowed;
    for (std::uint8_t& k : before) k = k != 0 && random() % 10 < 8;
    const Flags kept = refilled(cell, allowed, before);
    const BruteSolid::Counts was = brute.count(before), is = brute.count(kept);
    CHECK(is.genus <= was.genus);
    CHECK(is.voids <= was.voids);
    CHECK(is.outsides <= was.outsides);
    CHECK(is.bodies == was.bodies);
    for (std::uint32_t t = 0; t < kept.size(); ++t) {
      CHECK(before[t] <= kept[t]);
      CHECK(kept[t] <= allowed[t]);
      filled += kept[t] - before[t];
      left += allowed[t] - kept[t];
    }
    std::vector<std::uint32_t> from;
    const CellComplex other = shuffled(cell, random, from);
    Flags moved;
    for (const std::uint32_t t : from) moved.push_back(before[t]);
    moved = refilled(other, r1_of(other), moved);
    for (std::uint32_t t = 0; t < from.size(); ++t) CHECK(moved[t] == kept[from[t]]);
  }
  MESSAGE("filled " << filled << ", left " << left);
  CHECK(filled > 300);
  CHECK(left > 50);
}

TEST_CASE("after growth: what is missing is filled as a whole where that makes no handle") {
  for (std::uint32_t seed = 600; seed < 700; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const CellComplex cell = deep_cell(seed);
    const Ground ground(cell);
    const Flags allowed = r1_of(cell);
    std::vector<std::int32_t> confidence(allowed.size());
    for (std::int32_t& c : confidence) c = static_cast<std::int32_t>(random() % 100);
    GrowingSolid solid(cell, ground);
    const Flags grown = grow_simply(cell, ground, allowed, confidence, {0, 0, {}}, solid).kept;
    CHECK(grown == solid.kept());
    refill_cracks(cell, ground, allowed, solid);
    CHECK(solid.kept() == refilled(cell, allowed, grown));
    const BruteSolid::Counts counts = BruteSolid(cell).count(solid.kept());
    CHECK(counts.genus == 0);
    CHECK(counts.voids == 0);
  }
}
