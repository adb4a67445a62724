#include "../../arrangement/coincidences.h"

#include <doctest/doctest.h>

#include <random>

#include "polygon_sections.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

constexpr double kRadius = 1, kTolerance = 1e-9;

WantedPlane through(Vec3 normal, Vec3 point) {
  const Vec3 n = unit(normal);
  return {n, dot(n, point)};
}

}  // namespace

TEST_CASE("random planes share nothing") {
  std::mt19937_64 random(3);
  std::vector<WantedPlane> planes;
  for (int i = 0; i < 40; ++i) planes.push_back(through(random_vector(random), 0.5 * random_vector(random)));
  const Coincidences found = find_coincidences(planes, kRadius, kTolerance);
  CHECK(found.pencils.empty());
  CHECK(found.points.empty());
  const auto first = find_equal_planes(planes, kRadius, kTolerance);
  for (std::uint32_t i = 0; i < first.size(); ++i) CHECK(first[i] == i);
}

TEST_CASE("equal planes are found up to the tolerance, opposite ones too") {
  std::vector<WantedPlane> planes{{{0, 0, 1}, 0.5},
                                  {{1, 0, 0}, 0.5},
                                  {{0, 0, 1}, 0.5 + 4e-10},
                                  {{0, 0, 1}, 0.6},
                                  {{0, 0, -1}, -0.5},
                                  through({3e-10, 0, 1}, {0, 0, 0.6}),
                                  through({3e-9, 0, 1}, {0, 0, 0.6})};
  CHECK(find_equal_planes(planes, kRadius, kTolerance) == std::vector<std::uint32_t>{0, 1, 0, 3, 0, 3, 6});
}

TEST_CASE("planes turned about an axis are one pencil, and cutting it adds no common point") {
  std::mt19937_64 random(5);
  const Vec3 axis = unit(random_vector(random)), centre = 0.2 * random_vector(random);
  std::vector<WantedPlane> planes;
  for (int i = 0; i < 7; ++i) planes.push_back(through(cross(axis, random_vector(random)), centre));
  planes.push_back(through(random_vector(random), centre));
  planes.push_back(through(random_vector(random), {0.1, 0.1, 0.1}));
  const Coincidences found = find_coincidences(planes, kRadius, kTolerance);
  REQUIRE(found.pencils.size() == 1);
  CHECK(found.pencils[0].planes == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6});
  CHECK(norm(cross(found.pencils[0].direction, axis)) < 1e-9);
  CHECK(norm(cross(found.pencils[0].point - centre, axis)) < 1e-9);
  CHECK(found.points.empty());
}

TEST_CASE("planes through one point are one common point") {
  std::mt19937_64 random(7);
  const Vec3 centre{0.3, -0.2, 0.1};
  std::vector<WantedPlane> planes;
  for (int i = 0; i < 6; ++i)
    planes.push_back(through(random_vector(random), i == 2 ? Vec3{0.5, 0.5, 0.5} : centre));
  const Coincidences found = find_coincidences(planes, kRadius, kTolerance);
  CHECK(found.pencils.empty());
  REQUIRE(found.points.size() == 1);
  CHECK(found.points[0].planes == std::vector<std::uint32_t>{0, 1, 3, 4, 5});
  CHECK(norm(found.points[0].point - centre) < 1e-9);
}

TEST_CASE("a near miss and a coincidence far away do not count") {
  std::mt19937_64 random(9);
  std::vector<WantedPlane> near, far;
  for (int i = 0; i < 4; ++i) {
    const Vec3 n = random_vector(random);
    near.push_back(through(n, {0.1 + (i == 3 ? 1e-7 : 0), 0, 0}));
    far.push_back(through(n, {5, 5, 5}));
  }
  CHECK(find_coincidences(near, kRadius, kTolerance).points.empty());
  CHECK(find_coincidences(far, kRadius, kTolerance).points.empty());
}

TEST_CASE("two pencils whose axes cross share a point that does not follow from either") {
  const Vec3 centre{0.1, 0.2, 0.3};
  std::mt19937_64 random(11);
  std::vector<WantedPlane> planes;
  for (const Vec3 axis : {Vec3{1, 2, 3}, Vec3{-2, 1, 1}})
    for (int i = 0; i < 3; ++i) planes.push_back(through(cross(axis, random_vector(random)), centre));
  const Coincidences found = find_coincidences(planes, kRadius, kTolerance);
  CHECK(found.pencils.size() == 2);
  REQUIRE(found.points.size() == 1);
  CHECK(found.points[0].planes.size() == 6);
}
