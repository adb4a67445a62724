#include "../../io/curve_piece.h"

#include <cmath>
#include <random>

#include <doctest/doctest.h>

using namespace crossloft;

namespace {

const ViewBox kBox{{0, 0}, {4, 2}};

double length_of(Vec2 v) { return std::sqrt(dot(v, v)); }

/// Each piece begins where the one before it ends, no longer than a third of a turn, and lies on the circle.
void check_chain(const std::vector<CurvePiece>& pieces, Vec2 from, Vec2 to) {
  REQUIRE(!pieces.empty());
  CHECK(pieces.front().from == from);
  CHECK(pieces.back().to == to);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const CurvePiece& p = pieces[i];
    if (i > 0) CHECK(p.from == pieces[i - 1].to);
    CHECK(length_of(p.from - p.centre) == doctest::Approx(p.radius));
    CHECK(length_of(middle(p) - p.centre) == doctest::Approx(p.radius));
    CHECK(dot(p.from - p.centre, p.to - p.centre) >= -0.51 * p.radius * p.radius);
  }
}

}  // namespace

TEST_CASE("arcs of any length become short pieces on the same side") {
  const Vec2 centre{3, -1};
  for (int degrees = 1; degrees < 360; ++degrees) {
    for (const bool ccw : {true, false}) {
      const double angle = (ccw ? degrees : -degrees) * std::acos(-1.0) / 180;
      const Vec2 from = centre + Vec2{2, 0}, to = centre + Vec2{2 * std::cos(angle), 2 * std::sin(angle)};
      std::vector<CurvePiece> pieces;
      append_arc({from, to, false, centre, 2, ccw}, degrees > 180, pieces);
      check_chain(pieces, from, to);
      double turn = 0;
      for (const CurvePiece& p : pieces)
        turn += std::atan2(cross(p.from - centre, p.to - centre), dot(p.from - centre, p.to - centre));
      CHECK(turn == doctest::Approx(angle));
    }
  }
}

TEST_CASE("an arc whose ends coincide is nothing or a whole turn, in whatever order rounding has left them") {
  for (const double gap : {0.0, 1e-15, -1e-15}) {
    const Vec2 from{3, 2}, to{3, 2 + gap};
    for (const bool ccw : {true, false}) {
      std::vector<CurvePiece> tiny, whole;
      append_arc({from, to, false, {1, 2}, 2, ccw}, false, tiny);
      CHECK(bounds_of(tiny).size().x < 1e-9);
      append_arc({from, to, false, {1, 2}, 2, ccw}, true, whole);
      check_chain(whole, from, to);
      const ViewBox box = bounds_of(whole);
      CHECK(box.low.x == doctest::Approx(-1));
      CHECK(box.size().y == doctest::Approx(4));
      for (const CurvePiece& p : whole) CHECK((cross(p.from - p.centre, p.to - p.centre) > 0) == ccw);
    }
  }
}

TEST_CASE("a circle turns once in its direction") {
  for (const bool ccw : {true, false}) {
    std::vector<CurvePiece> pieces;
    append_circle({1, 2}, 3, ccw, pieces);
    check_chain(pieces, {4, 2}, {4, 2});
    for (const CurvePiece& p : pieces) CHECK((cross(p.from - p.centre, p.to - p.centre) > 0) == ccw);
  }
}

TEST_CASE("bounds hold the parts of circles that bulge beyond their ends") {
  std::vector<CurvePiece> pieces{{{0, 0}, {1, 0}, true, {}, 0, false}};
  append_arc({{1, 0}, {3, 0}, false, {2, 0}, 1, false}, false, pieces);
  const ViewBox box = bounds_of(pieces);
  CHECK(box.low == Vec2{0, 0});
  CHECK(box.high.x == doctest::Approx(3));
  CHECK(box.high.y == doctest::Approx(1));
}

TEST_CASE("clipping a segment") {
  const auto parts = [](Vec2 from, Vec2 to) {
    return clip(std::vector<CurvePiece>{{from, to, true, {}, 0, false}}, kBox);
  };
  CHECK(parts({-1, -1}, {5, -1}).empty());
  CHECK(parts({-3, 1}, {1, 5}).empty());
  const auto through = parts({-1, 1}, {5, 1});
  REQUIRE(through.size() == 1);
  CHECK((through[0].enters && through[0].leaves));
  CHECK(through[0].pieces.front().from == Vec2{0, 1});
  CHECK(through[0].pieces.back().to == Vec2{4, 1});
  const auto inside = parts({1, 1}, {2, 1});
  REQUIRE(inside.size() == 1);
  CHECK((!inside[0].enters && !inside[0].leaves));
  const auto out = parts({1, 1}, {1, 3});
  REQUIRE(out.size() == 1);
  CHECK((!out[0].enters && out[0].leaves));
  CHECK(out[0].pieces.back().to == Vec2{1, 2});
}

TEST_CASE("a segment of no length is there if its point is") {
  CHECK(clip(std::vector<CurvePiece>{{{1, 1}, {1, 1}, true, {}, 0, false}}, kBox).size() == 1);
  CHECK(clip(std::vector<CurvePiece>{{{1, 3}, {1, 3}, true, {}, 0, false}}, kBox).empty());
}

TEST_CASE("a circle through all four sides has a part in each corner") {
  std::vector<CurvePiece> circle;
  append_circle({2, 1}, 2.1, true, circle);
  const auto runs = clip(circle, kBox);
  // The walk begins outside, right of the box.
  REQUIRE(runs.size() == 4);
  for (const CurveRun& run : runs) CHECK((run.enters && run.leaves));
  std::vector<CurvePiece> around;
  append_circle({2, 1}, 3, true, around);
  CHECK(clip(around, kBox).empty());
}

TEST_CASE("clipped arcs: what is kept lies inside, what is dropped outside") {
  std::mt19937 random(7);
  MESSAGE("seed 7");
  std::uniform_real_distribution<double> place(-2, 6), size(0.1, 6), angle(0, 6.28);
  for (int i = 0; i < 2000; ++i) {
    const Vec2 centre{place(random), place(random)};
    const double radius = size(random), a = angle(random), b = angle(random);
    std::vector<CurvePiece> arc;
    const bool ccw = i % 2 == 0;
    const double full = 2 * std::acos(-1.0), turn = std::fmod((ccw ? b - a : a - b) + full, full);
    append_arc({centre + radius * Vec2{std::cos(a), std::sin(a)},
                centre + radius * Vec2{std::cos(b), std::sin(b)}, false, centre, radius, ccw},
               turn > full / 2, arc);
    double kept = 0;
    for (const CurveRun& run : clip(arc, kBox)) {
      for (std::size_t k = 0; k < run.pieces.size(); ++k) {
        const CurvePiece& p = run.pieces[k];
        if (k > 0) CHECK(p.from == run.pieces[k - 1].to);
        kept +=
            std::abs(std::atan2(cross(p.from - centre, p.to - centre), dot(p.from - centre, p.to - centre)));
      }
      if (run.enters) CHECK(std::abs(border_position(run.pieces.front().from, kBox)) <= 4);
    }
    constexpr int kSteps = 2000;
    double inside = 0;
    for (int k = 0; k < kSteps; ++k) {
      const double t = a + (ccw ? 1 : -1) * turn * (k + 0.5) / kSteps;
      const Vec2 p = centre + radius * Vec2{std::cos(t), std::sin(t)};
      if (p.x > 0 && p.x < 4 && p.y > 0 && p.y < 2) inside += turn / kSteps;
    }
    CHECK(kept == doctest::Approx(inside).epsilon(0.01).scale(1));
  }
}

TEST_CASE("positions on the border go counter-clockwise from the low corner") {
  CHECK(border_position({0, 0}, kBox) == 0);
  CHECK(border_position({2, 0}, kBox) == 0.5);
  CHECK(border_position({4, 0.5}, kBox) == 1.25);
  CHECK(border_position({1, 2}, kBox) == 2.75);
  CHECK(border_position({0, 0.5}, kBox) == 3.75);
  CHECK(border_corner(0, kBox) == Vec2{0, 0});
  CHECK(border_corner(1, kBox) == Vec2{4, 0});
  CHECK(border_corner(2, kBox) == Vec2{4, 2});
  CHECK(border_corner(3, kBox) == Vec2{0, 2});
}

TEST_CASE("far along a line is outside the box, whichever side the line begins on") {
  for (const Vec2 from : {Vec2{-1000, 1}, Vec2{2, 1}, Vec2{1000, 1}}) {
    CHECK(far_along(from, {1, 0}, kBox).x > 4);
    CHECK(far_along(from, {-1, 0}, kBox).x < 0);
  }
}
