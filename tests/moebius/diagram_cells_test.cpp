#include "../../moebius/cells.h"

#include <algorithm>

#include "../../moebius/cell_geometry.h"
#include "diagram_checks.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

/// Turns of a walk around a point by adding up angles: short chords along the arcs, and along a large circle
/// at infinity.
class AngleSum {
 public:
  explicit AngleSum(Vec2 point) : point_(point) {}

  void go_to(Vec2 x) {
    const double a = std::atan2(x.y - point_.y, x.x - point_.x);
    if (started_) sum_ += std::remainder(a - last_, 2 * std::numbers::pi);
    started_ = true;
    last_ = a;
    at_ = x;
  }
  void go_around(Vec2 to) {
    const double a = std::atan2(at_.y, at_.x);
    double turn = std::atan2(to.y, to.x) - a;
    while (turn < -1e-3) turn += 2 * std::numbers::pi;
    for (int k = 1; k < 64; ++k)
      go_to(length(at_) * Vec2{std::cos(a + turn * k / 64), std::sin(a + turn * k / 64)});
    go_to(to);
  }
  double turns() const { return sum_ / (2 * std::numbers::pi); }
  Vec2 at() const { return at_; }
  bool started() const { return started_; }

 private:
  Vec2 point_, at_;
  bool started_ = false;
  double last_ = 0, sum_ = 0;
};

double turns_around(const MoebiusDiagram& diagram, std::span<const CellStep> loop, Vec2 point) {
  AngleSum sum(point);
  const auto walk = [&](CellStep step, bool joined) {
    const ArcPath path(diagram, diagram.arcs[step.arc], 1e4);
    for (int k = 0; k <= 400; ++k) {
      const double t = k / 400.0;
      const Vec2 x = path.point(step.backwards ? 1 - t : t);
      if (k == 0 && joined)
        sum.go_around(x);
      else
        sum.go_to(x);
    }
  };
  bool from_infinity = false;
  for (const CellStep step : loop) {
    walk(step, from_infinity);
    from_infinity = diagram.arcs[step.arc].curve.is_line && end_vertex(diagram, step) == kNone;
  }
  const CellStep first = loop.front();
  const ArcPath path(diagram, diagram.arcs[first.arc], 1e4);
  const Vec2 begin = path.point(first.backwards ? 1 : 0);
  if (from_infinity)
    sum.go_around(begin);
  else
    sum.go_to(begin);
  return sum.turns();
}

/// Loops are closed walks of one cell, and every arc is walked once each way.
void check_walks(const MoebiusDiagram& diagram, const MoebiusCells& cells) {
  REQUIRE(cells.first_component.size() == diagram.sites.size() + 1);
  REQUIRE(cells.steps.size() == 2 * diagram.arcs.size());
  std::vector<int> walked(2 * diagram.arcs.size());
  for (const CellComponent& component : cells.components)
    for (const CellLoop& loop : cells.loops_of(component)) {
      const auto steps = cells.steps_of(loop);
      for (std::size_t k = 0; k < steps.size(); ++k) {
        ++walked[2 * steps[k].arc + steps[k].backwards];
        CHECK(diagram.arcs[steps[k].arc].sites[steps[k].backwards] == component.site);
        CHECK(end_vertex(diagram, steps[k]) == begin_vertex(diagram, steps[(k + 1) % steps.size()]));
      }
      CHECK(loop.is_hole == !(component.has_outer && &loop == cells.loops_of(component).data()));
    }
  CHECK(std::all_of(walked.begin(), walked.end(), [](int w) { return w == 1; }));
}

/// Of all components exactly one winds around a point, and it is of the nearest site. Number of failures.
int wrong_places(const MoebiusDiagram& diagram, const MoebiusCells& cells, Vec2 point) {
  int around = 0, wrong = 0;
  for (const CellComponent& component : cells.components) {
    double turns = component.has_outer ? 0 : 1;
    for (const CellLoop& loop : cells.loops_of(component)) {
      const double t = turns_around(diagram, cells.steps_of(loop), point);
      CHECK(std::lround(t) == winding_number(diagram, cells.steps_of(loop), point));
      turns += t;
    }
    CHECK(std::abs(turns - std::round(turns)) <= 1e-3);
    const auto times = std::lround(turns);
    wrong += times != 0 && times != 1;
    around += times == 1;
    if (times == 1) CHECK(component.site == nearest(diagram.sites, point));
  }
  return wrong + (around != 1);
}

bool is_clear(const MoebiusDiagram& diagram, Vec2 point) {
  return std::all_of(diagram.arcs.begin(), diagram.arcs.end(), [&](const MoebiusArc& arc) {
    return ArcPath(diagram, arc, 1e4).distance(point) > 0.02;
  });
}

MoebiusCells checked_cells(const MoebiusDiagram& diagram, double extent, int points, unsigned seed) {
  INFO(describe(diagram.sites));
  const MoebiusCells cells = moebius_cells(diagram);
  check_walks(diagram, cells);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> at(-extent, extent);
  for (int k = 0; k < points; ++k)
    if (const Vec2 point{at(random), at(random)}; is_clear(diagram, point))
      CHECK(wrong_places(diagram, cells, point) == 0);
  return cells;
}

std::uint32_t holes(const MoebiusCells& cells, std::uint32_t site) {
  std::uint32_t count = 0;
  for (const CellComponent& c : cells.components_of(site)) count += c.hole_count();
  return count;
}

}  // namespace

TEST_CASE("no site, one site") {
  CHECK(moebius_cells({}).components.empty());
  const MoebiusDiagram diagram = diagram_of({{{1, 2}, 1, 0}});
  const MoebiusCells cells = checked_cells(diagram, 3, 1, 1);
  REQUIRE(cells.components.size() == 1);
  CHECK(!cells.components[0].has_outer);
  CHECK(cells.components[0].loop_count == 0);
}

TEST_CASE("parallel strips close over infinity") {
  const MoebiusDiagram diagram = diagram_of({{{0, 0}}, {{1, 1}}, {{2, 2}}, {{3, 3}}});
  const MoebiusCells cells = checked_cells(diagram, 5, 50, 2);
  CHECK(diagram.arcs.size() == 3);
  REQUIRE(cells.components.size() == 4);
  for (const CellComponent& c : cells.components) CHECK((c.loop_count == 1 && c.has_outer));
}

TEST_CASE("annuli") {
  // lambda 4, 2, 1 around one place.
  const MoebiusDiagram diagram = diagram_of({{{1, 1}, 1, -3}, {{1, 1}, 4, 0}, {{1, 1}, 2, -1}});
  const MoebiusCells cells = checked_cells(diagram, 5, 50, 3);
  CHECK(diagram.arcs.size() == 2);
  CHECK(diagram.vertices.empty());
  for (std::uint32_t site = 0; site < 3; ++site) REQUIRE(cells.components_of(site).size() == 1);
  CHECK(!cells.components_of(0)[0].has_outer);
  CHECK(holes(cells, 0) == 1);
  CHECK(holes(cells, 1) == 0);
  CHECK(holes(cells, 2) == 1);
}

TEST_CASE("a disconnected cell: a strip pinched through") {
  // Parallel lines at x = -0.5 and 0.5; a strong site in the middle covers the strip's width.
  const MoebiusDiagram diagram = diagram_of({{{-1, 0}}, {{0, 0}}, {{1, 0}}, {{0, 0}, 3, 3}});
  const MoebiusCells cells = checked_cells(diagram, 4, 80, 4);
  CHECK(cells.components_of(1).size() == 2);
  CHECK(cells.components_of(3).size() == 1);
  CHECK(cells.components_of(0).size() == 1);
}

TEST_CASE("a hole in each of two pieces") {
  // The strip of site 1 pinched in the middle, and two islands far up and down in it.
  const MoebiusDiagram diagram =
      diagram_of({{{-1, 0}}, {{0, 0}}, {{1, 0}}, {{0, 0}, 3, 3}, {{0, 10}, 200, -92}, {{0, -10}, 200, -92}});
  const MoebiusCells cells = checked_cells(diagram, 12, 200, 5);
  REQUIRE(cells.components_of(1).size() == 2);
  for (const CellComponent& c : cells.components_of(1)) CHECK(c.hole_count() == 1);
}

TEST_CASE("circles so large that they are lines within rounding") {
  // As above, the lambdas no longer equal.
  const double e = 0x1p-50;
  const MoebiusDiagram diagram = diagram_of({{{-1, 0}},
                                             {{0, 0}, 1 + e, 0},
                                             {{1, 0}, 1 + 2 * e, 0},
                                             {{0, 0}, 3, 3},
                                             {{0, 10}, 200, -92},
                                             {{0, -10}, 200, -92}});
  CHECK(verify(diagram) == "");
  const MoebiusCells cells = moebius_cells(diagram);
  check_walks(diagram, cells);
  for (const std::uint32_t whole : {3u, 4u, 5u}) CHECK(cells.components_of(whole).size() == 1);
  std::uint32_t around = 0;
  for (const CellComponent& c : cells.components_of(1))
    for (const CellLoop& loop : cells.loops_of(c).first(c.has_outer ? 1 : 0))
      for (const double y : {-5.0, 5.0})
        around += winding_number(diagram, cells.steps_of(loop), {0.2, y}) == 1;
  CHECK(around == 2);
}

TEST_CASE("random sites") {
  const unsigned seed = 99;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::uint32_t split = 0, pierced = 0;
  for (int round = 0; round < 150; ++round) {
    Sites sites;
    for (int k = 0; k < 2 + round % 25; ++k)
      sites.push_back(
          {{unit(random), unit(random)}, round % 3 ? unit(random) + round % 4 : 1.0, 0.3 * unit(random)});
    const MoebiusDiagram diagram = diagram_of(sites);
    const MoebiusCells cells = checked_cells(diagram, 2, 12, seed + round);
    for (std::uint32_t i = 0; i < sites.size(); ++i) {
      split += cells.components_of(i).size() > 1;
      pierced += holes(cells, i) > 0;
    }
  }
  CHECK(split > 10);
  CHECK(pierced > 10);
}

TEST_CASE("random small integers") {
  const unsigned seed = 1234;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  const auto integer = [&](int reach) { return std::uniform_int_distribution<int>(-reach, reach)(random); };
  for (int round = 0; round < 600; ++round) {
    Sites sites;
    for (int k = 0; k < 1 + round % 7; ++k)
      sites.push_back({{double(integer(2)), double(integer(2))}, double(integer(2)), double(integer(3))});
    checked_cells(diagram_of(sites), 4, 6, seed + round);
  }
}
