// Step 3 by hand: when a tetrahedron over more than two planes may join.
#include "prune/growth.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "cells.h"

namespace {

using namespace crossloft;
using namespace crossloft::test;

/// The candidate 0 = (a, b, c, d) = (0, 1, 2, 3); 1 and 2 over its facets abc and abd; 3, 4, 5 turn the rest
/// of the way around its far edge cd, 4 touching nothing of 0 but that edge.
struct Scene {
  std::vector<Tet> tets{{0, 1, 2, 3}, {1, 0, 2, 4}, {0, 1, 3, 5}, {1, 2, 3, 6}, {2, 3, 6, 7}, {2, 3, 7, 0}};
  std::vector<std::uint64_t> masks{1, 2, 4, 8, 0, 0, 0, 0};

  /// True iff the candidate joins the given tetrahedra.
  bool joins(const std::vector<std::uint32_t>& solid, TwoFacetRule rule) const {
    const CellComplex cell = make_cell(tets, masks, {});
    std::vector<std::uint8_t> kept(tets.size(), 0), candidates(tets.size(), 0);
    for (const std::uint32_t t : solid) kept[t] = 1;
    candidates[0] = 1;
    grow_over_facets(cell, candidates, rule, kept);
    return kept[0] != 0;
  }
};

constexpr TwoFacetRule kBoth[] = {TwoFacetRule::corrected, TwoFacetRule::literal};

}  // namespace

TEST_CASE("no facet and one facet in the solid are not enough") {
  for (const TwoFacetRule rule : kBoth) {
    CHECK_FALSE(Scene().joins({}, rule));
    CHECK_FALSE(Scene().joins({1}, rule));
    CHECK_FALSE(Scene().joins({4}, rule));
  }
}

TEST_CASE("two facets are, if their far edge is new") {
  for (const TwoFacetRule rule : kBoth) CHECK(Scene().joins({1, 2}, rule));
}

TEST_CASE("with its far edge in the solid the tetrahedron would close the solid on itself") {
  CHECK(Scene().joins({1, 2, 4}, TwoFacetRule::literal));
  CHECK_FALSE(Scene().joins({1, 2, 4}, TwoFacetRule::corrected));
}

TEST_CASE("with its far edge grounded the tetrahedron would hang on nothing there") {
  Scene scene;
  scene.masks[3] = scene.masks[2];
  CHECK(scene.joins({1, 2}, TwoFacetRule::literal));
  CHECK_FALSE(scene.joins({1, 2}, TwoFacetRule::corrected));
}

TEST_CASE("three and four facets always join") {
  for (const TwoFacetRule rule : kBoth) {
    CHECK(Scene().joins({1, 2, 3}, rule));
    CHECK(Scene().joins({1, 2, 3, 4}, rule));
    CHECK(Scene().joins({1, 2, 3, 5}, rule));
  }
}

TEST_CASE("one may open the way for the next, and only candidates are taken") {
  const Scene scene;
  const CellComplex cell = make_cell(scene.tets, scene.masks, {});
  std::vector<std::uint8_t> kept{0, 1, 1, 0, 1, 0};
  const std::vector<std::uint8_t> candidates{1, 0, 0, 1, 0, 0};
  grow_over_facets(cell, candidates, TwoFacetRule::literal, kept);
  // 0 joins by 1 and 2, then 3 by 0 and 4; 5, also between 0 and 4, is no candidate.
  CHECK(kept == std::vector<std::uint8_t>{1, 1, 1, 1, 1, 0});
}

TEST_CASE("where two want one edge, the first by sorted vertices gets it, whatever its number") {
  // (0, 1, 2, 3) and (0, 3, 4, 5), each with two facets in the solid, both over the far edge 0-3; the last
  // one between them is no candidate.
  std::vector<Tet> tets{{0, 1, 2, 3}, {1, 2, 3, 6}, {0, 1, 2, 7}, {0, 3, 4, 5},
                        {3, 4, 5, 8}, {0, 4, 5, 9}, {0, 2, 3, 4}};
  const std::vector<std::uint64_t> masks(10, 0);
  const std::vector<std::uint8_t> candidates{1, 0, 0, 1, 0, 0, 0};
  std::vector<std::uint8_t> kept{0, 1, 1, 0, 1, 1, 0};
  grow_over_facets(make_cell(tets, masks, {}), candidates, TwoFacetRule::corrected, kept);
  CHECK(kept == std::vector<std::uint8_t>{1, 1, 1, 0, 1, 1, 0});
  std::swap_ranges(tets.begin(), tets.begin() + 3, tets.begin() + 3);
  kept = {0, 1, 1, 0, 1, 1, 0};
  grow_over_facets(make_cell(tets, masks, {}), candidates, TwoFacetRule::corrected, kept);
  CHECK(kept == std::vector<std::uint8_t>{0, 1, 1, 1, 1, 1, 0});
}
