#include "../../io/arc_trace.h"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

using namespace crossloft;

namespace {

const ViewBox kBox{{0, 0}, {4, 2}};

MoebiusCurve line(Vec2 through, Vec2 direction) { return {true, through, 0, direction}; }

}  // namespace

TEST_CASE("lines run from end to end, or far out of the box") {
  const auto whole = trace({line({1, 1}, {1, 0}), false, false, {}, {}}, kBox);
  REQUIRE(whole.size() == 1);
  CHECK(whole[0].from.x < 0);
  CHECK(whole[0].to.x > 4);
  CHECK(whole[0].to.y == 1);
  const auto ray = trace({line({1, 1}, {1, 0}), false, false, {}, Vec2{2, 1}}, kBox);
  CHECK(ray[0].from.x < 0);
  CHECK(ray[0].to == Vec2{2, 1});
  const auto from_afar = trace({line({1, 1}, {1, 0}), false, false, Vec2{-1e9, 1}, {}}, kBox);
  CHECK(from_afar[0].to.x > 4);
}

TEST_CASE("circles of any size pass the box where they should") {
  for (double radius = 1; radius < 1e15; radius *= 10) {
    // A circle through (2, 1), tangent to y = 1 there, walked from left to right below its centre.
    const MoebiusCurve circle{false, {2, 1 + radius}, radius, {}};
    const double far = 0.9 * radius, rise = radius - std::sqrt(radius * radius - far * far);
    const auto pieces = trace({circle, true, false, Vec2{2 - far, 1 + rise}, Vec2{2 + far, 1 + rise}}, kBox);
    const auto runs = clip(pieces, kBox);
    REQUIRE(!runs.empty());
    CHECK(runs.size() == 1);
    const ViewBox seen = bounds_of(runs[0].pieces);
    CHECK(seen.low.y == doctest::Approx(1).epsilon(1e-5));
    if (radius > 5) CHECK(seen.low.x == 0);
    if (radius > 5) CHECK(seen.high.x == 4);
    for (std::size_t i = 1; i < pieces.size(); ++i) CHECK(pieces[i].from == pieces[i - 1].to);
  }
}

TEST_CASE("arcs whose numbers are lost have no pieces, ends off the circle do no harm") {
  const double infinity = std::numeric_limits<double>::infinity(),
               nan = std::numeric_limits<double>::quiet_NaN();
  const Vec2 end{1, 1};
  for (const double lost : {infinity, -infinity, nan, 1e200}) {
    CHECK(trace({{false, {0, 0}, std::abs(lost), {}}, true, false, end, end}, kBox).empty());
    CHECK(trace({{false, {lost, 0}, 1, {}}, true, false, end, end}, kBox).empty());
    CHECK(trace({{false, {0, 0}, 1, {}}, true, false, Vec2{0, lost}, end}, kBox).empty());
    CHECK(trace({line({lost, 0}, {1, 0}), false, false, end, {}}, kBox).empty());
    CHECK(trace({line({0, 0}, {1, lost}), false, false, end, {}}, kBox).empty());
  }
  for (const double radius : {1e-3, 1e7}) {
    const MoebiusCurve circle{false, {0, 0}, radius, {}};
    for (const bool over_half : {false, true})
      CHECK(!trace({circle, true, over_half, Vec2{-1e12, 1}, Vec2{1e12, 1}}, kBox).empty());
  }
}

TEST_CASE("the shape of a diagram's arc: direction by the lambdas, ends by its vertices") {
  MoebiusDiagram diagram{{{{0, 0}, 4, 0}, {{3, 0}, 1, 0}}, {{1, 0}, {-3, 0}}, {}};
  diagram.arcs.push_back({{0, 1}, 0, 1, {false, {-1, 0}, 2, {}}, false});
  diagram.arcs.push_back({{1, 0}, 0, kNone, {false, {-1, 0}, 2, {}}, true});
  const ArcShape first = shape_of(diagram, diagram.arcs[0]), second = shape_of(diagram, diagram.arcs[1]);
  CHECK((first.ccw && !first.over_half));
  CHECK((first.from == Vec2{1, 0} && first.to == Vec2{-3, 0}));
  CHECK((!second.ccw && second.over_half && !second.to));
}

TEST_CASE("the shape of a face's arc: no ends where it is infinite or whole") {
  FaceArc arc;
  arc.from = {1, 2};
  arc.to = {3, 4};
  arc.clockwise = true;
  CHECK(shape_of(arc).from == Vec2{1, 2});
  CHECK(!shape_of(arc).ccw);
  arc.to_infinite = true;
  CHECK(!shape_of(arc).to);
  CHECK(shape_of(arc).from);
  arc.whole = true;
  CHECK(!shape_of(arc).from);
}
