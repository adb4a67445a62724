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
