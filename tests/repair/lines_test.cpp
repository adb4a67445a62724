// Common lines, traces of sections on them, and what lines should be.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "../../inspect/random.h"
#include "../../repair/common_lines.h"
#include "../../repair/line_patches.h"
#include "../../repair/line_target.h"
#include "../../repair/section_trace.h"
#include "../arrangement/polygon_sections.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

SectionBoundary boundary(const PlaneSection& section) {
  const double length = norm(section.normal);
  const UnitPlane plane{(1 / length) * section.normal, section.offset / length};
  return SectionBoundary(section, plane, PlaneChart(plane.normal, plane.offset, {0, 0, 0}, 4));
}

/// The x axis.
CommonLine x_axis() { return {{0, 0, 0}, {1, 0, 0}, 2, {0, 1}}; }

}  // namespace

TEST_CASE("common lines lie on their planes, one for a pencil, none for parallel planes") {
  std::vector<UnitPlane> planes{{{0, 0, 1}, 0}, {{0, 1, 0}, 0}, {{0, 0, 1}, -0.5}};
  const Vec3 n = unit({0, 1, 1});
  planes.push_back({n, 0});
  const auto lines = common_lines(planes, {{0, 0, 0}, 1}, 1e-9);
  REQUIRE(lines.size() == 3);
  CHECK(lines[0].planes == std::vector<std::uint32_t>{0, 1, 3});
  for (const CommonLine& l : lines)
    for (const std::uint32_t p : l.planes)
      for (const double t : {-l.reach, 0.0, l.reach}) CHECK(std::fabs(planes[p].height(l.at(t))) < 1e-15);
  CHECK(common_lines(planes, {{0, 0, 9}, 1}, 1e-9).empty());
}

TEST_CASE("common points are found once, with all planes and lines through them") {
  const std::vector<UnitPlane> planes{
      {{0, 0, 1}, 0}, {{0, 1, 0}, 0}, {{1, 0, 0}, 0}, {unit({1, 1, 1}), 0}, {{1, 0, 0}, -0.5}};
  const auto lines = common_lines(planes, {{0, 0, 0}, 1}, 1e-9);
  const auto points = common_points(planes, lines, 1e-9);
  const auto origin =
      std::find_if(points.begin(), points.end(), [](const SharedPoint& p) { return norm(p.point) < 1e-12; });
  REQUIRE(origin != points.end());
  CHECK(origin->planes == std::vector<std::uint32_t>{0, 1, 2, 3});
  CHECK(origin->lines.size() == 6);
  CHECK(std::count_if(points.begin(), points.end(),
                      [](const SharedPoint& p) { return norm(p.point) < 1e-12; }) == 1);
}

TEST_CASE("a trace is inside where the section is") {
  PlaneSection plane = plane_at({0, 0, 1}, {0, 0, 0});
  add_contour(plane, square(0, 0.25, 0, 1));
  add_contour(plane, square(0, 0.25, 0, 0.5), 1);
  const Trace trace = boundary(plane).trace(x_axis(), 1e-9);
  REQUIRE(trace.cuts == std::vector<double>{-1, -0.5, 0.5, 1});
  CHECK(trace.between(-2, -1) == Inside::no);
  CHECK(trace.between(-1, -0.5) == Inside::yes);
  CHECK(trace.between(-0.4, 0.4) == Inside::no);
  CHECK(trace.between(0.6, 0.9) == Inside::yes);
}

TEST_CASE("a contour along the line is as good inside as outside, one that touches it is not there") {
  PlaneSection plane = plane_at({0, 0, 1}, {0, 0, 0});
  add_contour(plane, square(0, 0.5, 0, 0.5));
  Trace trace = boundary(plane).trace(x_axis(), 1e-9);
  REQUIRE(trace.cuts == std::vector<double>{-0.5, 0.5});
  CHECK(trace.between(-0.1, 0.1) == Inside::either);
  plane = plane_at({0, 0, 1}, {0, 0, 0});
  add_contour(plane, {{0, 0, 0}, {1, 1, 0}, {-1, 1, 0}});
  trace = boundary(plane).trace(x_axis(), 1e-9);
  CHECK(trace.cuts.empty());
}

TEST_CASE("a section that alone comes to the line and goes contradicts at any length") {
  const Trace none{{}, {Inside::no}}, poke{{0.5, 0.5 + 1e-7}, {Inside::no, Inside::yes, Inside::no}};
  const Trace one{{0.5}, {Inside::no, Inside::yes}}, other{{0.5 + 1e-7}, {Inside::no, Inside::yes}};
  CHECK(contradict(std::vector{none, poke}, 0.1));
  CHECK_FALSE(contradict(std::vector{one, other}, 0.1));
  CHECK_FALSE(contradict(std::vector{poke, poke}, 0.1));
}

TEST_CASE("distances and nearest points against brute force") {
  const PlaneSection plane = disk({0, 0, 1}, {0, 0, 0}, 1, 30);
  const SectionBoundary section = boundary(plane);
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p{random.uniform(-2, 2), random.uniform(-2, 2), 0};
    const double radius = norm(p);
    if (std::fabs(radius - 1) < 0.01) continue;
    CHECK(section.inside(p) == (radius < 1));
    CHECK(std::fabs(std::fabs(section.signed_distance(p)) - std::fabs(radius - 1)) < 0.006);
    std::uint32_t contour = kNone;
    CHECK(norm(section.nearest(p, contour) - p) == doctest::Approx(section.distance(p)));
    CHECK(contour == 0);
  }
}

TEST_CASE("the target of two intervals is half way between them") {
  PlaneSection a = plane_at({0, 0, 1}, {0, 0, 0}), b = plane_at({0, 1, 0}, {0, 0, 0});
  add_contour(a, square(0, 0, 0, 1));
  add_contour(b, {{-0.8, 0, -1}, {1.2, 0, -1}, {1.2, 0, 1}, {-0.8, 0, 1}});
  const std::vector<SectionBoundary> sections = [&] {
    std::vector<SectionBoundary> list;
    list.push_back(boundary(a));
    list.push_back(boundary(b));
    return list;
  }();
  const LineSetting setting{sections, 1e-9, 0.05, 1e-6, 8};
  const CommonLine line = x_axis();
  const std::vector<Trace> traces{sections[0].trace(line, 1e-9), sections[1].trace(line, 1e-9)};
  CHECK(contradict(traces, 0.19));
  CHECK_FALSE(contradict(traces, 0.21));
  const LineTarget target = line_target(setting, line, traces, {});
  REQUIRE(target.spans.size() == 3);
  CHECK(target.spans[1].state == Inside::yes);
  CHECK(target.spans[1].begin == doctest::Approx(-0.9));
  CHECK(target.spans[1].end == doctest::Approx(1.1));
  const auto extend = misfits(setting, line, 0, traces[0], target, target.spans[1]);
  REQUIRE(extend.size() == 1);
  CHECK(extend[0].begin == doctest::Approx(1));
  CHECK(extend[0].end == target.spans[1].end);
  CHECK(extend[0].depth == doctest::Approx(0.1));
  CHECK(misfits(setting, line, 0, traces[0], target, target.spans[0]).size() == 1);
  CHECK(misfits(setting, line, 0, traces[0], target, target.spans[2]).empty());
}

TEST_CASE("the lens of a misfit makes the section end where the target does") {
  PlaneSection a = plane_at({0, 0, 1}, {0, 0, 0}), b = plane_at({0, 1, 0}, {0, 0, 0});
  add_contour(a, square(0, 0, 0, 1));
  add_contour(b, {{-1, 0, -1}, {1.2, 0, -1}, {1.2, 0, 1}, {-1, 0, 1}});
  std::vector<SectionBoundary> sections;
  sections.push_back(boundary(a));
  sections.push_back(boundary(b));
  const LineSetting setting{sections, 1e-9, 0.05, 1e-6, 8};
  const CommonLine line = x_axis();
  const std::vector<Trace> traces{sections[0].trace(line, 1e-9), sections[1].trace(line, 1e-9)};
  const LineTarget target = line_target(setting, line, traces, {});
  const auto found = misfits(setting, line, 0, traces[0], target, target.spans[1]);
  REQUIRE(found.size() == 1);
  PlaneLines plane{sections[0], {{&line, &target, {}}}};
  plane.lines[0].corrections.emplace_back(sections[0], line, target, found[0], true, 1e-6);
  const Correction& correction = plane.lines[0].corrections[0];
  CHECK(correction.reach() <= kReach * kPush * found[0].depth * (1 + 1e-12));
  CHECK(correction(found[0].end, correction.reach()) == 0);
  const Patch patch = lens(plane, 0, target.spans[1], 1e-6);
  edit_section(a, PlaneChart({0, 0, 1}, 0, {0, 0, 0}, 4), {&patch, 1});
  const Trace after = boundary(a).trace(line, 1e-8);
  REQUIRE(after.cuts.size() == 2);
  CHECK(after.cuts[1] == target.spans[1].end);
  for (const Vec3& v : a.vertices) CHECK(v.x <= target.spans[1].end + 1e-9);
}
