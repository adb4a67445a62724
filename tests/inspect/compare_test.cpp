#include "../../inspect/compare.h"

#include <doctest/doctest.h>

#include <cmath>

#include "shapes.h"

using namespace crossloft;
using namespace crossloft::test;

TEST_CASE("a surface equals itself") {
  const Surface mesh = torus(1, 0.4, 80, 40);
  const CompareReport r = compare(mesh, mesh);
  CHECK(r.iou == 1);
  CHECK(r.hausdorff() < 1e-12);
  CHECK(r.mean() < 1e-12);
  CHECK(r.volume_a == r.volume_b);
  CHECK(r.genus_a == 1);
  CHECK(r.components_b == 1);
  CHECK(r.ray_volume_a == doctest::Approx(r.volume_a).epsilon(1e-4));
}

TEST_CASE("shifted cubes") {
  const CompareReport r = compare(cube(), moved(cube(), {0.5, 0, 0}));
  CHECK(r.intersection == doctest::Approx(0.5).epsilon(1e-2));
  CHECK(r.iou == doctest::Approx(1.0 / 3).epsilon(1e-2));
  CHECK(r.hausdorff() == doctest::Approx(0.5).epsilon(1e-6));
  const CompareReport up = compare(cube(), moved(cube(), {0, 0, 0.25}));
  CHECK(up.iou == doctest::Approx(0.6));  // exact: along the rays
  const CompareReport diagonal = compare(cube(), moved(cube(), {0.25, 0.25, 0.25}));
  CHECK(diagonal.intersection == doctest::Approx(0.421875).epsilon(1e-2));
  CHECK(diagonal.distance_ab == doctest::Approx(std::sqrt(3.0) / 4));
}

TEST_CASE("disjoint, nested and empty solids") {
  CHECK(compare(cube(), cube(2, 3)).iou == 0);
  const CompareReport nested = compare(cube(0, 4), cube(1, 3));
  CHECK(nested.iou == doctest::Approx(1.0 / 8).epsilon(1e-2));
  CHECK(nested.distance_ba == doctest::Approx(1));
  CHECK(nested.distance_ab == doctest::Approx(std::sqrt(3.0)));
  Surface shell = cube(0, 4);
  append(shell, inside_out(cube(1, 3)));
  const CompareReport hollow = compare(shell, cube(0, 4));
  CHECK(hollow.components_a == 2);
  CHECK(hollow.iou == doctest::Approx(56.0 / 64).epsilon(1e-2));
  const CompareReport none = compare(cube(), Surface{});
  CHECK(none.iou == 0);
  CHECK(std::isinf(none.distance_ab));
  CHECK(none.distance_ba == 0);
  CHECK(compare(Surface{}, Surface{}).iou == 1);
}

TEST_CASE("the orientation of the axes does not matter") {
  Surface a = torus(1, 0.4, 40, 20), b = moved(a, {0.1, 0.05, 0.02});
  const CompareReport r = compare(a, b);
  for (Surface* mesh : {&a, &b})
    for (Vec3& p : mesh->points) p = {p.y, p.z, p.x};
  const CompareReport turned = compare(a, b);
  CHECK(r.iou == doctest::Approx(turned.iou).epsilon(1e-9));
  CHECK(r.mean() == doctest::Approx(turned.mean()).epsilon(1e-9));
}

TEST_CASE("every vertex counts, also one that is no triangle's first") {
  Surface spiked = cube();
  append(spiked, tetrahedron({0.5, 0.5, 1}, {0.5 + 1e-6, 0.5, 1}, {0.5, 0.5 + 1e-6, 1}, {0.5, 0.5, 11}));
  const std::uint32_t tip = 11;
  for (auto& t : spiked.triangles)
    while (t[0] == tip) t = {t[1], t[2], t[0]};
  REQUIRE(spiked.points[tip].z == 11);
  CHECK(compare(cube(), spiked).hausdorff() == doctest::Approx(10));
  CHECK(compare(spiked, cube()).hausdorff() == doctest::Approx(10));
}

TEST_CASE("points of no triangle say nothing") {
  Surface mesh = cube();
  mesh.points.push_back({1e14, 0, 0});
  const CompareReport r = compare(mesh, moved(cube(), {0, 0, 0.25}));
  CHECK(r.diagonal < 3);
  CHECK(r.iou == doctest::Approx(0.6));
  CHECK(r.volume_a == 1);
}

TEST_CASE("sizes at which products of coordinates leave the range of doubles") {
  const Surface a = cube(), b = moved(cube(), {0, 0, 0.25});
  const CompareReport at_one = compare(a, b);
  for (const int exponent : {-1022, -560, -365, -200, 200, 260, 340, 530, 1021}) {
    CAPTURE(exponent);
    const CompareReport r = compare(scaled(a, exponent), scaled(b, exponent));
    CHECK(r.iou == at_one.iou);
    CHECK(r.hausdorff() == std::ldexp(at_one.hausdorff(), exponent));
    CHECK(r.diagonal == std::ldexp(at_one.diagonal, exponent));
    CHECK(r.mean_ab == std::ldexp(at_one.mean_ab, exponent));
    CHECK(r.volume_b == std::ldexp(at_one.volume_b, 3 * exponent));
  }
}

TEST_CASE("the distance to a triangle thinner than products can tell is that to its sides") {
  const Surface sliver = tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1e-161, 0}, {0, 0, 1e-161});
  const CompareReport r = compare(sliver, moved(sliver, {0, 0, 0.25}));
  CHECK(r.hausdorff() == doctest::Approx(0.25));
  CHECK(r.mean() == doctest::Approx(0.25));
}
