#include "../../moebius/facet_cut.h"

#include <doctest/doctest.h>

using namespace crossloft;
using enum Passage;

namespace {

std::vector<FacetArc> cut(std::vector<Passage> sides) {
  std::vector<FacetArc> arcs;
  cut_facet(sides, arcs);
  return arcs;
}

}  // namespace

TEST_CASE("a border that never crosses has no arc") {
  CHECK(cut({}).empty());
  CHECK(cut({outside, outside, outside}).empty());
  CHECK(cut({inside, inside, inside}).empty());
}

TEST_CASE("an arc runs from an exit to the next entry") {
  const auto arcs = cut({leaves, outside, enters, inside});
  REQUIRE(arcs.size() == 1);
  CHECK(arcs[0].from == FacetCrossing{0, 0});
  CHECK(arcs[0].to == FacetCrossing{2, 0});
}

TEST_CASE("the cycle closes over its begin") {
  const auto arcs = cut({enters, leaves, enters, inside, leaves, outside});
  REQUIRE(arcs.size() == 2);
  CHECK(arcs[0].from == FacetCrossing{1, 0});
  CHECK(arcs[0].to == FacetCrossing{2, 0});
  CHECK(arcs[1].from == FacetCrossing{4, 0});
  CHECK(arcs[1].to == FacetCrossing{0, 0});
}

TEST_CASE("one side that dips bounds one arc") {
  const auto arcs = cut({outside, dips, outside});
  REQUIRE(arcs.size() == 1);
  CHECK(arcs[0].from == FacetCrossing{1, 1});
  CHECK(arcs[0].to == FacetCrossing{1, 0});
}

TEST_CASE("every side that dips bounds one arc more") {
  const auto arcs = cut({dips, dips, dips});
  REQUIRE(arcs.size() == 3);
  for (const FacetArc& arc : arcs) {
    CHECK(arc.from.root == 1);
    CHECK(arc.to.root == 0);
    CHECK(arc.to.side == (arc.from.side + 1) % 3);
  }
}
