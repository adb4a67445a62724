// Spikes, against bodies put together from sets of vertices.
#include "prune/spikes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "brute_solid.h"
#include "cells.h"
#include "prune/star.h"

namespace {

using namespace crossloft;
using namespace crossloft::test;

constexpr std::int32_t kLimit = 900;

/// Faces and parts of the sections that the body of a piece stands on.
struct Stand {
  std::set<std::uint64_t> faces;
  std::set<std::size_t> parts;
};

Stand stand_of(const CellComplex& cell, const BruteSolid& brute, const Flags& kept, std::size_t body) {
  const Groups bodies = brute.bodies(kept), sections = brute.bodies(Flags(kept.size(), 0));
  Stand stand;
  for (const std::size_t p : brute.ground()) {
    if (bodies.of(p) != body) continue;
    std::uint64_t faces = ~std::uint64_t{0};
    for (const std::uint32_t v : brute.pieces()[p]) faces &= cell.faces_of(v)[0];
    stand.faces.insert(faces);
    stand.parts.insert(sections.of(p));
  }
  return stand;
}

}  // namespace

TEST_CASE("random cells: spikes are the bodies on one part of one face that are nowhere sure") {
  std::size_t found = 0, sure = 0;
  for (std::uint32_t seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const CellComplex cell = random_cell(seed);
    const Ground ground(cell);
    const BruteSolid brute(cell);
    Flags kept = r1_of(cell);
    std::vector<std::int32_t> confidence;
    for (std::uint8_t& k : kept) {
      confidence.push_back(static_cast<std::int32_t>(random() % 1000));
      k = k != 0 && random() % 3 != 0;
    }
    const Groups bodies = brute.bodies(kept);
    std::set<std::vector<std::uint32_t>> expected;
    for (std::uint32_t t = 0; t < kept.size(); ++t) {
      if (kept[t] == 0) continue;
      std::vector<std::uint32_t> tets;
      std::int32_t highest = 0;
      for (std::uint32_t u = 0; u < kept.size(); ++u)
        if (kept[u] != 0 && bodies.of(u) == bodies.of(t))
          tets.push_back(u), highest = std::max(highest, confidence[u]);
      const Stand stand = stand_of(cell, brute, kept, bodies.of(t));
      if (stand.faces.size() != 1 || stand.parts.size() != 1) continue;
      if (highest < kLimit) expected.insert(tets);
      sure += highest >= kLimit ? 1 : 0;
    }
    const std::vector<Spike> spikes =
        find_spikes(cell, ground, kept, kLimit, [&](std::uint32_t t) { return confidence[t]; });
    std::set<std::vector<std::uint32_t>> tets;
    for (const Spike& spike : spikes) {
      tets.insert(spike.tets);
      std::int32_t highest = 0;
      for (const std::uint32_t t : spike.tets) highest = std::max(highest, confidence[t]);
      CHECK(spike.confidence == highest);
    }
    CHECK(tets == expected);
    found += spikes.size();
    Flags rest = kept;
    std::vector<TetName> names;
    for (const Spike& spike : spikes) {
      names.push_back(sorted_vertices(cell.mesh, spike.tets.back()));
      for (const std::uint32_t t : spike.tets) rest[t] = 0;
    }
    CHECK(drop_bodies(cell, ground, names, kept) == spikes.size());
    CHECK(kept == rest);
    CHECK(drop_bodies(cell, ground, names, kept) == 0);
  }
  CHECK(found > 100);
  CHECK(sure > 10);
}
