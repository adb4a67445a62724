#include "../../io/write_sections.h"

#include <cmath>
#include <random>

#include <doctest/doctest.h>

#include "../../io/read_sections.h"
#include "../../io/section_loops.h"
#include "scratch.h"
#include "section_texts.h"

using namespace crossloft;

namespace {

/// A section in z = 0 from vertices and closed chains of them.
PlaneSection section(std::vector<Vec3> vertices, const std::vector<std::vector<std::uint32_t>>& chains) {
  PlaneSection plane;
  plane.normal = {0, 0, 1};
  plane.vertices = std::move(vertices);
  for (std::uint32_t c = 0; c < chains.size(); ++c) {
    for (std::size_t i = 0; i < chains[c].size(); ++i) {
      plane.edges.push_back({chains[c][i], chains[c][(i + 1) % chains[c].size()], 1, 0, c, 0});
    }
  }
  return plane;
}

std::vector<Vec3> square(double x, double y, double half) {
  return {{x - half, y - half, 0}, {x + half, y - half, 0}, {x + half, y + half, 0}, {x - half, y + half, 0}};
}

void check_same(const Sections& a, const Sections& b) {
  REQUIRE(a.planes.size() == b.planes.size());
  for (std::size_t p = 0; p < a.planes.size(); ++p) {
    const PlaneSection &u = a.planes[p], &v = b.planes[p];
    CHECK(u.normal == v.normal);
    CHECK(u.offset == v.offset);
    CHECK(u.vertices == v.vertices);
    REQUIRE(u.edges.size() == v.edges.size());
    for (std::size_t e = 0; e < u.edges.size(); ++e) {
      CHECK(u.edges[e].a == v.edges[e].a);
      CHECK(u.edges[e].b == v.edges[e].b);
      CHECK(u.edges[e].material_a == v.edges[e].material_a);
      CHECK(u.edges[e].material_b == v.edges[e].material_b);
      CHECK(u.edges[e].contour == v.edges[e].contour);
    }
  }
}

}  // namespace

TEST_CASE(".contour: what is written reads back the same") {
  const std::string from_csl = format_contour(*parse_csl(section_texts::kSquareWithHole, ""));
  for (const std::string& text : {section_texts::kTwoSquares, from_csl}) {
    const Sections first = *parse_contour(text, "");
    const Result<Sections> again = parse_contour(format_contour(first), "");
    REQUIRE(again.ok());
    check_same(first, *again);
  }
}

TEST_CASE(".csl: what is written reads back the same") {
  const Sections first = *parse_csl(section_texts::kSquareWithHole, "");
  const Result<std::string> text = format_csl(first);
  REQUIRE(text.ok());
  CHECK(text->find("\n4h0 1 7 6 5 4\n") != std::string::npos);
  const Result<Sections> again = parse_csl(*text, "");
  REQUIRE(again.ok());
  check_same(first, *again);
}

TEST_CASE("random doubles keep all their bits in both formats") {
  constexpr unsigned kSeed = 7;
  CAPTURE(kSeed);
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-300, 300);
  const auto real = [&] { return std::ldexp(mantissa(random), exponent(random)); };
  for (int round = 0; round < 300; ++round) {
    Sections sections;
    sections.planes.push_back(
        section({{real(), real(), 0}, {real(), real(), 0}, {real(), real(), 0}}, {{0, 1, 2}}));
    const Result<Sections> contour = parse_contour(format_contour(sections), "");
    REQUIRE(contour.ok());
    check_same(sections, *contour);
    const Result<Sections> csl = parse_csl(*format_csl(sections), "");
    REQUIRE(csl.ok());
    check_same(sections, *csl);
  }
}

TEST_CASE("loops: nesting gives holes their parents") {
  std::vector<Vec3> vertices;
  for (const double half : {4.0, 3.0, 2.0, 1.0}) {
    for (const Vec3& corner : square(0, 0, half)) vertices.push_back(corner);
  }
  const auto loops =
      section_loops(section(vertices, {{12, 13, 14, 15}, {0, 1, 2, 3}, {8, 9, 10, 11}, {4, 5, 6, 7}}));
  REQUIRE(loops.ok());
  REQUIRE(loops->size() == 4);
  CHECK(loops.value()[0].parent == 2);
  CHECK(loops.value()[1].parent == kNone);
  CHECK(loops.value()[2].parent == kNone);
  CHECK(loops.value()[3].parent == 1);
}

TEST_CASE("loops: at a vertex of degree four they touch and do not cross") {
  // Two squares that share the corner (1, 1), given as one chain that crosses itself there.
  std::vector<Vec3> vertices = square(0, 0, 1);
  vertices.push_back({3, 1, 0});
  vertices.push_back({3, 3, 0});
  vertices.push_back({1, 3, 0});
  const auto loops = section_loops(section(vertices, {{0, 1, 2, 6, 5, 4, 2, 3}}));
  REQUIRE(loops.ok());
  std::size_t walls = 0;
  for (const SectionLoop& loop : *loops) {
    walls += loop.vertices.size();
    CHECK(loop.parent == kNone);
  }
  CHECK(walls == 8);
}

TEST_CASE("loops: a hole that touches the outer contour in a vertex stays a hole") {
  std::vector<Vec3> vertices = square(0, 0, 2);
  vertices.push_back({-1, 1, 0});
  vertices.push_back({1, 1, 0});
  // The middle of the upper side, shared by the outer contour and the triangle below it.
  vertices.push_back({0, 2, 0});
  const PlaneSection plane = section(vertices, {{0, 1, 2, 6, 3}, {6, 4, 5}});
  const auto loops = section_loops(plane);
  REQUIRE(loops.ok());
  Sections sections;
  sections.planes.push_back(plane);
  const Result<Sections> again = parse_csl(*format_csl(sections), "");
  REQUIRE(again.ok());
  CHECK(again->planes[0].edges.size() == plane.edges.size());
}

TEST_CASE("loops: inner borders of materials and pairs of equal edges are no walls") {
  // Two squares of materials 1 and 2 side by side; the border between them is given once with both materials.
  PlaneSection plane =
      section({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3, 4, 5}});
  plane.edges[1].material_a = plane.edges[2].material_a = plane.edges[3].material_a = 2;
  PlaneSection border = plane, doubled = plane;
  border.edges.push_back({1, 4, 1, 2, 0, 0});
  doubled.edges.push_back({1, 4, 1, 0, 0, 0});
  doubled.edges.push_back({4, 1, 2, 0, 0, 0});
  for (const PlaneSection& given : {border, doubled}) {
    const auto loops = section_loops(given);
    REQUIRE(loops.ok());
    REQUIRE(loops->size() == 1);
    CHECK(loops.value()[0].vertices == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5});
    CHECK(loops.value()[0].mixed);
  }
  Heard heard;
  Sections sections;
  sections.planes.push_back(border);
  CHECK(format_csl(sections, heard.context()).ok());
  CHECK(heard.warnings.size() == 1);
}

TEST_CASE(".csl needs contours that close") {
  Sections sections;
  sections.planes.push_back(section(square(0, 0, 1), {{0, 1, 2, 3}}));
  sections.planes.push_back(sections.planes[0]);
  sections.planes[1].edges.pop_back();
  sections.planes[1].edges.back().line = 12;
  const Result<std::string> text = format_csl(sections);
  REQUIRE_FALSE(text.ok());
  CHECK(text.error().code == ErrorCode::open_chain);
  CHECK(text.error().plane == 1);
  CHECK(text.error().contour == 0);
}

TEST_CASE("what would not be read back is not written") {
  const Scratch scratch;
  const Sections good = *parse_contour(section_texts::kTwoSquares, "");
  Sections dangling = good, no_number = good, no_direction = good;
  dangling.planes[1].edges[0].a = 4000000000u;
  no_number.planes[1].vertices[0].x = std::nan("");
  no_direction.planes[1].normal = {};
  const std::pair<Sections, ErrorCode> cases[] = {{dangling, ErrorCode::index_out_of_range},
                                                  {no_number, ErrorCode::not_finite},
                                                  {no_direction, ErrorCode::zero_normal}};
  for (const auto& [bad, code] : cases) {
    for (const std::string name : {"a.contour", "a.csl"}) {
      const Result<Done> written = write_sections(scratch.path(name), bad);
      REQUIRE_FALSE(written.ok());
      CHECK(written.error().code == code);
      CHECK(written.error().plane == 1);
    }
    CHECK(format_csl(bad).error().code == code);
  }
  CHECK(scratch.files() == 0);
}

TEST_CASE("files are written by extension") {
  const Scratch scratch;
  const Sections sections = *parse_contour(section_texts::kTwoSquares, "");
  for (const std::string name : {"a.contour", "a.csl", "B.CSL"}) {
    REQUIRE(write_sections(scratch.path(name), sections).ok());
    const Result<Sections> again = read_sections(scratch.path(name));
    REQUIRE(again.ok());
    check_same(sections, *again);
  }
  CHECK(write_sections(scratch.path("a.ply"), sections).error().code == ErrorCode::usage);
  CHECK(write_sections(scratch.path("no/a.csl"), sections).error().code == ErrorCode::file_not_writable);
  CHECK(scratch.files() == 3);
}
