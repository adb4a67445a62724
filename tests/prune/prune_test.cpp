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
    CHECK(prune(cell).r3 >= prune(cell, PruneMode::paper).r2);
  }
}
