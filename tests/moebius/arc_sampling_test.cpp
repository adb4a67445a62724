#include "../../moebius/arc_sampling.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace crossloft;

namespace {

constexpr Box2 kWide{{-1e9, -1e9}, {1e9, 1e9}};

double length(Vec2 v) { return std::sqrt(dot(v, v)); }

FaceArc circle_arc(Vec2 centre, double radius, double from, double to, bool clockwise) {
  FaceArc arc;
  arc.curve.centre = centre;
  arc.curve.radius = radius;
  arc.from = centre + radius * Vec2{std::cos(from), std::sin(from)};
  arc.to = centre + radius * Vec2{std::cos(to), std::sin(to)};
  arc.clockwise = clockwise;
  arc.over_half = std::abs(to - from) > 3.14159265358979324;
  return arc;
}

FaceArc line_arc(Vec2 centre, Vec2 direction, double from, double to) {
  FaceArc arc;
  arc.curve = {true, centre, 0, (1 / length(direction)) * direction};
  arc.from_infinite = std::isinf(from);
  arc.to_infinite = std::isinf(to);
  if (!arc.from_infinite) arc.from = centre + from * arc.curve.direction;
  if (!arc.to_infinite) arc.to = centre + to * arc.curve.direction;
  return arc;
}

std::vector<Vec2> samples(const FaceArc& arc, double spacing, const Box2& box = kWide) {
  std::vector<Vec2> points;
  sample_arc(arc, spacing, box, points);
  return points;
}

/// On the circle, at equal steps, walked the way of the arc, the length of the walk that of the arc.
void check_circle(const FaceArc& arc, double angle, double spacing) {
  const auto points = samples(arc, spacing);
  REQUIRE(points.size() >= 2);
  CHECK(points.front() == arc.from);
  CHECK(length(points.back() - arc.to) <= 1e-9 * arc.curve.radius);
  const double first = length(points[1] - points[0]);
  double walked = 0;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const Vec2 a = points[k] - arc.curve.centre, b = points[k + 1] - arc.curve.centre;
    CHECK(length(a) == doctest::Approx(arc.curve.radius).epsilon(1e-12));
    CHECK(length(b - a) <= spacing);
    CHECK(length(b - a) == doctest::Approx(first).epsilon(1e-9));
    CHECK((cross(a, b) < 0) == arc.clockwise);
    walked += 2 * std::asin(length(b - a) / (2 * arc.curve.radius));
  }
  CHECK(walked == doctest::Approx(angle).epsilon(1e-9));
}

}  // namespace

TEST_CASE("arcs of circles, both ways around") {
  for (const double angle : {0.3, 1.5, 3.0, 3.1415, 3.2, 4.0, 6.0}) {
    CAPTURE(angle);
    check_circle(circle_arc({3, -2}, 5, 0.7, 0.7 + angle, false), angle, 0.2);
    check_circle(circle_arc({3, -2}, 5, 0.7, 0.7 - angle, true), angle, 0.2);
  }
}

TEST_CASE("a whole circle") {
  for (const bool clockwise : {false, true}) {
    FaceArc arc = circle_arc({-4, 8}, 2, 1, 1, clockwise);
    arc.whole = true;
    check_circle(arc, 2 * 3.14159265358979324, 0.1);
  }
}

TEST_CASE("a piece of a huge circle is nearly its chord, not quite") {
  FaceArc arc;
  arc.curve.radius = 1e12;
  arc.curve.centre = {0, 1e12};
  arc.from = {-1000, 1000.0 * 1000 / 2e12};
  arc.to = {1000, 1000.0 * 1000 / 2e12};
  const auto points = samples(arc, 1000);
  REQUIRE(points.size() == 3);
  CHECK(std::abs(points[1].x) < 1e-9);
  CHECK(std::abs(points[1].y) < 1e-12);
}

TEST_CASE("an arc shorter than the spacing has its two ends") {
  CHECK(samples(circle_arc({0, 0}, 1, 0, 0.5, false), 10).size() == 2);
  CHECK(samples(line_arc({0, 0}, {1, 1}, 0, 1), 10).size() == 2);
}

TEST_CASE("lines, finite or clipped at the box") {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Box2 box{{-10, -10}, {10, 10}};
  const auto finite = samples(line_arc({1, 2}, {3, 4}, -2, 6), 0.5, box);
  CHECK(finite.size() == 17);
  CHECK(samples(line_arc({0, 5}, {1, 0}, -kInfinity, kInfinity), 1, box).size() == 33);
  CHECK(samples(line_arc({0, 50}, {1, 0}, -kInfinity, kInfinity), 1, box).empty());
  CHECK(samples(line_arc({0, 0}, {1, 0}, 20, kInfinity), 1, box).empty());
  const auto ray = samples(line_arc({0, 0}, {1, 1}, -kInfinity, 3), 1, box);
  REQUIRE(!ray.empty());
  CHECK(length(ray.front() - Vec2{-10, -10}) < 1e-12);
  CHECK(length(ray.back() - (3 / std::sqrt(2.0)) * Vec2{1, 1}) < 1e-12);
}

TEST_CASE("only points in the box, at no cost for the rest") {
  const Box2 box{{-1, -1}, {1, 1}};
  FaceArc arc = circle_arc({0, -1e9}, 1e9, 0, 0, false);
  arc.whole = true;
  const auto points = samples(arc, 0.01, box);
  CHECK(points.size() >= 200);
  CHECK(points.size() <= 403);
  for (const Vec2 p : points) CHECK(std::abs(p.y) < 1e-6);
}

TEST_CASE("an end that was rounded far off its line or circle asks for no more points than the box can hold") {
  const Box2 box{{-8, -8}, {8, 8}};
  FaceArc line = line_arc({0, 0}, {1, 0}, -INFINITY, 5);
  line.to = {5, 1e27};
  const auto points = samples(line, 1, box);
  CHECK(points.size() >= 13);
  CHECK(points.size() <= 40);
  for (const Vec2 p : points) CHECK(p.y == 0);
  FaceArc circle = circle_arc({0, 0}, 4, 0, 1, false);
  circle.to = {1e27, 0};
  CHECK(samples(circle, 1, box).empty());
}
