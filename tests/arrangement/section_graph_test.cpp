#include "../../arrangement/section_graph.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>

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

TEST_CASE("a contour through an arrangement vertex crosses both lines there") {
  Sections s = crossing_squares(1, 0);
  PlaneSection diagonal = plane_at({0, 1, 0}, {0, 1, 0});  // y = 1 through both squares' sides
  add_contour(diagonal, {{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}});
  s.planes.push_back(diagonal);
  const Built b = build(s);
  REQUIRE(b.graph.ok());
  const auto corner = std::find_if(b.graph->locations.begin(), b.graph->locations.end(),
                                   [](const Location& l) { return l.dimension == 0; });
  CHECK(corner != b.graph->locations.end());
}

TEST_CASE("an arrangement vertex inside the sections is a section vertex") {
  Sections s;
  for (const Vec3& n : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) s.planes.push_back(disk(n, {0, 0, 0}, 1, 16));
  const Built b = build(s);
  REQUIRE(b.graph.ok());
  CHECK(std::count_if(b.graph->locations.begin(), b.graph->locations.end(),
                      [](const Location& l) { return l.dimension == 0; }) == 1);
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
