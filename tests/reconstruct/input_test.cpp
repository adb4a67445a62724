/// Bad and odd input: one precise error, or a result and a word about it.

#include <atomic>

#include "../../inspect/check.h"
#include "../arrangement/polygon_sections.h"
#include "scenes.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

Sections stack(double scale = 1) {
  Sections s;
  for (const double z : {0.0, 1.0, 2.0}) s.planes.push_back(disk({0, 0, 1}, {0, 0, scale * z}, scale));
  return s;
}

ErrorCode error_of(const Sections& s) {
  const auto r = reconstruct(s);
  REQUIRE_FALSE(r.ok());
  CHECK_FALSE(r.error().message.empty());
  return r.error().code;
}

void check_good(const Sections& s) {
  const auto r = reconstruct(s);
  REQUIRE(r.ok());
  CHECK_FALSE(r->surface.triangles.empty());
  CHECK(check_surface(r->surface).good_topology());
}

void check_empty(const Sections& s) {
  const auto r = reconstruct(s);
  REQUIRE(r.ok());
  CHECK(r->surface.triangles.empty());
  CHECK(r->solid.tets.empty());
  CHECK_FALSE(r->report.warnings.empty());
}

}  // namespace

TEST_CASE("sizes from 1e-12 to 1e12 work") {
  for (const double scale : {1e-12, 1e-3, 1e3, 1e12}) check_good(stack(scale));
}

TEST_CASE("areas are right where their squares leave the doubles") {
  for (const double scale : {1e80, 1e-85}) {
    CAPTURE(scale);
    const auto r = reconstruct(stack(scale));
    REQUIRE(r.ok());
    const double unit = scale * scale, whole = check_surface(r->surface).area / unit;
    CHECK(r->report.section_area / unit == doctest::Approx(9));  // each 12-gon has 3
    CHECK(whole == doctest::Approx(check_surface(reconstruct(stack())->surface).area));
  }
}

TEST_CASE("contours that are smaller than the grid can be are refused") {
  CHECK(error_of(stack(1e-310)) == ErrorCode::too_large);
}

TEST_CASE("repeated vertices, collinear runs and an empty plane work") {
  Sections s = stack();
  add_contour(s.planes[0], {{5, 5, 0}, {6, 5, 0}, {6, 5, 0}, {7, 5, 0}, {7, 6, 0}, {5, 6, 0}}, 1);
  s.planes.push_back(plane_at({1, 0, 0}, {3, 0, 0}));
  check_good(s);
}

TEST_CASE("contours without area are dropped with a warning") {
  Sections s = stack();
  add_contour(s.planes[1], {{5, 5, 1}, {6, 6, 1}}, 1);
  const auto r = reconstruct(s);
  REQUIRE(r.ok());
  CHECK_FALSE(r->report.warnings.empty());
  CHECK(hash(*r) == hash(*reconstruct(stack())));
}

TEST_CASE("the log hears all notes and warnings of the report, each once") {
  Sections s = stack();
  s.planes.push_back(s.planes[1]);                      // a note of the frames
  add_contour(s.planes[1], {{5, 5, 1}, {6, 6, 1}}, 1);  // a warning of theirs
  std::vector<std::string> notes, warnings;
  Context context;
  context.log = [&](LogLevel level, std::string_view text) {
    (level == LogLevel::note ? notes : warnings).emplace_back(text);
  };
  const auto r = reconstruct(s, {}, context);
  REQUIRE(r.ok());
  CHECK_FALSE(notes.empty());
  CHECK_FALSE(warnings.empty());
  CHECK(notes == r->report.notes);
  CHECK(warnings == r->report.warnings);
}

TEST_CASE("equal planes with equal or disjoint sections are one plane") {
  Sections twice = stack();
  twice.planes.push_back(twice.planes[1]);
  CHECK(hash(*reconstruct(twice)) == hash(*reconstruct(stack())));
  Sections disjoint = stack();
  disjoint.planes.push_back(disk({0, 0, -1}, {9, 0, 1}, 1));
  check_good(disjoint);
  Sections contradicting = stack();
  contradicting.planes.push_back(disk({0, 0, 1}, {0.5, 0, 1}, 1));
  CHECK(error_of(contradicting) == ErrorCode::contradicting_planes);
}

TEST_CASE("one plane, or only empty ones: an empty surface and a word why") {
  Sections one;
  one.planes.push_back(disk({0, 0, 1}, {0, 0, 0}));
  check_empty(one);
  Sections empty;
  for (const double z : {0.0, 1.0}) empty.planes.push_back(plane_at({0, 0, 1}, {0, 0, z}));
  check_empty(empty);
  Sections between = stack();  // an empty plane between each two sections
  between.planes.push_back(plane_at({0, 0, 1}, {0, 0, 0.5}));
  between.planes.push_back(plane_at({0, 0, 1}, {0, 0, 1.5}));
  check_empty(between);
}

TEST_CASE("a part of a file needs the positions of its planes and an extent that holds it") {
  Sections part = stack();
  Bounds whole;
  for (const PlaneSection& p : part.planes) whole.join(bounds_of(p.vertices));
  part.part_of = PartOf{{4, 5, 6}, whole, whole};
  check_good(part);
  Bounds less = whole;
  less.high.z = 0.5;
  for (const PartOf& bad :
       {PartOf{{4, 5, 6}, less, whole}, PartOf{{4, 5, 6}, whole, less}, PartOf{{4}, whole, whole}}) {
    part.part_of = bad;
    CHECK(error_of(part) == ErrorCode::usage);
  }
  Options options;
  options.joins.resize(1);
  CHECK(reconstruct(part, options).error().code == ErrorCode::usage);
}

TEST_CASE("what can't be read as sections is an error that names the place") {
  CHECK(error_of({}) == ErrorCode::no_plane);
  Sections s = stack();
  s.planes[1].vertices[3].x = NAN;
  CHECK(error_of(s) == ErrorCode::not_finite);
  s = stack();
  s.planes[1].normal = {0, 0, 0};
  CHECK(error_of(s) == ErrorCode::zero_normal);
  s = stack();
  s.planes[1].edges[2].b = 999;
  CHECK(error_of(s) == ErrorCode::index_out_of_range);
  s = stack();
  s.planes[1].edges.pop_back();
  CHECK(error_of(s) == ErrorCode::open_chain);
  s = stack();
  s.planes[1].vertices[3].z += 0.5;
  CHECK(error_of(s) == ErrorCode::off_plane);
  s = stack();
  std::swap(s.planes[2].vertices[3], s.planes[2].vertices[7]);
  const auto r = reconstruct(s);
  REQUIRE_FALSE(r.ok());
  CHECK(r.error().code == ErrorCode::self_crossing);
  CHECK(r.error().plane == 2);
}

TEST_CASE("coordinates whose volume overflows and tolerances that are none are refused") {
  CHECK(error_of(stack(1e200)) == ErrorCode::too_large);
  for (const double tolerance : {-1.0, 2.0, static_cast<double>(NAN)}) {
    Options options;
    options.match_tolerance = tolerance;
    const auto r = reconstruct(stack(), options);
    REQUIRE_FALSE(r.ok());
    CHECK(r.error().code == ErrorCode::usage);
  }
}

TEST_CASE("a raised cancel flag ends the work") {
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  const auto r = reconstruct(stack(), {}, context);
  REQUIRE_FALSE(r.ok());
  CHECK(r.error().code == ErrorCode::cancelled);
}

TEST_CASE("a flag raised at any report of progress ends the work") {
  Sections s = stack();
  s.planes.push_back(disk({1, 0, 0}, {0, 0, 0}, 1));
  Options options;
  options.simplify = 1e-3;
  options.thicken = 1e-2;
  std::size_t reports = 0;
  Context context;
  context.progress = [&](std::string_view, double) { ++reports; };
  REQUIRE(reconstruct(s, options, context).ok());
  REQUIRE(reports > 10);
  for (std::size_t raising = 0; raising < reports; ++raising) {
    CAPTURE(raising);
    std::atomic<bool> cancel{false};
    std::size_t heard = 0;
    context.cancel = &cancel;
    context.progress = [&](std::string_view, double) { if (heard++ == raising) cancel = true; };
    const auto r = reconstruct(s, options, context);
    REQUIRE_FALSE(r.ok());
    CHECK(r.error().code == ErrorCode::cancelled);
  }
}

TEST_CASE("pencils, four planes through a point, contours along common lines") {
  Sections pencil;  // half disks would contradict: whole disks around the common axis
  for (const Vec3& n : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{1, 1, 0}, Vec3{1, -2, 0}})
    pencil.planes.push_back(disk(n, {0, 0, 0}, 1, 32));
  check_good(pencil);
  Sections point = pencil;
  point.planes.push_back(disk({0, 0, 1}, {0, 0, 0}, 1, 32));
  check_good(point);
  Sections cube;  // the faces of a cube: every contour edge lies on the line of two planes
  for (int axis = 0; axis < 3; ++axis)
    for (const double at : {-1.0, 1.0}) {
      Vec3 n{axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
      PlaneSection plane = plane_at(n, at * n);
      const Vec3 u{n.z, n.x, n.y}, v{n.y, n.z, n.x};
      std::vector<Vec3> corners;
      for (const auto& [a, b] : {std::pair{-1., -1.}, {1., -1.}, {1., 1.}, {-1., 1.}})
        corners.push_back(at * n + a * u + b * v);
      add_contour(plane, corners);
      cube.planes.push_back(plane);
    }
  const auto r = reconstruct(cube);
  REQUIRE(r.ok());
  CHECK(r->report.volume == 8);
  CHECK(r->surface.triangles.size() == 12);
}
