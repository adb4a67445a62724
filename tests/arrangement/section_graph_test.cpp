#include "../../arrangement/section_graph.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>

#include "../../geom/lattice_rounding.h"
#include "built_graph.h"
#include "polygon_sections.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

/// The unit square of half side h in z = 0 and in x = 0, the second moved by `shift` along their common line.
Sections crossing_squares(double h, double shift) {
  Sections s;
  PlaneSection flat = plane_at({0, 0, 1}, {0, 0, 0}), upright = plane_at({1, 0, 0}, {0, 0, 0});
  add_contour(flat, square(0, 0, 0, h));
  std::vector<Vec3> turned;
  for (const Vec3& p : square(0, shift, 0, h)) turned.push_back({0, p.y, p.x});
  add_contour(upright, turned);
  s.planes = {flat, upright};
  return s;
}

std::ptrdiff_t in_dimension(const SectionGraph& graph, int dimension) {
  return std::count_if(graph.locations.begin(), graph.locations.end(),
                       [&](const Location& l) { return l.dimension == dimension; });
}

}  // namespace

TEST_CASE("sections that agree share their crossings") {
  const Built b = build(crossing_squares(1, 0));
  REQUIRE(b.graph.ok());
  CHECK(b.graph->statistics.crossings == 4);
  CHECK(b.graph->statistics.matched == 4);
  CHECK(b.graph->statistics.unmatched.empty());
  CHECK(b.graph->size() == 10);  // four corners each, two crossings in common
}

TEST_CASE("crossings within the tolerance merge half way, further ones stay apart and are reported") {
  const Built near = build(crossing_squares(1, 1e-3));
  REQUIRE(near.graph.ok());
  CHECK(near.graph->statistics.matched == 4);
  CHECK(near.graph->statistics.largest_gap * near.framed.grid.unit() == doctest::Approx(1e-3));
  const Built far = build(crossing_squares(1, 0.1));
  REQUIRE(far.graph.ok());
  CHECK(far.graph->statistics.matched == 0);
  CHECK(far.graph->statistics.unmatched.size() == 4);
  CHECK(far.graph->size() == 12);
}

TEST_CASE("a vertex that the slicer put on the line is the crossing") {
  Sections s = crossing_squares(1, 0);
  for (const double y : {-1.0, 1.0}) {  // a vertex on each crossed edge, off the line by less than the tolerance
    auto& plane = s.planes[0];
    for (ContourEdge& e : plane.edges) {
      const Vec3 a = plane.vertices[e.a], c = plane.vertices[e.b];
      if (a.y != y || c.y != y) continue;
      plane.vertices.push_back({1e-12, y, 0});
      const auto v = static_cast<std::uint32_t>(plane.vertices.size() - 1);
      const std::uint32_t end = e.b;
      e.b = v;
      plane.edges.push_back({v, end, 1, 0, 0, 0});
      break;
    }
  }
  const Built b = build(s);
  REQUIRE(b.graph.ok());
  CHECK(b.graph->statistics.on_line == 2);
  CHECK(b.graph->statistics.matched == 4);
  CHECK(b.graph->size() == 10);
}

TEST_CASE("contour edges along the common line are walls of an arrangement edge") {
  Sections s;
  PlaneSection flat = plane_at({0, 0, 1}, {0, 0, 0}), upright = plane_at({1, 0, 0}, {0, 0, 0});
  add_contour(flat, {{0, -1, 0}, {2, -1, 0}, {2, 1, 0}, {0, 1, 0}});
  add_contour(upright, {{0, -2, -1}, {0, 2, -1}, {0, 2, 1}, {0, -2, 1}});
  s.planes = {flat, upright};
  const Built b = build(s);
  REQUIRE(b.graph.ok());
  std::size_t along = 0;
  for (const auto& walls : b.graph->walls)
    for (const Wall& w : walls)
      along += std::popcount(b.graph->zero_of(w.a)[0] & b.graph->zero_of(w.b)[0]) == 2;
  CHECK(along == 1);
}

TEST_CASE("a wall on an arrangement edge is cut where another section crosses the edge") {
  Sections s;
  PlaneSection flat = plane_at({0, 0, 1}, {0, 0, 0}), upright = plane_at({1, 0, 0}, {0, 0, 0});
  add_contour(flat, {{0, -1, 0}, {2, -1, 0}, {2, 1, 0}, {0, 1, 0}});
  add_contour(upright, {{0, -0.5, -1}, {0, 0.5, -1}, {0, 0.5, 1}, {0, -0.5, 1}});
  s.planes = {flat, upright};
  const Built b = build(s);  // verify() asks for the cuts
  REQUIRE(b.graph.ok());
  CHECK(b.graph->size() == 10);
  CHECK(b.graph->walls[0].size() + b.graph->walls[1].size() == 6 + 6);
}

TEST_CASE("a match that would make contours of a section cross is taken back") {
  // Side x = 1 of the square and the side of the upright one, 0.2 off, would meet beyond the triangle's
  // corner.
  Sections s;
  PlaneSection flat = plane_at({0, 0, 1}, {0, 0, 0}), upright = plane_at({0, 1, 0}, {0, 0, 0});
  add_contour(flat, square(0, 0, 0, 1), 0);
  add_contour(flat, {{1.05, 0.01, 0}, {2, 0.005, 0}, {2, 0.5, 0}}, 1);
  add_contour(upright, {{-1, 0, -1}, {1.2, 0, -1}, {1.2, 0, 1}, {-1, 0, 1}});
  s.planes = {flat, upright};
  const Built near = build(s, 0.01), far = build(s, 0.1);
  REQUIRE(near.graph.ok());
  REQUIRE(far.graph.ok());
  CHECK(near.graph->statistics.undone == 0);
  CHECK(near.graph->statistics.unpaired == 2);
  CHECK(far.graph->statistics.undone == 1);
  CHECK(far.graph->statistics.unpaired == 0);
  CHECK(far.graph->statistics.matched == 2);
  CHECK(far.graph->statistics.largest_gap == 0);
}

TEST_CASE("of equal gaps the first along the edge closes") {
  constexpr double kStep = 0x1p-8;
  Sections s;
  PlaneSection flat = plane_at({0, 0, 1}, {0, 0, 0}), upright = plane_at({1, 0, 0}, {0, 0, 0});
  add_contour(flat, square(0, -0.5, 0, 0.5), 0);  // crossings at -1 and 0
  add_contour(flat, square(0, 0.5 + 2 * kStep, 0, 0.5), 1);
  add_contour(upright, {{0, kStep, -1}, {0, 0.75, -1}, {0, 0.75, 1}, {0, kStep, 1}});
  s.planes = {flat, upright};
  const Built b = build(s);
  REQUIRE(b.graph.ok());
  CHECK(b.graph->statistics.matched == 2);
  std::vector<double> places;
  for (std::uint32_t v = 0; v < b.graph->size(); ++v)
    if (b.graph->locations[v].dimension == 1) places.push_back(b.graph->points[v].y * b.framed.grid.unit());
  REQUIRE(places.size() == 5);
  CHECK(places[1] - places[0] == doctest::Approx(1 + kStep / 2));
}

TEST_CASE("crossings of three planes through a line merge one after the other") {
  for (const double shift : {1e-3, 1.5e-3}) {  // the lower two or the upper two are the nearest
    Sections s = crossing_squares(1, shift);
    PlaneSection tilted = plane_at({1, 0, -1}, {0, 0, 0});
    std::vector<Vec3> turned;
    for (const Vec3& p : square(0, 2.5e-3, 0, 1)) turned.push_back({p.x, p.y, p.x});
    add_contour(tilted, turned);
    s.planes.push_back(tilted);
    const Built b = build(s);
    REQUIRE(b.graph.ok());
    CHECK(b.graph->statistics.crossings == 6);
    CHECK(b.graph->statistics.matched == 6);
    CHECK(b.graph->statistics.largest_gap * b.framed.grid.unit() == doctest::Approx(2e-3));
  }
}

TEST_CASE("a contour passes through an arrangement vertex that it goes by within the tolerance") {
  Sections s;
  PlaneSection flat = plane_at({0, 0, 1}, {0, 0, 0});
  add_contour(flat, {{-1, -1, 0}, {1, 1 + 2e-10, 0}, {1, -1, 0}});  // by the origin at 1e-10
  s.planes = {flat, plane_at({1, 0, 0}, {0, 0, 0}), plane_at({0, 1, 0}, {0, 0, 0})};
  const Built b = build(s);
  REQUIRE(b.graph.ok());
  CHECK(b.graph->size() == 6);
  CHECK(in_dimension(*b.graph, 0) == 1);
}

TEST_CASE("a crossing whose nearest rounding is on another plane takes the second nearest") {
  // In lattice units the contour runs from (-n, 0) to (3 n, 1): it crosses x = 0 at 0.25, on the inner side
  // of y = 0.
  Sections s;
  PlaneSection flat = plane_at({0, 0, 1}, {0, 0, 0});
  add_contour(flat, {{-1, 0, 0}, {3, 0, 0}, {3, 5, 0}, {-1, 5, 0}});
  s.planes = {flat, plane_at({1, 0, 0}, {0, 0, 0}), plane_at({0, 1, 0}, {0, 0, 0})};
  s.planes[0].vertices[1].y = build(s).framed.grid.unit();
  const Built b = build(s, 0, 0);
  REQUIRE(b.graph.ok());
  CHECK(in_dimension(*b.graph, 0) == 0);
  CHECK(in_dimension(*b.graph, 1) == 3);  // two crossings and the corner on y = 0
}

TEST_CASE("a contour smaller than the tolerance is not drawn onto a line") {
  Sections s;
  PlaneSection flat = plane_at({0, 0, 1}, {0, 0, 0});
  add_contour(flat, square(2, 0, 0, 1), 0);
  add_contour(flat, square(3e-4, 0, 0, 1e-4), 1);
  s.planes = {flat, plane_at({1, 0, 0}, {0, 0, 0})};
  const Built b = build(s, 2e-3, 1e-3);
  REQUIRE(b.graph.ok());
  CHECK(b.graph->statistics.on_line == 0);
  CHECK(in_dimension(*b.graph, 1) == 0);
  CHECK(b.graph->size() == 8);
}

TEST_CASE("a contour through an arrangement vertex crosses both lines there") {
  Sections s = crossing_squares(1, 0);
  PlaneSection diagonal = plane_at({0, 1, 0}, {0, 1, 0});  // y = 1 through both squares' sides
  add_contour(diagonal, {{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}});
  s.planes.push_back(diagonal);
  const Built b = build(s);
  REQUIRE(b.graph.ok());
  CHECK(in_dimension(*b.graph, 0) > 0);
}

TEST_CASE("an arrangement vertex inside the sections is a section vertex") {
  Sections s;
  for (const Vec3& n : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) s.planes.push_back(disk(n, {0, 0, 0}, 1, 16));
  const Built b = build(s);
  REQUIRE(b.graph.ok());
  CHECK(in_dimension(*b.graph, 0) == 1);
  CHECK(b.graph->statistics.disagreeing == 0);
}

TEST_CASE("contours that touch at a vertex or along an edge are cut there and doubled edges cancel") {
  Sections s;
  PlaneSection plane = plane_at({0, 0, 1}, {0, 0, 0});
  add_contour(plane, square(0, 0, 0, 1), 0);
  add_contour(plane, square(1.5, 0, 0, 0.5), 1);  // shares half a side
  s.planes = {plane};
  const Built b = build(s);
  REQUIRE(b.graph.ok());
  CHECK(b.graph->walls[0].size() == 8);  // 4 + 4, the shared piece gone, the long side in two rests
}

TEST_CASE("a touch survives the rounding of crossings") {
  // Found by random small inputs: (-2,-2,-2) of the second contour is on an edge of the first, which is then cut at
  // planes whose frames are a lattice step off.
  Sections s;
  PlaneSection plane = plane_at({1, 0, -1}, {0, 0, 0});
  add_contour(plane, {{-3, -3, -3}, {0, -3, 0}, {0, 0, 0}}, 0);
  add_contour(plane, {{-2, 2, -2}, {-1, 2, -1}, {-2, -2, -2}}, 1);
  s.planes = {plane, plane_at({1, -1, 0}, {0, 1, 0}), plane_at({0, 1, 1}, {0, -4, 0}), plane_at({1, 0, 0}, {0x1p-40, 0, 0})};
  const Built b = build(s);
  REQUIRE(b.graph.ok());
  std::vector<int> degree(b.graph->size(), 0);
  for (const auto& walls : b.graph->walls)
    for (const Wall& w : walls) ++degree[w.a], ++degree[w.b];
  CHECK(std::count(degree.begin(), degree.end(), 4) == 1);
}

TEST_CASE("contours that touch along an edge but for a hair are joined there; what is smaller keeps its shape") {
  Sections touching;
  touching.planes.push_back(plane_at({0, 0, 1}, {0, 0, 0}));
  add_contour(touching.planes[0], square(-1, 0, 0, 1), 0);
  add_contour(touching.planes[0], square(1 + 1e-10, 1, 0, 1), 1);
  const Built joined = build(touching);
  REQUIRE(joined.graph.ok());
  const auto is_joined = [&](const Wall& w) {  // from a corner of the one to a corner of the other
    const LatticePoint &a = joined.graph->points[w.a], &c = joined.graph->points[w.b];
    return a[0] != c[0] && a[1] != c[1];
  };
  const auto& joined_walls = joined.graph->walls[0];
  CHECK(std::count_if(joined_walls.begin(), joined_walls.end(), is_joined) == 2);

  Sections tiny = touching;
  add_contour(tiny.planes[0], polygon({0, 0, 1}, {-1, 0, 0}, 1e-9, 8), 2);
  const Built b = build(tiny);
  REQUIRE(b.graph.ok());
  CHECK(b.graph->walls[0].size() == 16);
}

TEST_CASE("contours with something finer between them are not joined") {
  constexpr double kStep = 3e-3;
  Sections s;
  s.planes.push_back(plane_at({0, 0, 1}, {0, 0, 0}));
  add_contour(s.planes[0], {{0, -5, 0}, {10, -5, 0}, {10, 0, 0}, {0, 0, 0}}, 0);
  add_contour(s.planes[0], {{5, 3 * kStep, 0}, {8, 5, 0}, {2, 5, 0}}, 1);
  CHECK(build(s, 2e-3, 1e-3).graph->walls[0].size() == 8);
  add_contour(s.planes[0], square(2.5, 1.5 * kStep, 0, 0.3 * kStep), 2);  // where the side would pass then
  const Built b = build(s, 2e-3, 1e-3);
  REQUIRE(b.graph.ok());
  CHECK(b.graph->size() == 11);
  CHECK(b.graph->walls[0].size() == 11);
}

TEST_CASE("contours that cross are named") {
  Sections s;
  PlaneSection plane = plane_at({0, 0, 1}, {0, 0, 0});
  add_contour(plane, square(0, 0, 0, 1), 0);
  add_contour(plane, square(0.7, 0.8, 0, 1), 1);
  s.planes = {plane_at({1, 0, 0}, {9, 0, 0}), plane};
  const Built b = build(s);
  REQUIRE_FALSE(b.graph.ok());
  CHECK(b.graph.error().code == ErrorCode::self_crossing);
  CHECK(b.graph.error().plane == 1);
  CHECK(b.graph.error().contour == 0);
  CHECK(b.graph.error().line != 0);
}

TEST_CASE("exactly collinear vertices stay, vertices bent by a hair go") {
  Sections s;
  PlaneSection exact = plane_at({0, 0, 1}, {0, 0, 0});
  add_contour(exact, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  s.planes = {exact};
  CHECK(build(s).graph->size() == 5);
  s.planes[0].vertices[1].y = 0x1p-47;
  const Built bent = build(s);
  CHECK(bent.graph->size() == 4);
  CHECK(bent.graph->statistics.merged_collinear == 1);
}

TEST_CASE("a triangle that matching has made thin keeps its third corner") {
  // Both ends of its long side meet crossings of upright sections, a lattice step or so below the corner
  // between them.
  constexpr double kHeight = 0x1p-12;
  Sections s;
  PlaneSection flat = plane_at({0, 0, 1}, {0, 0, 0});
  add_contour(flat, {{0, 0, 0}, {1, kHeight, 0}, {2, 0, 0}});
  s.planes = {flat};
  for (const double x : {0, 2}) {
    PlaneSection upright = plane_at({1, 0, 0}, {x, 0, 0});
    add_contour(upright, {{x, 2 * kHeight, -1}, {x, 1, -1}, {x, 1, 1}, {x, 2 * kHeight, 1}});
    s.planes.push_back(upright);
  }
  const double step = build(s).framed.grid.unit();
  s.planes[2].vertices[0].y -= 4 * step, s.planes[2].vertices[3].y -= 4 * step;
  const Built b = build(s);
  REQUIRE(b.graph.ok());
  CHECK(b.graph->statistics.matched == 4);
  CHECK(b.graph->statistics.merged_collinear == 0);
  std::vector<std::size_t> walls;
  for (const auto& list : b.graph->walls) walls.push_back(list.size());
  CHECK(*std::min_element(walls.begin(), walls.end()) == 3);
}

TEST_CASE("a straight side sampled finely goes to its corners, a shallow arc stays within the rounding") {
  const auto sampled = [](int count, double bend) {
    Sections s;
    s.planes.push_back(plane_at({0, 0, 1}, {0, 0, 0}));
    std::vector<Vec3> points{{0, 0, 0}};
    for (int i = 0; i < count; ++i) {
      const double t = static_cast<double>(i) / count, x = std::cos(0.3), y = std::sin(0.3);
      const double off = bend * t * (1 - t);
      points.push_back({2 * x - t * (x + y) - off * y, 2 * y + t * (x - y) + off * x, 0});
    }
    add_contour(s.planes[0], points);
    return s;
  };
  const Built straight = build(sampled(500, 0));
  REQUIRE(straight.graph.ok());
  CHECK(straight.graph->size() < 10);

  const Sections arc = sampled(500, 0x1p-40);
  const Built bent = build(arc);
  REQUIRE(bent.graph.ok());
  CHECK(bent.graph->size() < 250);
  double largest = 0;  // lattice units
  for (const LatticePoint& p : bent.framed.planes[0].vertices) {
    double nearest = INFINITY;
    for (const Wall& w : bent.graph->walls[0]) {
      const Vec3 a = real(bent.graph->points[w.a]), d = real(bent.graph->points[w.b]) - a, e = real(p) - a;
      const double t = std::clamp(dot(e, d) / dot(d, d), 0.0, 1.0);
      nearest = std::min(nearest, norm(e - t * d));
    }
    largest = std::max(largest, nearest);
  }
  CHECK(largest <= 3.1 * norm(real(make_point(bent.framed.planes[0].plane.e2))));
}
