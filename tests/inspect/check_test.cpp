#include "../../inspect/check.h"

#include <doctest/doctest.h>

#include <cmath>

#include "../../geom/triangle_meeting.h"
#include "../../inspect/random.h"
#include "shapes.h"

using namespace crossloft;
using namespace crossloft::test;

TEST_CASE("a cube is a sphere of volume 1") {
  const CheckReport r = check_surface(cube());
  CHECK(r.good_topology());
  REQUIRE(r.components.size() == 1);
  CHECK(r.components[0].euler == 2);
  CHECK(r.genus == 0);
  CHECK(r.volume == 1);
  CHECK(r.area == 6);
  CHECK(r.crossings == 0);
  CHECK(r.overlaps == 0);
  CHECK(r.inverted == 0);
}

TEST_CASE("a torus has genus 1 and loses no volume far from the origin") {
  const Surface mesh = torus(1, 0.4, 80, 40);
  const CheckReport r = check_surface(mesh), far = check_surface(moved(mesh, {1e8, -1e8, 1e8}));
  CHECK(r.good_topology());
  CHECK(r.genus == 1);
  CHECK(r.volume == doctest::Approx(2 * 9.8696044 * 0.16).epsilon(0.01));
  CHECK(r.crossings == 0);
  CHECK(far.volume == doctest::Approx(r.volume).epsilon(1e-6));
}

TEST_CASE("an open surface is found") {
  Surface mesh = cube();
  mesh.triangles.pop_back();
  const CheckReport r = check_surface(mesh);
  CHECK(r.open_edges == 3);
  CHECK_FALSE(r.closed());
  CHECK(r.nonmanifold_vertices == 0);
  CHECK_FALSE(r.components[0].manifold);
}

TEST_CASE("one turned triangle turns three edges; a turned mesh is inverted") {
  Surface mesh = cube();
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  CHECK(check_surface(mesh).misoriented_edges == 3);
  CHECK_FALSE(check_surface(mesh).good_topology());
  const CheckReport r = check_surface(inside_out(cube()));
  CHECK(r.good_topology());
  CHECK(r.volume == -1);
  CHECK(r.inverted == 1);
  CHECK(r.cavities == 0);
}

TEST_CASE("tetrahedra that share a vertex or an edge: by index singular, by copies two good components") {
  const Vec3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  Surface at_vertex = tetrahedron(o, x, y, z);
  append(at_vertex, tetrahedron(o, -y, -x, -z));
  Surface at_edge = tetrahedron(o, x, y, z);
  append(at_edge, tetrahedron(o, -x, -y, z));
  for (const Surface* mesh : {&at_vertex, &at_edge}) {
    const CheckReport r = check_surface(*mesh);
    CHECK(r.good_topology());
    CHECK(r.components.size() == 2);
    CHECK(r.crossings == 0);
    CHECK(r.inverted == 0);
  }
  const CheckReport vertex = check_surface(welded(at_vertex)), edge = check_surface(welded(at_edge));
  CHECK(vertex.closed());
  CHECK(vertex.nonmanifold_vertices == 1);
  CHECK(vertex.components.size() == 1);
  CHECK_FALSE(vertex.manifold());
  CHECK(edge.crowded_edges == 1);
  CHECK(edge.nonmanifold_vertices == 2);
  CHECK_FALSE(edge.closed());
}

TEST_CASE("cubes that pass through each other cross, though all lines of that run from edge to edge") {
  Surface mesh = cube();
  append(mesh, moved(cube(), {0.5, 0.5, 0.5}));
  const CheckReport r = check_surface(mesh);
  CHECK(r.good_topology());
  CHECK(r.crossings > 0);
  CHECK(r.overlaps == 0);
}

TEST_CASE("a cube in the place of another overlaps it and crosses nothing") {
  Surface mesh = cube();
  append(mesh, cube());
  const CheckReport r = check_surface(mesh);
  CHECK(r.overlaps == 12);
  CHECK(r.crossings == 0);
}

TEST_CASE("a body within a body is inside out; nothing is that is open or as thin as rounding") {
  Surface mesh = cube(0, 10);
  append(mesh, cube(2, 8));
  CHECK(check_surface(mesh).inverted == 1);
  mesh = inside_out(cube());
  append(mesh, moved(cube(), {2, 0, 0}));
  CHECK(check_surface(mesh).inverted == 1);
  mesh.triangles.pop_back();
  CHECK(check_surface(mesh).inverted == 0);
  const auto turned = [](double height) {
    return inside_out(tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, height}));
  };
  CHECK(check_surface(turned(1e-12)).inverted == 1);
  CHECK(check_surface(turned(1e-17)).inverted == 0);
}

TEST_CASE("a turned component inside another is a cavity, a further one inside it is not") {
  Surface mesh = cube(0, 10);
  append(mesh, inside_out(cube(2, 8)));
  CHECK(check_surface(mesh).cavities == 1);
  CHECK(check_surface(mesh).inverted == 0);
  append(mesh, cube(4, 6));
  append(mesh, cube(20, 21));
  const CheckReport r = check_surface(mesh);
  REQUIRE(r.components.size() == 4);
  CHECK(r.components[1].depth == 1);
  CHECK(r.components[2].depth == 2);
  CHECK(r.components[3].depth == 0);
  CHECK(r.cavities == 1);
  CHECK(r.inverted == 0);
  CHECK(r.volume == doctest::Approx(1000 - 216 + 8 + 1));
}

TEST_CASE("a component that another touches just where its ray would start") {
  Surface mesh = tetrahedron({-0.1, 1, 1}, {0, 0, 0}, {0, 3, 0}, {0, 0, 3});
  append(mesh, tetrahedron({0, 1, 1}, {4, -2, -2}, {4, 6, -2}, {4, 1, 6}));  // at the centroid of the largest
  const CheckReport r = check_surface(mesh);
  CHECK(r.good_topology());
  CHECK(r.crossings + r.overlaps == 0);
  CHECK(r.components[0].depth == 0);
  CHECK(r.components[0].depth_known);
  CHECK(r.inverted == 0);
  CHECK(r.cavities == 0);
}

TEST_CASE("of components that cover each other all over no depth is known") {
  for (const Vec3& by : {Vec3{0, 0, 0}, Vec3{0.1, 0.7, -0.3}}) {  // inner points are rounded off the faces
    const Surface turned = inside_out(moved(cube(0, 0.7), by));
    Surface mesh = moved(cube(0, 0.7), by);
    append(mesh, turned);
    const CheckReport r = check_surface(mesh);
    CHECK(r.unknown_depths == 2);
    CHECK(r.inverted == 0);
    CHECK_FALSE(r.components[0].depth_known);
  }
  const auto slanted = [] { return tetrahedron({0.1, 0, 0}, {1, 0.3, 0.1}, {0, 1.1, 0.7}, {0.3, 0.2, 1.3}); };
  Surface mesh = slanted();
  append(mesh, slanted());
  CHECK(check_surface(mesh).unknown_depths == 2);
}

TEST_CASE("inside out at any size, also where volumes are infinite or 0") {
  Surface mesh = cube(0, 10);
  append(mesh, inside_out(cube(2, 8)));
  append(mesh, cube(3, 7));
  append(mesh, inside_out(cube(20, 21)));
  for (const int exponent : {-900, -560, -370, -300, 0, 300, 345, 520, 1000}) {
    CAPTURE(exponent);
    const CheckReport r = check_surface(scaled(mesh, exponent));
    CHECK(r.cavities == 1);
    CHECK(r.inverted == 1);
    CHECK(r.components[3].inverted());
    CHECK(r.unknown_depths == 0);
    CHECK(r.components[1].volume == std::ldexp(-216.0, 3 * exponent));
  }
  append(mesh, inside_out(cube(30, 30 + 1e-9)));
  for (Vec3& p : mesh.points) p = p - Vec3{30, 30, 30};
  for (std::size_t k = mesh.points.size() - 8; k < mesh.points.size(); ++k)
    mesh.points[k] = 1e-160 * mesh.points[k];
  CHECK(check_surface(mesh).inverted == 2);  // beside the others as small as that
}

TEST_CASE("degenerate and impossible triangles are counted and left out") {
  Surface mesh = cube();
  mesh.points.push_back(mesh.points[0]);
  mesh.points.push_back({2, 0, 0});
  mesh.points.push_back({9, 9, 9});
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back({0, 1, 99});
  mesh.triangles.push_back({0, 8, 3});
  mesh.triangles.push_back({0, 1, 9});
  const CheckReport r = check_surface(mesh);
  CHECK(r.repeated_indices == 1);
  CHECK(r.bad_indices == 1);
  CHECK(r.repeated_points == 1);
  CHECK(r.flat_triangles == 1);
  CHECK(r.unused_points == 1);
  mesh.points[5].x = std::nan("");
  CHECK(check_surface(mesh).bad_coordinates == 1);
  CHECK(check_surface(Surface{}).good_topology());
}

TEST_CASE("all pairs of random soups, on coarse grids for coincidences, as by brute force") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const int grid = seed % 3 == 0 ? 3 : seed % 3 == 1 ? 10 : 1 << 20;
    const auto coordinate = [&] {
      return static_cast<double>(random.next() % static_cast<unsigned>(grid)) / grid;
    };
    Surface soup;
    for (std::uint32_t t = 0; t < 100; ++t) {
      const Vec3 base{4 * coordinate(), 4 * coordinate(), 4 * coordinate()};
      for (int k = 0; k < 3; ++k)
        soup.points.push_back(base + Vec3{coordinate(), coordinate(), coordinate()});
      soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    std::uint64_t crossings = 0, overlaps = 0;
    for (std::uint32_t i = 0; i < 100; ++i)
      for (std::uint32_t j = 0; j < i; ++j) {
        const auto corners = [&](std::uint32_t t) {
          return Corners{soup.points[3 * t], soup.points[3 * t + 1], soup.points[3 * t + 2]};
        };
        crossings += meeting(corners(j), corners(i)) == Meeting::crossing;
        overlaps += meeting(corners(j), corners(i)) == Meeting::overlap;
      }
    const CheckReport r = check_surface(soup);
    CHECK(r.crossings == crossings);
    CHECK(r.overlaps == overlaps);
    CHECK(r.crossing_pairs.size() == std::min<std::size_t>(crossings, 16));
  }
}
