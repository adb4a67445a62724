// Sections that disagree on common lines: what a repair makes of them.
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "../../repair/repair.h"
#include "../arrangement/built_graph.h"
#include "jittered.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

void check_agrees(const Sections& sections) {
  const Built built = build(sections);
  REQUIRE_MESSAGE(built.graph.ok(), to_string(built.graph.error()));
  CHECK(built.graph->statistics.unmatched.size() == 0);
  CHECK(built.graph->statistics.disagreeing == 0);
}

Sections disturbed_solid(std::uint64_t seed, std::uint32_t planes, double fraction) {
  const Surface solid = seed % 3 == 0   ? genus2_solid(24)
                        : seed % 3 == 1 ? nested_shells(24)
                                        : demo_solid(24);
  auto sections = slice(solid, random_planes(bounds_of(solid.points), planes, seed));
  REQUIRE(sections.ok());
  return jittered(std::move(sections).value(), seed, fraction);
}

}  // namespace

TEST_CASE("disturbed sections agree after the repair, and a second one changes nothing") {
  const double fractions[] = {1e-4, 1e-3, 0.01, 0.03, 0.06};
  for (std::uint64_t seed = 1; seed <= 600; ++seed) {
    const double fraction = fractions[seed % 5];
    const auto planes = static_cast<std::uint32_t>(3 + seed % 9);
    CAPTURE(seed);
    CAPTURE(fraction);
    CAPTURE(planes);
    const Sections dirty = disturbed_solid(seed, planes, fraction);
    RepairOptions options;
    options.limit = 1;
    const auto repair = repair_sections(dirty, options);
    REQUIRE(repair.ok());
    CHECK(repair->left == 0);
    check_agrees(repair->sections);
    const auto again = repair_sections(repair->sections, options);
    REQUIRE(again.ok());
    CHECK(again->changes.size() == 0);
    for (const RepairChange& c : again->changes) MESSAGE(name_of(c.kind), " ", c.text, " ", c.distance);
  }
}
