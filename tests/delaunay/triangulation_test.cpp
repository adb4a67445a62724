#include "../../delaunay/triangulation.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "../../bench/point_distributions.h"
#include "../../delaunay/delaunay3.h"
#include "../../delaunay/vec3_predicates.h"
#include "../../geom/predicates.h"

using namespace crossloft;

namespace {

Triangulation sorted_triangulation(const std::vector<Vec3>& points, unsigned threads) {
  Triangulation t = delaunay_triangulation(points, threads);
  sort_simplices(t);
  return t;
}

void check_same(const Triangulation& a, const Triangulation& b) {
  CHECK(a.kept == b.kept);
  CHECK(a.tets.vertices == b.tets.vertices);
  CHECK(a.tets.neighbours == b.tets.neighbours);
}

/// Any number of threads gives the same arrays as one.
void check_threads(const std::vector<Vec3>& points) {
  const Triangulation one = sorted_triangulation(points, 1);
  REQUIRE(one.dimension == 3);
  for (const unsigned threads : {2u, 3u, 5u}) check_same(sorted_triangulation(points, threads), one);
}

/// Sorted simplices are positive, ascend, and name each other across the facets that they share.
void check_sorted(const std::vector<Vec3>& points, const TetMesh& mesh) {
  CHECK(std::is_sorted(mesh.vertices.begin(), mesh.vertices.end()));
  for (std::uint32_t t = 0; t < mesh.size(); ++t) {
    const auto& v = mesh.vertices[t];
    CHECK(v[0] < v[1]);
    CHECK(v[1] < std::min(v[2], v[3]));
    CHECK(orient3d(points[v[0]], points[v[1]], points[v[2]], points[v[3]]) > 0);
    for (std::size_t slot = 0; slot < 4; ++slot) {
      const std::uint32_t n = mesh.neighbours[t][slot];
      if (n == kNone) continue;
      const auto& back = mesh.neighbours[n];
      const auto at = std::find(back.begin(), back.end(), t);
      REQUIRE(at != back.end());
      const std::uint32_t apex = mesh.vertices[n][static_cast<std::size_t>(at - back.begin())];
      CHECK(std::count(v.begin(), v.end(), apex) == 0);
    }
  }
}

}  // namespace

TEST_CASE("threads leave no trace: random points") { check_threads(bench::uniform_cube(120'000)); }

TEST_CASE("threads leave no trace: a grid, all cospherical, with duplicates") {
  std::vector<Vec3> points = bench::grid(40);
  for (std::size_t i = 0; i < 20'000; ++i) points.push_back(points[7 * i % 64'000]);
  bench::Draw(5).shuffle(points);
  check_threads(points);
}

TEST_CASE("threads leave no trace: a sphere, and curves on planes") {
  check_threads(bench::integer_sphere(60'000, 1e6));
  check_threads(bench::curves_on_planes(6, 2'000));
}

TEST_CASE("threads: the triangulation is sound") {
  const std::vector<Vec3> points = bench::uniform_cube(100'000);
  const Vec3Predicates3 predicates(points);
  Delaunay3 triangulation(predicates);
  triangulation.build_in_given_order(2);
  CHECK(triangulation.verify() == "");
}

TEST_CASE("the vertex is the lowest index of equal points, whatever the order of insertion") {
  std::vector<Vec3> points = bench::uniform_cube(3'000);
  for (std::size_t i = 0; i < 3'000; ++i) points.push_back(points[i]);
  bench::Draw(6).shuffle(points);
  const Triangulation t = sorted_triangulation(points, 1);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    CHECK(t.kept[i] <= i);
    CHECK(points[t.kept[i]] == points[i]);
    CHECK(t.kept[t.kept[i]] == t.kept[i]);
  }
  for (const auto& tet : t.tets.vertices)
    for (const std::uint32_t v : tet) CHECK(t.kept[v] == v);
}

TEST_CASE("sorted simplices are a function of the points") {
  const std::vector<Vec3> points = bench::grid(8);
  const Triangulation t = sorted_triangulation(points, 1);
  check_sorted(points, t.tets);
  const Vec3Predicates3 predicates(points);
  Delaunay3 other(predicates);
  other.build();
  Triangulation again{3, t.kept, other.tet_mesh(), {}, -1, {}};
  sort_simplices(again);
  check_same(again, t);
}

TEST_CASE("coordinates that are not finite have no triangulation") {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL})
    for (const std::size_t axis : {0u, 1u, 2u}) {
      std::vector<Vec3> points = bench::uniform_cube(50);
      (axis == 0 ? points[3].x : axis == 1 ? points[3].y : points[3].z) = bad;
      const Triangulation none = delaunay_triangulation(points);
      CHECK(none.dimension == -1);
      CHECK(none.tets.size() == 0);
      CHECK(none.kept == std::vector<std::uint32_t>(50, kNone));
      const std::vector<WeightedPoint> weighted{{points[3], 0}, {points[0], 0}}, heavy{{points[0], bad}};
      CHECK(regular_triangulation(weighted).dimension == -1);
      CHECK(regular_triangulation(heavy).dimension == -1);
    }
}

TEST_CASE("points of a plane or line get the triangulation of that plane or line") {
  CHECK(delaunay_triangulation({}).dimension == -1);
  const Triangulation one = delaunay_triangulation({{1, 2, 3}, {1, 2, 3}});
  CHECK(one.dimension == 0);
  CHECK(one.chain == std::vector<std::uint32_t>{0});
  const Triangulation line = delaunay_triangulation({{2, 2, 2}, {0, 0, 0}, {1, 1, 1}});
  CHECK(line.dimension == 1);
  CHECK(line.chain == std::vector<std::uint32_t>{1, 2, 0});
  std::vector<Vec3> plane = bench::grid(12);
  for (Vec3& p : plane) p.z = p.x + p.y;
  const Triangulation flat = delaunay_triangulation(plane);
  CHECK(flat.dimension == 2);
  CHECK(flat.triangles.size() == 2 * 11 * 11);
  CHECK(flat.tets.size() == 0);
}
