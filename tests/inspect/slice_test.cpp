#include "../../inspect/slice.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "../../inspect/random.h"
#include "shapes.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

/// Area enclosed by contours that don't touch, each counted by even-odd through its depth's sign: here only
/// for loops where the caller knows the nesting, as absolute values.
std::vector<double> loop_areas(const PlaneSection& s) {
  std::map<std::uint32_t, Vec3> twice;
  for (const ContourEdge& e : s.edges)
    twice[e.contour] =
        twice[e.contour] + cross(s.vertices[e.a] - s.vertices[0], s.vertices[e.b] - s.vertices[0]);
  std::vector<double> areas;
  for (const auto& [loop, a] : twice) areas.push_back(norm(a) / 2);
  std::sort(areas.begin(), areas.end());
  return areas;
}

void check_contours(const PlaneSection& s) {
  std::vector<int> degree(s.vertices.size(), 0);
  for (const ContourEdge& e : s.edges) {
    REQUIRE(e.a < s.vertices.size());
    REQUIRE(e.b < s.vertices.size());
    CHECK(s.vertices[e.a] != s.vertices[e.b]);
    ++degree[e.a];
    ++degree[e.b];
  }
  for (const int d : degree) {
    CHECK(d >= 2);
    CHECK(d % 2 == 0);
  }
}

double relative_height(const CuttingPlane& plane, const Vec3& p) {
  return std::abs(dot(plane.normal, p) + plane.offset) / norm(plane.normal);
}

/// Points of a section on another plane, to rounding.
std::vector<Vec3> points_on(const PlaneSection& s, const CuttingPlane& plane) {
  std::vector<Vec3> points;
  for (const Vec3& p : s.vertices)
    if (relative_height(plane, p) < 1e-12) points.push_back(p);
  std::sort(points.begin(), points.end());
  return points;
}

Sections sliced(const Surface& mesh, const std::vector<CuttingPlane>& planes) {
  Result<Sections> result = slice(mesh, planes);
  REQUIRE(result.ok());
  REQUIRE(result->planes.size() == planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    check_contours(result->planes[i]);
    for (const Vec3& p : result->planes[i].vertices) CHECK(relative_height(planes[i], p) < 5e-13);
  }
  return *result;
}

void check_consistent(const Surface& mesh, const std::vector<CuttingPlane>& planes) {
  const Sections s = sliced(mesh, planes);
  std::size_t common = 0;
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const std::vector<Vec3> a = points_on(s.planes[i], planes[j]), b = points_on(s.planes[j], planes[i]);
      CHECK(a == b);
      common += a.size();
    }
  CHECK(common > 0);
}

}  // namespace

TEST_CASE("sections of a torus: a ring, two disks, none") {
  const Surface mesh = torus(1, 0.4, 400, 200);
  const double pi = 3.14159265358979323846;
  const std::vector<CuttingPlane> planes{{{0, 0, 1}, -0.01}, {{0, 1, 0}, -0.001}, {{0, 0, 1}, -0.5}};
  const Sections s = sliced(mesh, planes);
  const double half = std::sqrt(0.16 - 1e-4);
  const std::vector<double> ring = loop_areas(s.planes[0]);
  REQUIRE(ring.size() == 2);
  CHECK(ring[1] - ring[0] == doctest::Approx(4 * pi * half).epsilon(1e-3));
  const std::vector<double> disks = loop_areas(s.planes[1]);
  REQUIRE(disks.size() == 2);
  CHECK(disks[0] == doctest::Approx(pi * 0.16).epsilon(1e-3));
  CHECK(disks[1] == doctest::Approx(pi * 0.16).epsilon(1e-3));
  CHECK(s.planes[2].edges.empty());
  CHECK(s.planes[2].vertices.empty());
}

TEST_CASE("planes exactly through vertices, edges and faces of a cube") {
  const Surface mesh = cube();
  const std::vector<CuttingPlane> planes{
      {{0, 0, 1}, 0},    // bottom face, solid above: the limit from below is empty
      {{0, 0, 1}, -1},   // top face, solid below: the whole face
      {{0, 0, -1}, 0},   // bottom face seen from the other side
      {{1, 1, 0}, 0},    // touches an edge
      {{1, -1, 0}, 0},   // through two edges and the diagonals of two faces
      {{1, 1, 1}, -3},   // touches a corner from outside
      {{1, 1, 1}, -1},   // through three corners
      {{1, 1, 1}, -1.5}  // a hexagon
  };
  const Sections s = sliced(mesh, planes);
  const auto area = [&](int i) {
    const std::vector<double> a = loop_areas(s.planes[static_cast<std::size_t>(i)]);
    return a.empty() ? 0.0 : a[0];
  };
  CHECK(s.planes[0].edges.empty());
  CHECK(area(1) == doctest::Approx(1));
  CHECK(area(2) == doctest::Approx(1));
  CHECK(s.planes[3].edges.empty());
  CHECK(area(4) == doctest::Approx(std::sqrt(2.0)));
  CHECK(s.planes[5].edges.empty());
  CHECK(area(6) == doctest::Approx(std::sqrt(3.0) / 2));
  CHECK(area(7) == doctest::Approx(std::sqrt(3.0) * 0.75));
}

TEST_CASE("planes through the mesh lines of a torus") {
  const Surface mesh = torus(1, 0.4, 80, 40);
  std::vector<CuttingPlane> planes{{{0, 0, 1}, 0},    {{0, 0, 1}, -0.4}, {{0, 0, 1}, 0.4}, {{1, 0, 0}, -0.6},
                                   {{1, 0, 0}, -1.4}, {{1, 0, 0}, 1.4},  {{1, -1, 0}, 0}};
  const Sections s = sliced(mesh, planes);
  CHECK(loop_areas(s.planes[0]).size() == 2);
  CHECK(loop_areas(s.planes[6]).size() == 2);
  planes.erase(planes.begin() + 1, planes.begin() + 6);  // touching planes have no contour of their own there
  check_consistent(mesh, planes);
}

TEST_CASE("sections agree bit by bit on the common lines") {
  const Surface mesh = torus(1, 0.4, 80, 40);
  const Bounds box = bounds_of(mesh.points);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) check_consistent(mesh, random_planes(box, 10, seed));
  check_consistent(mesh, rotational_planes(box, 9, {1, 0.2, 0.1}));
  std::vector<CuttingPlane> grid = parallel_planes(box, 5);
  for (const Vec3& n : {Vec3{1, 0, 0}, Vec3{0, 1, 0}})
    for (const CuttingPlane& p : parallel_planes(box, 5, n)) grid.push_back(p);
  check_consistent(mesh, grid);
  check_consistent(cube(), rotational_planes(bounds_of(cube().points), 8));
}

TEST_CASE("planes through three mesh vertices each: consistent, no twins, no crossing pieces of a hair") {
  const Surface mesh = torus(1, 0.4, 80, 40);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const auto vertex = [&] { return mesh.points[random.next() % mesh.points.size()]; };
    std::vector<CuttingPlane> planes;
    while (planes.size() < 12) {
      const Vec3 a = vertex(), b = vertex(), c = vertex(), n = cross(b - a, c - a);
      if (norm(n) > 0.01) planes.push_back({n, -dot(n, a)});
    }
    check_consistent(mesh, planes);
    for (const PlaneSection& s : sliced(mesh, planes).planes)
      for (const ContourEdge& e : s.edges) CHECK(norm(s.vertices[e.a] - s.vertices[e.b]) > 1e-12);
  }
}

TEST_CASE("equal planes give equal sections") {
  const Surface mesh = torus(1, 0.4, 30, 20);
  const CuttingPlane plane{{0.3, 0.2, 1}, 0.05};
  const Sections s = sliced(mesh, {plane, plane});
  CHECK(s.planes[0].vertices == s.planes[1].vertices);
}

TEST_CASE("a contour that touches itself is cut into loops") {
  Surface two = cube(0, 1);
  append(two, cube(1, 2));
  const Sections s = sliced(welded(two), {{{0, 0, 1}, -1}});
  REQUIRE(s.planes[0].edges.size() >= 4);
  CHECK(loop_areas(s.planes[0]).size() == 1);  // only the lower cube lies below z = 1
}

TEST_CASE("what bounds no solid is refused") {
  Surface open = cube();
  open.triangles.pop_back();
  const std::vector<CuttingPlane> plane{{{0, 0, 1}, -0.5}}, zero{{{0, 0, 1}, -0.5}, {{0, 0, 0}, 1}};
  REQUIRE_FALSE(slice(open, plane).ok());
  CHECK(slice(open, plane).error().code == ErrorCode::not_closed);
  REQUIRE_FALSE(slice(cube(), zero).ok());
  CHECK(slice(cube(), zero).error().code == ErrorCode::zero_normal);
  CHECK(slice(cube(), zero).error().plane == 1);
  CHECK(slice(cube(), {}).error().code == ErrorCode::no_plane);
  open.triangles.push_back({0, 1, 77});
  CHECK(slice(open, plane).error().code == ErrorCode::index_out_of_range);
  open = cube();
  open.points[0].x = std::nan("");
  CHECK(slice(open, plane).error().code == ErrorCode::not_finite);
}

TEST_CASE("points of no triangle say nothing") {
  Surface mesh = cube();
  mesh.points.push_back({1e14, 0, 0});
  const std::vector<CuttingPlane> plane{{{0, 0, 1}, -0.5}};
  CHECK(sliced(mesh, plane).planes[0].vertices == sliced(cube(), plane).planes[0].vertices);
  mesh.points.back() = {1e300, 0, 0};
  CHECK(slice(scaled(mesh, -1000), plane).ok());
}

TEST_CASE("sections at any size are those at size 1, scaled") {
  const Surface mesh = torus(1, 0.4, 40, 20);
  const std::vector<CuttingPlane> planes = random_planes(bounds_of(mesh.points), 12, 3);
  const Sections at_one = sliced(mesh, planes);
  for (const int exponent : {-960, -700, -530, 530, 700, 1000}) {
    CAPTURE(exponent);
    std::vector<CuttingPlane> scaled_planes = planes;
    for (CuttingPlane& plane : scaled_planes) plane.offset = std::ldexp(plane.offset, exponent);
    const auto s = slice(scaled(mesh, exponent), scaled_planes);
    REQUIRE(s.ok());
    for (std::size_t i = 0; i < planes.size(); ++i) {
      std::vector<Vec3> expected;
      for (const Vec3& v : at_one.planes[i].vertices) expected.push_back(scaled(v, exponent));
      CHECK(s->planes[i].vertices == expected);
      CHECK(s->planes[i].edges.size() == at_one.planes[i].edges.size());
    }
  }
}

TEST_CASE("a plane much further off than the mesh is large meets nothing, whatever its offset") {
  const std::vector<CuttingPlane> planes{{{0, 0, 1}, 1e300}, {{1, 1, 1}, -1e300}, {{1e-300, 0, 0}, 1e300}};
  const auto s = slice(scaled(cube(), -1000), planes);
  REQUIRE(s.ok());
  for (const PlaneSection& section : s->planes) CHECK(section.edges.empty());
}

TEST_CASE("plane sets are as described") {
  const Bounds box = bounds_of(cube(-1, 1).points);
  const std::vector<CuttingPlane> parallel = parallel_planes(box, 4);
  CHECK(parallel[0].offset == 0.75);
  CHECK(parallel[3].offset == -0.75);
  for (const CuttingPlane& p : random_planes(box, 50, 7)) {
    CHECK(norm(p.normal) == doctest::Approx(1));
    CHECK(std::abs(p.offset) <= 0.6 * std::sqrt(3.0) + 1e-12);
  }
  for (const CuttingPlane& p : rotational_planes(box, 7)) {
    CHECK(p.normal.z == 0);
    CHECK(p.offset == 0);
  }
  CHECK(fan_planes(box, 11, 1).size() == 11);
  CHECK(random_planes(box, 3, 1)[2].offset == random_planes(box, 5, 1)[2].offset);
  CHECK(random_planes(Bounds{}, 3, 1).empty());
}

TEST_CASE("directions may have any length") {
  const Bounds box = bounds_of(cube(-1, 1).points);
  for (const double length : {1e-300, 0x1p-1074, 1e300}) {
    const Vec3 x{length, 0, 0};
    CHECK(norm(parallel_planes(box, 4, x)[0].normal - Vec3{1, 0, 0}) < 1e-15);
    CHECK(norm(rotational_planes(box, 7, x)[3].normal - rotational_planes(box, 7, {1, 0, 0})[3].normal) <
          1e-15);
  }
}

TEST_CASE("of an empty mesh there is nothing to cut") {
  CHECK(slice({}, {}).error().message == "the mesh has no triangle to be cut");
}
