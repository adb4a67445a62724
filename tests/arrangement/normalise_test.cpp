#include "../../arrangement/normalise.h"

#include <doctest/doctest.h>

#include <limits>

#include "polygon_sections.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

Sections two_squares() {
  Sections in{"two.contour", {plane_at({0, 0, 1}, {0, 0, 0}), plane_at({0, 0, 2}, {0, 0, 1})}};
  add_contour(in.planes[0], square(0, 0, 0, 1));
  add_contour(in.planes[1], square(0, 0, 1, 1));
  in.planes[1].line = 7;
  return in;
}

Error error_of(const Sections& in) {
  const Result<NormalisedSections> r = normalise(in, 1e-3);
  REQUIRE_FALSE(r.ok());
  CHECK(r.error().file == in.source);
  return r.error();
}

NormalisedSections value_of(const Sections& in) {
  Result<NormalisedSections> r = normalise(in, 1e-3);
  REQUIRE(r.ok());
  return *r;
}

}  // namespace

TEST_CASE("a plain section stays as it is, in order") {
  const NormalisedSections out = value_of(two_squares());
  REQUIRE(out.sections.size() == 2);
  CHECK(out.warnings.empty());
  CHECK(out.notes.empty());
  const WallSection& s = out.sections[1];
  CHECK(s.source == 1);
  CHECK(s.vertices == std::vector<Vec3>{{-1, -1, 1}, {-1, 1, 1}, {1, -1, 1}, {1, 1, 1}});
  REQUIRE(s.walls.size() == 4);
  CHECK((s.walls[0].a == 0 && s.walls[0].b == 1 && s.walls[3].a == 2 && s.walls[3].b == 3));
  CHECK(s.walls[0].line == 103);
  CHECK(s.normal == Vec3{0, 0, 0.5});
  CHECK(out.diagonal == doctest::Approx(3));
}

TEST_CASE("numbers that are none") {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(),
                   kInf = std::numeric_limits<double>::infinity();
  Sections in = two_squares();
  in.planes[1].vertices[2].y = kNan;
  CHECK(error_of(in).code == ErrorCode::not_finite);
  CHECK(error_of(in).plane == 1);
  CHECK(error_of(in).contour == 0);
  CHECK(error_of(in).line == 101);
  in = two_squares();
  in.planes[1].offset = kInf;
  CHECK(error_of(in).code == ErrorCode::not_finite);
  CHECK(error_of(in).line == 7);
}

TEST_CASE("planes that are none") {
  Sections in = two_squares();
  in.planes[1].normal = {};
  CHECK(error_of(in).code == ErrorCode::zero_normal);
  in.planes.clear();
  CHECK(error_of(in).code == ErrorCode::no_plane);
}

TEST_CASE("contours that are none") {
  Sections in = two_squares();
  in.planes[1].edges[3].b = 4;
  CHECK(error_of(in).code == ErrorCode::index_out_of_range);
  CHECK(error_of(in).line == 103);
  in = two_squares();
  in.planes[1].edges.pop_back();
  CHECK(error_of(in).code == ErrorCode::open_chain);
  CHECK(error_of(in).contour == 0);
  in = two_squares();
  in.planes[1].vertices[0].z += 0.01;
  CHECK(error_of(in).code == ErrorCode::off_plane);
  CHECK(error_of(in).plane == 1);
  CHECK(error_of(in).line == 100);
  in.planes[1].vertices[0].z = 1.002;
  CHECK(value_of(in).sections[1].off_plane == doctest::Approx(0.002));
}

TEST_CASE("repeated vertices, zero edges and a repeated first vertex are harmless") {
  Sections in = two_squares();
  const NormalisedSections plain = value_of(in);
  in.planes[0].vertices.clear();
  in.planes[0].edges.clear();
  std::vector<Vec3> points = square(0, 0, 0, 1);
  points.insert(points.begin() + 1, points[0]);
  points[2].z = -0.0;
  add_contour(in.planes[0], points);
  in.planes[0].vertices.push_back(points[0]);  // closes by coordinates, not by index
  in.planes[0].edges.back().b = 5;
  in.planes[0].vertices.push_back({50, 60, 0});  // isolated, does not count
  const NormalisedSections out = value_of(in);
  CHECK(out.sections[0].vertices == plain.sections[0].vertices);
  CHECK(out.sections[0].walls.size() == 4);
  CHECK(out.diagonal == plain.diagonal);
  CHECK(out.warnings.empty());
}

TEST_CASE("contours without area are dropped with a warning") {
  Sections in = two_squares();
  PlaneSection& p = in.planes[0];
  add_contour(p, {{3, 3, 0}, {3.5, 3.5, 0}}, 1);                     // there and back
  add_contour(p, {{3, 0, 0}, {3.25, 0.125, 0}, {3.5, 0.25, 0}}, 2);  // collinear
  add_contour(p, {{0.5, 0.5, 0}}, 3);                                // a point
  const NormalisedSections out = value_of(in);
  CHECK(out.sections[0].walls.size() == 4);
  CHECK(out.sections[0].vertices.size() == 4);
  REQUIRE(out.warnings.size() == 3);
  CHECK(out.warnings[1].find("plane 0, contour 2") != std::string::npos);
}

TEST_CASE("the border of two materials is no wall") {
  Sections in = two_squares();
  PlaneSection& p = in.planes[0];  // the square's right half is material 2
  p.vertices = {{-1, -1, 0}, {0, -1, 0}, {1, -1, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 1, 0}};
  p.edges = {{0, 1, 1, 0, 0, 0}, {1, 2, 0, 2, 0, 0}, {2, 3, 2, 0, 0, 0}, {3, 4, 2, 0, 0, 0},
             {4, 5, 1, 0, 0, 0}, {5, 0, 0, 1, 0, 0}, {1, 4, 1, 2, 0, 0}};
  const NormalisedSections out = value_of(in);
  CHECK(out.sections[0].walls.size() == 6);
  REQUIRE(out.notes.size() == 1);
  CHECK(out.notes[0].find("2 materials") != std::string::npos);
}

TEST_CASE("equal edges cancel in pairs") {
  Sections in = two_squares();
  add_contour(in.planes[0], {{1, -1, 0}, {1, 1, 0}, {2, 0, 0}}, 1);  // shares an edge with the square
  const NormalisedSections out = value_of(in);
  CHECK(out.sections[0].walls.size() == 5);
  std::vector<WallEdge> walls{
      {1, 2, 0, 5, 0}, {0, 3, 0, 0, 0}, {1, 2, 0, 4, 0}, {1, 2, 0, 3, 0}, {2, 2, 0, 0, 0}};
  cancel_pairs(walls);
  REQUIRE(walls.size() == 2);
  CHECK(walls[1].contour == 3);
}
