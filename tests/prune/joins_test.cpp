// The bottlenecks between sections, against the parts at every threshold.
#include "prune/joins.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "brute_solid.h"
#include "cells.h"
#include "prune/cell_topology.h"
#include "prune/widest_ways.h"

namespace {

using namespace crossloft;
using namespace crossloft::test;

/// Parts of the ground that are in one body when only tetrahedra with this confidence or more are there: per
/// body the smallest vertices of its parts.
std::multiset<std::uint32_t> bodies_at(const BruteSolid& brute, const Flags& kept,
                                       const std::vector<std::int32_t>& confidence, std::int32_t threshold) {
  Flags sure = kept;
  for (std::size_t t = 0; t < sure.size(); ++t) sure[t] = sure[t] != 0 && confidence[t] >= threshold;
  const Groups bodies = brute.bodies(sure);
  std::map<std::size_t, std::uint32_t> name;
  for (const std::size_t p : brute.ground()) {
    const auto [entry, is_new] = name.emplace(bodies.of(p), brute.pieces()[p][0]);
    if (!is_new) entry->second = std::min(entry->second, brute.pieces()[p][0]);
  }
  std::multiset<std::uint32_t> names;
  for (const auto& [body, vertex] : name) names.insert(vertex);
  return names;
}

}  // namespace

TEST_CASE("random cells: at every threshold the bodies are those that the joins so far leave") {
  std::size_t seen = 0;
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const CellComplex cell = random_cell(seed);
    const Ground ground(cell);
    const BruteSolid brute(cell);
    Flags kept = r1_of(cell);
    for (std::uint8_t& k : kept) k = k != 0 && random() % 8 != 0;
    std::vector<std::int32_t> confidence;
    for (std::uint32_t t = 0; t < kept.size(); ++t)
      confidence.push_back(static_cast<std::int32_t>(random() % 20) - 10);
    const std::vector<Join> joins = find_joins(cell, ground, kept, confidence);
    std::multiset<std::uint32_t> bodies = bodies_at(brute, kept, confidence, 100);
    auto next = joins.begin();
    for (std::int32_t threshold = 10; threshold >= -10; --threshold) {
      CAPTURE(threshold);
      for (; next != joins.end() && next->confidence == threshold; ++next) {
        CHECK(next->done);
        CHECK(next->a <= next->b);
        REQUIRE(bodies.count(next->a) != 0);
        REQUIRE(bodies.count(next->b) != 0);
        bodies.erase(bodies.find(next->b));
        ++seen;
      }
      CHECK(bodies == bodies_at(brute, kept, confidence, threshold));
    }
    CHECK(next == joins.end());
    CHECK(bodies.size() == brute.count(kept).bodies - [&] {
      // Bodies without ground have no name.
      const Groups all = brute.bodies(kept);
      std::set<std::size_t> with, any;
      for (const std::size_t p : brute.ground()) with.insert(all.of(p));
      for (std::size_t p = 0; p < brute.pieces().size(); ++p)
        if (brute.is_solid(kept, p)) any.insert(all.of(p));
      return any.size() - with.size();
    }());
  }
  CHECK(seen > 100);
}

TEST_CASE("random cells: joins do not depend on the numbers of the tetrahedra nor on their slots") {
  for (std::uint32_t seed = 300; seed < 600; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const CellComplex cell = random_cell(seed);
    std::vector<std::uint32_t> from;
    const CellComplex other = shuffled(cell, random, from);
    const Flags kept = r1_of(cell);
    std::vector<std::int32_t> confidence, moved_confidence;
    for (std::uint32_t t = 0; t < kept.size(); ++t)
      confidence.push_back(static_cast<std::int32_t>(random() % 5));
    for (const std::uint32_t t : from) moved_confidence.push_back(confidence[t]);
    CHECK(find_joins(cell, Ground(cell), kept, confidence) ==
          find_joins(other, Ground(other), r1_of(other), moved_confidence));
  }
}

TEST_CASE("random cells: the widest ways are the joins, found with fewer confidences") {
  std::size_t joined = 0, asked = 0, all = 0;
  for (std::uint32_t seed = 600; seed < 1600; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const CellComplex cell = random_cell(seed);
    const Ground ground(cell);
    Flags kept = r1_of(cell);
    for (std::uint8_t& k : kept) k = k != 0 && random() % 16 != 0;
    // Few different ones, so that ties matter, or many.
    const std::uint32_t values = seed % 2 == 0 ? 4 : 1000;
    std::vector<std::int32_t> confidence;
    for (std::uint32_t t = 0; t < kept.size(); ++t)
      confidence.push_back(static_cast<std::int32_t>(random() % values));
    std::vector<std::uint32_t> times(kept.size(), 0);
    const std::vector<Join> joins =
        find_widest_ways(cell, ground, kept, find_bodies(cell, ground, kept).of_ground, [&](std::uint32_t t) {
          ++times[t];
          return confidence[t];
        });
    CHECK(joins == find_joins(cell, ground, kept, confidence));
    for (std::uint32_t t = 0; t < kept.size(); ++t) {
      CHECK(times[t] <= kept[t]);
      asked += times[t];
      all += kept[t];
    }
    joined += joins.size();
  }
  CHECK(joined > 500);
  CHECK(3 * asked < 2 * all);
}

TEST_CASE("parts of the ground are named by their smallest vertex, where they begin") {
  const CellComplex cell =
      make_cell({{4, 1, 2, 3}, {1, 2, 3, 0}, {2, 3, 0, 5}}, {2, 1, 1, 2, 1, 2}, {{1, 2, 4}, {0, 3, 5}});
  const Ground ground(cell);
  REQUIRE(ground.size() == 2);
  const std::vector<std::uint32_t> names = part_names(cell, ground);
  CHECK(names[ground.at(0, 3)] == 1);
  CHECK(names[ground.at(2, 0)] == 0);
}

TEST_CASE("tetrahedra go by their confidence, equals by their sorted vertices") {
  const CellComplex cell =
      make_cell({{2, 3, 4, 5}, {1, 2, 3, 4}, {3, 2, 1, 0}}, std::vector<std::uint64_t>(6, 0), {});
  const std::vector<std::int32_t> same{1, 1, 1}, rising{1, 2, 1};
  CHECK(by_confidence(cell, {1, 1, 1}, same) == std::vector<std::uint32_t>{2, 1, 0});
  CHECK(by_confidence(cell, {1, 1, 1}, rising) == std::vector<std::uint32_t>{1, 2, 0});
  CHECK(by_confidence(cell, {1, 0, 1}, rising) == std::vector<std::uint32_t>{2, 0});
}
