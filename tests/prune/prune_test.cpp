// Pruning against its definitions, on random and hand-made cells.
#include "prune/prune.h"

#include <doctest/doctest.h>

#include "brute_force.h"
#include "cells.h"
#include "prune/verify.h"

namespace {

using namespace crossloft;
using namespace crossloft::test;

BruteForce::Solid solid_of(const CellComplex& cell, const PruneResult& result) {
  BruteForce::Solid solid;
  for (std::uint32_t t = 0; t < cell.mesh.size(); ++t) {
    const Tet& v = cell.mesh.vertices[t];
    if (result.kept[t] != 0) solid.insert({v[0], v[1], v[2], v[3]});
  }
  return solid;
}

constexpr PruneMode kModes[] = {PruneMode::joint, PruneMode::paper, PruneMode::paper_literal};

struct Totals {
  std::uint64_t r0 = 0, r1 = 0, r2 = 0, r3 = 0;

  void add(const PruneResult& r) {
    r0 += r.r0;
    r1 += r.r1;
    r2 += r.r2;
    r3 += r.r3;
  }
};

}  // namespace

TEST_CASE("random cells: every mode does what its definition says") {
  Totals totals[3];
  for (std::uint32_t seed = 0; seed < 120; ++seed) {
    CAPTURE(seed);
    const CellComplex cell = random_cell(seed);
    REQUIRE(verify(cell));
    const BruteForce brute(cell);
    for (unsigned m = 0; m < 3; ++m) {
      CAPTURE(m);
      const PruneResult result = prune(cell, kModes[m]);
      const auto solid = solid_of(cell, result);
      CHECK(solid == brute.run(kModes[m]));
      CHECK(verify(cell, result) == brute.is_solid(solid));
      if (kModes[m] != PruneMode::paper_literal) CHECK(verify(cell, result));
      totals[m].add(result);
    }
  }
  for (const Totals& t : totals) MESSAGE("tetrahedra: " << t.r0 << " " << t.r1 << " " << t.r2 << " " << t.r3);
  // Every step did something somewhere, or the comparison above is empty.
  CHECK(totals[0].r1 < totals[0].r0);
  CHECK(totals[0].r3 < totals[0].r1);
  CHECK(totals[1].r2 < totals[1].r3);
  CHECK(totals[1].r3 != totals[2].r3);
}

TEST_CASE("random cells: the order of tetrahedra and of their vertices does not matter") {
  for (std::uint32_t seed = 1000; seed < 1080; ++seed) {
    CAPTURE(seed);
    const CellComplex cell = random_cell(seed);
    std::mt19937 random(seed);
    std::vector<std::uint32_t> from;
    const CellComplex other = shuffled(cell, random, from);
    REQUIRE(verify(other));
    for (const PruneMode mode : kModes)
      CHECK(solid_of(cell, prune(cell, mode)) == solid_of(other, prune(other, mode)));
  }
}

TEST_CASE("joint keeps what two-plane tetrahedra alone would keep") {
  for (std::uint32_t seed = 2000; seed < 2060; ++seed) {
    CAPTURE(seed);
    const CellComplex cell = random_cell(seed);
    CHECK(prune(cell, PruneMode::joint).r3 >= prune(cell, PruneMode::paper).r2);
  }
}

TEST_CASE("two triangles are joined by the prism between them") {
  const CellComplex cell =
      make_cell({{0, 1, 2, 3}, {1, 2, 3, 4}, {2, 3, 4, 5}}, {1, 1, 1, 2, 2, 2}, {{0, 1, 2}, {3, 4, 5}});
  for (const PruneMode mode : kModes) {
    const PruneResult result = prune(cell, mode);
    CHECK(result.r1 == 3);
    CHECK(result.r2 == 3);
    CHECK(result.r3 == 3);
  }
}

TEST_CASE(
    "a tetrahedron between two edges falls with the ground of one, and the vertex cone on the other with "
    "it") {
  // As above, but the upper triangle 3 4 5 is outside and 3-4 borders on an internal triangle 3 4 6 below it.
  const std::vector<Tet> tets{{0, 1, 2, 3}, {1, 2, 3, 4}, {2, 3, 4, 5}, {1, 3, 4, 6}};
  const std::vector<std::uint64_t> masks{1, 1, 1, 2, 2, 2, 2};
  const PruneResult whole =
      prune(make_cell(tets, masks, {{0, 1, 2}, {3, 4, 5}, {3, 4, 6}}), PruneMode::joint);
  CHECK(whole.r3 == 4);
  const PruneResult half = prune(make_cell(tets, masks, {{0, 1, 2}, {3, 4, 6}}), PruneMode::joint);
  CHECK(half.kept == std::vector<std::uint8_t>{1, 1, 0, 1});  // the other side of 3-4 still has ground
  const PruneResult none =
      prune(make_cell({tets[0], tets[1], tets[2]}, masks, {{0, 1, 2}}), PruneMode::joint);
  CHECK(none.r3 == 0);
}

TEST_CASE("two sections that would meet in a point only stay apart") {
  // The cones from 3 over the triangles 0 1 2 and 4 5 6 of face 0: at 3, on face 1, they touch in the vertex,
  // and nothing of face 1 is there to join them.
  const CellComplex cell =
      make_cell({{0, 1, 2, 3}, {4, 5, 6, 3}}, {1, 1, 1, 2, 1, 1, 1}, {{0, 1, 2}, {4, 5, 6}});
  const PruneResult result = prune(cell, PruneMode::joint);
  CHECK(result.r1 == 2);
  CHECK(result.r3 == 0);
}

TEST_CASE("two grounded edges alone make no solid, though they conform") {
  CellComplex cell = make_cell({{0, 1, 2, 3}}, {1, 1, 2, 2}, {});
  for (const unsigned e : {0U, 5U}) cell.edges[0][e] = EdgeKind::contour;
  for (const PruneMode mode : kModes) {
    CHECK(prune(cell, mode).r1 == 1);
    CHECK(prune(cell, mode).r3 == 0);
  }
}

TEST_CASE("an empty cell") {
  CHECK(prune(CellComplex{}, PruneMode::joint).kept.empty());
  CHECK(prune(CellComplex{}, CellShape{}, PruneOptions{}).kept.empty());
  CHECK(verify(CellComplex{}, prune(CellComplex{}, PruneMode::joint)));
}
