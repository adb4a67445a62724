#include "../../delaunay/delaunay3.h"

#include <doctest/doctest.h>

#include <map>
#include <new>

#include "../../delaunay/lattice_predicates.h"
#include "../../delaunay/vec3_predicates.h"
#include "brute_force.h"
#include "point_sets.h"

using namespace crossloft;
using Tets = std::vector<std::array<std::uint32_t, 4>>;

namespace {

Tets tets_by_rank(const std::vector<LatticePoint>& points) {
  const LatticePredicates3 predicates(points);
  Delaunay3 triangulation(predicates);
  triangulation.build();
  CHECK(triangulation.verify() == "");
  return point_sets::by_rank(triangulation.tet_mesh().vertices, point_sets::ranks(points));
}

int dimension_of(const std::vector<LatticePoint>& points) {
  const LatticePredicates3 predicates(points);
  Delaunay3 triangulation(predicates);
  triangulation.build();
  CHECK(triangulation.verify() == "");
  CHECK((triangulation.dimension() == 3) == (triangulation.tet_mesh().size() > 0));
  return triangulation.dimension();
}

std::vector<LatticePoint> sorted_distinct(std::vector<LatticePoint> points) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return compare_lex(a, b) < 0; });
  points.erase(
      std::unique(points.begin(), points.end(), [](const auto& a, const auto& b) { return equal(a, b); }),
      points.end());
  return points;
}

void check_against_definition(const std::vector<LatticePoint>& points) {
  CHECK(tets_by_rank(points) == brute_force::Lifted<3>(sorted_distinct(points)).triangulate());
}

void check_order_independent(std::vector<LatticePoint> points) {
  const Tets tets = tets_by_rank(points);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    point_sets::shuffle(points, seed);
    CHECK(tets_by_rank(points) == tets);
  }
}

/// Knows the first `known` points only.
struct Growing : LatticePredicates3 {
  using LatticePredicates3::LatticePredicates3;
  std::uint32_t size() const { return known; }
  std::uint32_t known = 0;
};

/// Points from `first` on, added to a triangulation of the others.
void check_extend(const std::vector<LatticePoint>& points, std::uint32_t first) {
  Growing predicates(points);
  predicates.known = first;
  Delaunay3 triangulation(predicates);
  triangulation.build();
  predicates.known = static_cast<std::uint32_t>(points.size());
  triangulation.extend(first);
  CHECK(triangulation.verify() == "");
  CHECK(point_sets::by_rank(triangulation.tet_mesh().vertices, point_sets::ranks(points)) ==
        tets_by_rank(points));
}

/// Facets without a neighbour; each edge of them must be met once in each direction.
void check_hull_closed(const TetMesh& mesh) {
  std::map<std::array<std::uint32_t, 2>, int> edges;
  for (std::uint32_t t = 0; t < mesh.size(); ++t)
    for (std::size_t slot = 0; slot < 4; ++slot) {
      if (mesh.neighbours[t][slot] != kNone) continue;
      const auto& facet = kFacetSlots[slot];
      for (std::size_t k = 0; k < 3; ++k)
        ++edges[{mesh.vertices[t][facet[k]], mesh.vertices[t][facet[(k + 1) % 3]]}];
    }
  for (const auto& [edge, count] : edges) {
    CHECK(count == 1);
    CHECK(edges.count({edge[1], edge[0]}) == 1);
  }
}

}  // namespace

TEST_CASE("tetrahedra are those with empty perturbed spheres") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    check_against_definition(point_sets::random_cube(12, 1000, seed));
    check_against_definition(point_sets::random_cube(12, 3, seed));
    check_against_definition(point_sets::on_planes(2, 6, 4, 3, seed));
  }
  check_against_definition(point_sets::grid(2, 2, 3));
  check_against_definition(point_sets::sphere(2));
  check_against_definition(point_sets::sphere(3));
}

TEST_CASE("the triangulation is a function of the point set") {
  check_order_independent(point_sets::random_cube(400, std::int64_t{1} << 50, 1));
  check_order_independent(point_sets::random_cube(300, 6, 2));
  check_order_independent(point_sets::grid(5, 6, 4));
  check_order_independent(point_sets::sphere(81));
  check_order_independent(point_sets::on_planes(4, 80, 30, 7, 3));
  check_order_independent(point_sets::on_cube_faces(6, 3, 60, 4));
}

TEST_CASE("points added later give what all points at once give") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto points = point_sets::random_cube(200, 6, seed);
    for (const std::uint32_t first : {0u, 1u, 3u, 100u, 200u}) check_extend(points, first);
  }
}

TEST_CASE("a point that was left out is found by verify()") {
  const auto points = point_sets::random_cube(200, 1000, 3);
  Growing predicates(points);
  predicates.known = 100;
  Delaunay3 triangulation(predicates);
  triangulation.build();
  predicates.known = 200;
  triangulation.extend(150);  // against its contract
  CHECK(triangulation.verify() == "point 100 is no vertex");
}

TEST_CASE("more cells than can be numbered are a failed allocation") {
  detail::SimplexStore<3> cells;
  CHECK(cells.grow() == 0);
  CHECK_THROWS_AS(cells.grow_to(std::size_t{1} << 30, 1), std::bad_alloc);
  CHECK(cells.size() == 1);
}

TEST_CASE("a point whose cavity is all there is") {
  const auto check_centre = [](std::vector<LatticePoint> sphere) {
    const auto first = static_cast<std::uint32_t>(sphere.size());
    sphere.push_back(make_point({0, 0, 0}));
    check_extend(sphere, first);
  };
  const auto few = point_sets::sphere(81), many = point_sets::sphere(446);
  REQUIRE((few.size() > 100 && few.size() < 200));
  check_centre(few);
  REQUIRE(many.size() > 300);  // too many for the table of edges: new cells are found by turning
  check_centre(many);
}

TEST_CASE("a grid is filled by cubes of five or six tetrahedra") {
  const Tets tets = tets_by_rank(point_sets::grid(5, 5, 5));
  CHECK(tets.size() >= 5 * 64);
  CHECK(tets.size() <= 6 * 64);
}

TEST_CASE("hull facets close up, neighbours point back") {
  for (const auto& points : {point_sets::random_cube(200, 50, 5), point_sets::grid(4, 4, 4)}) {
    const LatticePredicates3 predicates(points);
    Delaunay3 triangulation(predicates);
    triangulation.build();
    const TetMesh mesh = triangulation.tet_mesh();
    check_hull_closed(mesh);
    for (std::uint32_t t = 0; t < mesh.size(); ++t)
      for (const std::uint32_t n : mesh.neighbours[t])
        if (n != kNone) CHECK(std::count(mesh.neighbours[n].begin(), mesh.neighbours[n].end(), t) == 1);
  }
}

TEST_CASE("less than three dimensions is no error") {
  CHECK(dimension_of({}) == -1);
  const LatticePoint p = make_point({3, 4, 5});
  CHECK(dimension_of({p}) == 0);
  CHECK(dimension_of({p, p, p}) == 0);
  CHECK(dimension_of({p, make_point({3, 4, 6})}) == 1);
  std::vector<LatticePoint> line, plane;
  for (std::int64_t k = 0; k < 20; ++k) line.push_back(make_point({k, 2 * k, -3 * k}));
  CHECK(dimension_of(line) == 1);
  for (std::int64_t k = 0; k < 50; ++k)
    plane.push_back(make_point({k * k % 7, k % 5, k * k % 7 + 2 * (k % 5)}));
  CHECK(dimension_of(plane) == 2);
  plane.push_back(make_point({1, 1, 1}));
  CHECK(dimension_of(plane) == 3);
}

TEST_CASE("the lowest index of equal points is the vertex") {
  std::vector<LatticePoint> points = point_sets::random_cube(300, 5, 6);
  const LatticePredicates3 predicates(points);
  Delaunay3 triangulation(predicates);
  triangulation.build();
  CHECK(triangulation.verify() == "");
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::uint32_t lowest = 0;
    while (!equal(points[lowest], points[i])) ++lowest;
    CHECK(triangulation.kept(i) == lowest);
  }
  for (const auto& tet : triangulation.tet_mesh().vertices)
    for (const std::uint32_t v : tet) CHECK(triangulation.kept(v) == v);
}

TEST_CASE("rational points: crossings of planes") {
  std::vector<LatticePlane> planes;
  std::mt19937_64 random(7);
  const auto draw = [&] { return static_cast<std::int64_t>(random() % 2001) - 1000; };
  while (planes.size() < 9) {
    const LatticePlane p =
        make_lattice_plane({draw(), draw(), draw()}, {draw(), draw(), draw()}, {draw(), draw(), draw()});
    if (p.normal != LatticeVector{0, 0, 0}) planes.push_back(p);
  }
  LatticePointStore store;
  std::vector<LatticePoint> points;
  for (std::size_t a = 0; a < planes.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      for (std::size_t c = 0; c < b; ++c) {
        LatticePoint p;
        if (store.meet(planes[a], planes[b], planes[c], p)) points.push_back(p);
      }
  REQUIRE(points.size() > 60);
  check_order_independent(points);
}

TEST_CASE("plain doubles give what lattice points of the same coordinates give") {
  for (const auto& points : {point_sets::random_cube(300, 1000, 8), point_sets::grid(4, 5, 3)}) {
    std::vector<Vec3> plain;
    for (const LatticePoint& p : points) plain.push_back({p.x * 0x1p-900, p.y * 0x1p-900, p.z * 0x1p-900});
    const Vec3Predicates3 predicates(plain);
    Delaunay3 triangulation(predicates);
    triangulation.build();
    CHECK(triangulation.verify() == "");
    CHECK(point_sets::by_rank(triangulation.tet_mesh().vertices, point_sets::ranks(points)) ==
          tets_by_rank(points));
  }
  const std::vector<Vec3> line = {{1, 1, 1}, {1e300, 1e300, 1e300}, {-1e-300, -1e-300, -1e-300}};
  CHECK(Vec3Predicates3(line).collinear(0, 1, 2));
}
