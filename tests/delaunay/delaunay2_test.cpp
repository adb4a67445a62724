#include "../../delaunay/delaunay2.h"

#include <doctest/doctest.h>

#include "../../delaunay/delaunay3.h"
#include "../../delaunay/lattice_predicates.h"
#include "brute_force.h"
#include "point_sets.h"

using namespace crossloft;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

namespace {

const LatticePlane kFloor = make_axis_plane(2, 0);

std::vector<LatticePoint> flattened(std::vector<LatticePoint> points) {
  for (LatticePoint& p : points) p.z = 0;
  return points;
}

Triangles triangles_by_rank(const LatticePlane& plane, const std::vector<LatticePoint>& points) {
  const LatticePredicates2 predicates(plane, points);
  Delaunay2 triangulation(predicates);
  triangulation.build();
  CHECK(triangulation.verify() == "");
  return point_sets::by_rank(triangulation.tri_mesh().vertices, point_sets::ranks(points));
}

std::vector<LatticePoint> sorted_distinct(std::vector<LatticePoint> points) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return compare_lex(a, b) < 0; });
  points.erase(
      std::unique(points.begin(), points.end(), [](const auto& a, const auto& b) { return equal(a, b); }),
      points.end());
  return points;
}

void check_against_definition(const std::vector<LatticePoint>& points) {
  CHECK(triangles_by_rank(kFloor, points) == brute_force::Lifted<2>(sorted_distinct(points)).triangulate());
}

/// Hull facets of the tetrahedra whose three vertices are on the plane, by the ranks of `points`.
Triangles hull_triangles(const TetMesh& mesh, const LatticePlane& plane,
                         const std::vector<LatticePoint>& points, const std::vector<std::uint32_t>& rank) {
  Triangles found;
  for (std::uint32_t t = 0; t < mesh.size(); ++t)
    for (std::size_t slot = 0; slot < 4; ++slot) {
      if (mesh.neighbours[t][slot] != kNone) continue;
      std::array<std::uint32_t, 3> facet{};
      for (std::size_t k = 0; k < 3; ++k) facet[k] = mesh.vertices[t][kFacetSlots[slot][k]];
      if (std::all_of(facet.begin(), facet.end(),
                      [&](auto v) { return side_of_plane(plane, points[v]) == 0; }))
        found.push_back(facet);
    }
  return point_sets::by_rank(found, rank);
}

/// The planar triangulation of the points on each plane is what the triangulation in space has there.
void check_hull(const std::vector<LatticePoint>& points, const std::vector<LatticePlane>& planes) {
  const LatticePredicates3 predicates(points);
  Delaunay3 triangulation(predicates);
  triangulation.build();
  const TetMesh mesh = triangulation.tet_mesh();
  const std::vector<std::uint32_t> rank = point_sets::ranks(points);
  for (const LatticePlane& plane : planes) {
    std::vector<LatticePoint> face;
    std::vector<std::uint32_t> face_rank;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      if (side_of_plane(plane, points[i]) != 0) continue;
      face.push_back(points[i]);
      face_rank.push_back(rank[i]);
    }
    const LatticePredicates2 face_predicates(plane, face);
    Delaunay2 planar(face_predicates);
    planar.build();
    CHECK(planar.verify() == "");
    CHECK(planar.tri_mesh().size() > 0);
    CHECK(point_sets::by_rank(planar.tri_mesh().vertices, face_rank) ==
          hull_triangles(mesh, plane, points, rank));
  }
}

std::vector<LatticePlane> cube_planes(std::int64_t half) {
  std::vector<LatticePlane> planes;
  for (int axis = 0; axis < 3; ++axis)
    for (const std::int64_t value : {-half, half}) planes.push_back(make_axis_plane(axis, value));
  return planes;
}

std::vector<LatticePlane> octahedron_planes(std::int64_t h) {
  std::vector<LatticePlane> planes;
  for (const std::int64_t x : {-1, 1})
    for (const std::int64_t y : {-1, 1})
      for (const std::int64_t z : {-1, 1})
        planes.push_back(make_lattice_plane({x * h, 0, 0}, {-x, y, 0}, {-x, 0, z}));
  return planes;
}

}  // namespace

TEST_CASE("triangles are those with empty perturbed circles") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    check_against_definition(flattened(point_sets::random_cube(20, 1000, seed)));
    check_against_definition(flattened(point_sets::random_cube(20, 4, seed)));
  }
  check_against_definition(point_sets::grid(4, 5, 1));
  check_against_definition(flattened(point_sets::sphere(25)));
}

TEST_CASE("the triangulation is a function of the point set, and of the side it is seen from") {
  for (std::vector<LatticePoint> points :
       {flattened(point_sets::random_cube(500, std::int64_t{1} << 50, 1)), point_sets::grid(12, 9, 1)}) {
    const Triangles triangles = triangles_by_rank(kFloor, points);
    CHECK(triangles_by_rank(make_lattice_plane({0, 0, 0}, {0, 1, 0}, {1, 0, 0}), points) == triangles);
    point_sets::shuffle(points, 2);
    CHECK(triangles_by_rank(kFloor, points) == triangles);
  }
}

TEST_CASE("points added one by one give the same triangles") {
  const std::vector<LatticePoint> all = flattened(point_sets::random_cube(200, 20, 3));
  std::vector<LatticePoint> points(all.begin(), all.begin() + 50);
  const LatticePredicates2 predicates(kFloor, points);
  Delaunay2 triangulation(predicates);
  triangulation.build();
  for (std::uint32_t i = 50; i < all.size(); ++i) {
    points.push_back(all[i]);
    std::uint32_t lowest = 0;
    while (!equal(points[lowest], points[i])) ++lowest;
    CHECK(triangulation.insert(i, i % 3 ? i / 2 : kNone) == lowest);
    CHECK(triangulation.kept(i) == lowest);
    for (const auto& [a, b] : triangulation.removed_edges()) CHECK_FALSE(triangulation.has_edge(a, b));
  }
  CHECK(triangulation.verify() == "");
  CHECK(point_sets::by_rank(triangulation.tri_mesh().vertices, point_sets::ranks(points)) ==
        triangles_by_rank(kFloor, points));
}

TEST_CASE("a search starts at the vertex that stands for a point, also if build() renamed it") {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    CAPTURE(seed);
    const std::vector<LatticePoint> all = flattened(point_sets::random_cube(120, 12, seed));
    std::vector<LatticePoint> points(all.begin(), all.begin() + 60);
    const LatticePredicates2 predicates(kFloor, points);
    Delaunay2 triangulation(predicates);
    triangulation.build();
    for (std::uint32_t i = 60; i < all.size(); ++i) {
      points.push_back(all[i]);
      triangulation.insert(i, i * 7 % 60);
    }
    CHECK(triangulation.verify() == "");
  }
}

TEST_CASE("edges are found from either end, and only those") {
  std::vector<LatticePoint> points = flattened(point_sets::random_cube(60, 30, 4));
  points.insert(points.end(), points.begin(), points.begin() + 10);  // these stand for the first ones
  const LatticePredicates2 predicates(kFloor, points);
  Delaunay2 triangulation(predicates);
  triangulation.build();
  std::vector<std::vector<bool>> is_edge(points.size(), std::vector<bool>(points.size()));
  for (const auto& t : triangulation.tri_mesh().vertices)
    for (std::size_t k = 0; k < 3; ++k) is_edge[t[k]][t[(k + 1) % 3]] = is_edge[t[(k + 1) % 3]][t[k]] = true;
  for (std::uint32_t a = 0; a < points.size(); ++a)
    for (std::uint32_t b = 0; b < points.size(); ++b)
      CHECK(triangulation.has_edge(a, b) == is_edge[triangulation.kept(a)][triangulation.kept(b)]);
}

TEST_CASE("collinear points have edges but no triangles, until a point off the line comes") {
  std::vector<LatticePoint> points;
  for (const std::int64_t k : {5, 0, 3, 9, 7}) points.push_back(make_point({k, 2 * k, 0}));
  const LatticePredicates2 predicates(kFloor, points);
  Delaunay2 triangulation(predicates);
  CHECK(triangulation.dimension() == -1);
  triangulation.build();
  CHECK(triangulation.dimension() == 1);
  CHECK(triangulation.tri_mesh().size() == 0);
  CHECK(triangulation.verify() == "");
  CHECK(triangulation.has_edge(1, 2));
  CHECK(triangulation.has_edge(4, 0));
  CHECK_FALSE(triangulation.has_edge(0, 1));
  points.push_back(make_point({1, 1, 0}));
  CHECK(triangulation.insert(5) == 5);
  CHECK(triangulation.dimension() == 2);
  CHECK(triangulation.tri_mesh().size() == 4);
  CHECK(triangulation.verify() == "");
  CHECK(triangulation.has_edge(1, 2));
  CHECK_FALSE(triangulation.has_edge(0, 1));
}

TEST_CASE("planar triangulations are the hull of the triangulation in space") {
  check_hull(point_sets::on_cube_faces(4, 1, 0, 1), cube_planes(4));
  check_hull(point_sets::on_cube_faces(6, 3, 200, 2), cube_planes(6));
  check_hull(point_sets::on_cube_faces(std::int64_t{1} << 49, std::int64_t{1} << 48, 200, 3),
             cube_planes(std::int64_t{1} << 49));
  check_hull(point_sets::on_octahedron(8, 150, 4), octahedron_planes(8));
  check_hull(point_sets::on_octahedron(std::int64_t{1} << 45, 200, 5),
             octahedron_planes(std::int64_t{1} << 45));
}
