// Sections that disagree on common lines: what a repair makes of them.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "../../repair/repair.h"
#include "../../repair/segment_distance.h"
#include "../arrangement/built_graph.h"
#include "../arrangement/polygon_sections.h"
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
  const Surface solid = seed % 3 == 0 ? genus2_solid(24) : seed % 3 == 1 ? nested_shells(24) : demo_solid(24);
  auto sections = slice(solid, random_planes(bounds_of(solid.points), planes, seed));
  REQUIRE(sections.ok());
  return jittered(std::move(sections).value(), seed, fraction);
}

/// The walls of all planes as pairs of points, in an order of their own.
std::multiset<std::pair<Vec3, Vec3>> walls_of(const Sections& sections) {
  std::multiset<std::pair<Vec3, Vec3>> walls;
  for (const PlaneSection& p : sections.planes)
    for (const ContourEdge& e : p.edges) walls.insert(std::minmax(p.vertices[e.a], p.vertices[e.b]));
  return walls;
}

/// The same sections with planes, vertices and edges in another order and some of them turned around.
Sections shuffled(const Sections& sections, std::uint64_t seed) {
  Random random(seed);
  const auto shuffle = [&](auto& items) {
    for (std::size_t k = items.size(); k > 1; --k) std::swap(items[k - 1], items[random.next() % k]);
  };
  Sections other = sections;
  for (PlaneSection& p : other.planes) {
    std::vector<std::uint32_t> order(p.vertices.size());
    for (std::uint32_t v = 0; v < order.size(); ++v) order[v] = v;
    shuffle(order);
    for (std::uint32_t v = 0; v < order.size(); ++v)
      p.vertices[order[v]] = sections.planes[static_cast<std::size_t>(&p - other.planes.data())].vertices[v];
    for (ContourEdge& e : p.edges) {
      e.a = order[e.a], e.b = order[e.b];
      if (random.next() % 2) std::swap(e.a, e.b);
    }
    shuffle(p.edges);
    if (random.next() % 2) p.normal = -p.normal, p.offset = -p.offset;
  }
  shuffle(other.planes);
  return other;
}

Repair repaired(const Sections& sections, double limit = 1) {
  RepairOptions options;
  options.limit = limit;
  auto repair = repair_sections(sections, options);
  REQUIRE(repair.ok());
  return std::move(repair).value();
}

/// Distance of a point from the nearest wall of a section.
double distance_from(const PlaneSection& section, Vec3 p) {
  double least = HUGE_VAL;
  for (const ContourEdge& e : section.edges)
    least = std::min(least, distance_to_segment(section.vertices[e.a], section.vertices[e.b], p));
  return least;
}

}  // namespace

TEST_CASE("disturbed sections agree after the repair, and a second one changes nothing") {
  const double fractions[] = {1e-4, 1e-3, 0.01, 0.03, 0.06};
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    const Sections dirty =
        disturbed_solid(seed, static_cast<std::uint32_t>(3 + seed % 9), fractions[seed % 5]);
    const Repair repair = repaired(dirty);
    CHECK(repair.left == 0);
    CHECK(repair.changes.size() > 0);
    check_agrees(repair.sections);
    const Repair again = repaired(repair.sections);
    CHECK(again.changes.size() == 0);
    CHECK(walls_of(again.sections) == walls_of(repair.sections));
  }
}

TEST_CASE("sections that agree are left as they are to the bit") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    const Sections clean = disturbed_solid(seed, 7, 0);
    const Repair repair = repaired(clean);
    CHECK(repair.changes.size() == 0);
    CHECK(repair.largest_displacement == 0);
    CHECK(walls_of(repair.sections) == walls_of(clean));
  }
}

TEST_CASE("contours move by no more than is told, and only next to lines") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    const Sections dirty = disturbed_solid(seed, 5, 0.02);
    const Repair repair = repaired(dirty);
    const auto before = walls_of(dirty), after = walls_of(repair.sections);
    std::size_t kept = 0;
    for (const auto& wall : before) kept += after.count(wall) != 0;
    CHECK(kept > before.size() / 4);
    for (std::size_t k = 0; k < repair.sections.planes.size(); ++k) {
      const PlaneSection &now = repair.sections.planes[k], &old = dirty.planes[repair.sources[k]];
      if (now.edges.empty()) continue;
      for (const Vec3& v : now.vertices)
        CHECK(distance_from(old, v) <= repair.largest_displacement * (1 + 1e-9));
    }
  }
}

TEST_CASE("nothing moves beyond the limit, and what is left is listed") {
  const Sections dirty = disturbed_solid(2, 7, 0.04);
  const Repair all = repaired(dirty);
  REQUIRE(all.left == 0);
  const double limit = 0.05 * all.largest_displacement / all.diagonal;
  const Repair some = repaired(dirty, limit);
  CHECK(some.left > 0);
  CHECK(some.largest_displacement <= limit * some.diagonal);
  for (const RepairChange& c : some.changes) {
    if (c.kind == RepairKind::agreed) CHECK(c.distance <= limit * some.diagonal);
    if (c.kind != RepairKind::left_as_it_is) continue;
    CHECK(c.plane < dirty.planes.size());
    CHECK(c.text.find("more than the limit") != std::string::npos);
  }
}

// The tip of the triangle becomes a spike where the crossing with the square cuts it short; its removal
// starts another pass, which told all that was left once more.
TEST_CASE("what several passes leave is told once") {
  Sections sections{"", {plane_at({0, 0, 1}, {0, 0, 0}), plane_at({1, 0, 0}, {0, 0, 0})}};
  add_contour(sections.planes[0], square(0, 0, 0, 1));
  add_contour(sections.planes[0], {{1.0005, 0, 0}, {0.5, 5e-5, 0}, {0.5, -5e-5, 0}}, 1);
  add_contour(sections.planes[1], {{0, -0.8, -1}, {0, 0.8, -1}, {0, 0.8, 1}, {0, -0.8, 1}});
  const Repair repair = repaired(sections, 1e-3);
  REQUIRE(std::any_of(repair.changes.begin(), repair.changes.end(),
                      [](const RepairChange& c) { return c.kind == RepairKind::spikes; }));
  std::set<std::pair<std::uint32_t, Vec3>> places;
  for (const RepairChange& c : repair.changes)
    if (c.kind == RepairKind::left_as_it_is) places.insert({c.plane, c.point});
  CHECK(repair.left > 0);
  CHECK(repair.left == places.size());
}

TEST_CASE("the order of planes, vertices and edges does not matter") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    CAPTURE(seed);
    const Sections dirty = disturbed_solid(seed, 6, 0.02);
    const Repair one = repaired(dirty), other = repaired(shuffled(dirty, seed));
    CHECK(walls_of(one.sections) == walls_of(other.sections));
    CHECK(one.largest_displacement == other.largest_displacement);
    CHECK(one.changes.size() == other.changes.size());
  }
}

// One spike upon the other: which went first depended on the order of the edges.
TEST_CASE("the order of edges does not matter for spikes") {
  Sections dirty{"", {plane_at({0, 0, 1}, {0, 0, 0})}};
  add_contour(
      dirty.planes[0],
      {{0, 2, 0}, {3, 0, 0}, {2, 3, 0}, {0, 0, 0}, {4, 4, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}, {2, 4, 0}});
  add_contour(dirty.planes[0], square(20, 0, 0, 1), 1);
  const Repair one = repaired(dirty);
  CHECK(one.changes.size() > 0);
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    CHECK(walls_of(repaired(shuffled(dirty, seed)).sections) == walls_of(one.sections));
}

TEST_CASE("a pencil of planes agrees on its axis") {
  const Surface solid = genus2_solid(24);
  auto sections = slice(solid, rotational_planes(bounds_of(solid.points), 5));
  REQUIRE(sections.ok());
  const Repair repair = repaired(jittered(std::move(sections).value(), 3, 0.02));
  CHECK(repair.left == 0);
  check_agrees(repair.sections);
}

// Crossings of an earlier round stayed on the line, next to those of a later one: the contour came over the
// line, ran along it and left it there. The reconstruction found one and two crossings without partner, the
// repair nothing.
TEST_CASE("contours that cross a line do not run along it afterwards") {
  for (const std::uint64_t k : {159, 191}) {
    CAPTURE(k);
    const Repair repair = repaired(disturbed_set(k));
    CHECK(repair.left == 0);
    check_agrees(repair.sections);
  }
}

TEST_CASE("where contours stay touching on a line it is told") {
  const Repair repair = repaired(disturbed_set(104));
  const Built built = build(repair.sections);
  REQUIRE(built.graph.ok());
  REQUIRE(built.graph->statistics.unmatched.size() == 1);
  REQUIRE(repair.left == 1);
  const LatticePoint& at = built.graph->statistics.unmatched[0].point;
  const RepairChange& left = *std::find_if(repair.changes.begin(), repair.changes.end(),
                                           [](auto& c) { return c.kind == RepairKind::left_as_it_is; });
  CHECK(norm(built.framed.grid.from_lattice(at) - left.point) < 1e-7);
}

// Where planes may disagree by more than the reconstruction will match, no step sees anything to do.
TEST_CASE(
    "a crossing that the reconstruction can't match is told, whatever tolerance hides it from the repair") {
  Sections sections{"", {plane_at({0, 0, 1}, {0, 0, 0}), plane_at({1, 0, 0}, {0, 0, 0})}};
  add_contour(sections.planes[0], square(0, 0, 0, 1));
  add_contour(sections.planes[1], {{0, -1, -1}, {0, 0.97, -1}, {0, 0.97, 1}, {0, -1, 1}});
  RepairOptions options;
  options.agree = 0.05;
  const auto untouched = repair_sections(sections, options);
  REQUIRE(untouched.ok());
  CHECK(untouched->changes.size() == 0);
  sections.planes[0].vertices.push_back(sections.planes[0].vertices[0]);  // two vertices in one place
  sections.planes[0].edges[0].a = 4;
  sections.planes[0].edges.push_back({0, 4, 1, 0, 0, 0});
  const auto repair = repair_sections(sections, options);
  REQUIRE(repair.ok());
  const Built built = build(repair->sections);
  REQUIRE(built.graph.ok());
  CHECK(built.graph->statistics.unmatched.size() == 2);
  CHECK(repair->left == 1);  // the second is of the same planes
  CHECK(repair->changes.back().kind == RepairKind::left_as_it_is);
  CHECK(repair->changes.back().text.find("crosses plane") != std::string::npos);
}

TEST_CASE("a section that does not reach the line is extended to it, or the other taken back") {
  // The square on z = 0 stops short of the plane x = 1, whose section crosses z = 0 by a little or by much.
  for (const double deep : {0.05, 0.6}) {
    CAPTURE(deep);
    Sections sections{"", {plane_at({0, 0, 1}, {0, 0, 0}), plane_at({1, 0, 0}, {1, 0, 0})}};
    add_contour(sections.planes[0], square(0, 0, 0, 0.8));
    add_contour(sections.planes[1], {{1, -0.4, -deep}, {1, 0.4, -deep}, {1, 0.4, 2}, {1, -0.4, 2}});
    const Repair repair = repaired(sections);
    CHECK(repair.left == 0);
    check_agrees(repair.sections);
    const bool extended = std::any_of(
        repair.changes.begin(), repair.changes.end(),
        [](const RepairChange& c) { return c.plane == 0 && c.text.find("extended") != std::string::npos; });
    CHECK(extended == (deep > 0.2));
  }
}
