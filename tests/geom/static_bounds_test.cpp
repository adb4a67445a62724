// Static bounds, residues and small integers: the answers with bounds are those of the predicates without,
// and of rationals, on sets where every stage decides.

#include "../../geom/static_bounds.h"

#include <doctest/doctest.h>

#include <limits>
#include <vector>

#include "lattice_samples.h"
#include "random_doubles.h"
#include "rational_reference.h"

using namespace crossloft;
using reference::exact;

namespace {

constexpr std::uint64_t kSeed = 20261126;

/// Random tuples of a set, with its bounds and without, against rationals.
template <class Point>
void check_set(const std::vector<Point>& points, int rounds, Doubles& doubles) {
  const StaticBounds bounds = static_bounds(std::span<const Point>(points));
  for (int round = 0; round < rounds; ++round) {
    const auto any = [&] { return points[doubles.index(points.size())]; };
    const Point a = any(), b = any(), c = any(), d = any(), e = any();
    const int o = reference::orient3d(exact(a), exact(b), exact(c), exact(d));
    CHECK(orient3d(bounds, a, b, c, d) == o);
    CHECK(orient3d(a, b, c, d) == o);
    const int s = reference::insphere(exact(a), exact(b), exact(c), exact(d), exact(e));
    CHECK(insphere(bounds, a, b, c, d, e) == s);
    CHECK(insphere(a, b, c, d, e) == s);
  }
}

std::vector<LatticePoint> lattice(const std::vector<Vec3>& points) {
  std::vector<LatticePoint> r;
  for (const Vec3& p : points)
    r.push_back(make_point(
        {static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y), static_cast<std::int64_t>(p.z)}));
  return r;
}

/// Coordinates 0 and within one of +-limit: the largest determinants and the smallest.
std::vector<Vec3> corners(double limit) {
  std::vector<Vec3> points;
  const double pool[] = {0, 1, limit - 1, limit, limit + 1, -limit, -limit + 1};
  for (const double x : pool)
    for (const double y : pool)
      for (const double z : pool) points.push_back({x, y, z});
  return points;
}

std::vector<Vec3> scaled(std::vector<Vec3> points, double factor) {
  for (Vec3& p : points) p = factor * p;
  return points;
}

}  // namespace

TEST_CASE("integers around every power of two") {
  MESSAGE("seed " << kSeed);
  Doubles doubles(kSeed);
  for (int k = 1; k <= 55; ++k) {
    CAPTURE(k);
    const std::vector<Vec3> points = corners(std::ldexp(1, k));
    check_set(points, 60, doubles);
    if (k < 50) check_set(lattice(points), 60, doubles);
    check_set(scaled(points, 0x1p-70), 20, doubles);
    check_set(scaled(points, 0.1), 20, doubles);  // no longer integers, nor of a common power of two
  }
}

TEST_CASE("cospherical integers, moved by one or not") {
  Doubles doubles(kSeed + 1);
  for (const std::int64_t scale :
       {std::int64_t{1}, std::int64_t{1} << 11, std::int64_t{1} << 25, (std::int64_t{1} << 39) + 1}) {
    const std::vector<LatticePoint> sphere = samples::cospherical({5, -7, 11}, scale);
    std::vector<Vec3> points;
    for (const LatticePoint& p : sphere) points.push_back({p.x, p.y, p.z});
    check_set(points, 200, doubles);
    check_set(sphere, 200, doubles);
    for (Vec3& p : points) p.x += static_cast<double>(doubles.index(2));
    check_set(points, 200, doubles);
    check_set(lattice(points), 200, doubles);
    check_set(scaled(points, 0x1p-90), 50, doubles);
  }
}

TEST_CASE("a small grid: evaluated exactly, at any power of two") {
  Doubles doubles(kSeed + 2);
  std::vector<Vec3> grid;
  for (int i = 0; i < 1000; ++i)
    grid.push_back(
        {static_cast<double>(i % 10), static_cast<double>(i / 10 % 10), static_cast<double>(i / 100)});
  for (const double unit : {1.0, 0x1p-10, 0x1p-90, 0x1p+90}) {
    const StaticBounds bounds = static_bounds(std::span<const Vec3>(scaled(grid, unit)));
    CHECK(bounds.orient3d == 0);
    CHECK(bounds.insphere == 0);
    check_set(scaled(grid, unit), 300, doubles);
  }
  CHECK(static_bounds(std::span<const Vec3>(scaled(grid, 0.1))).insphere > 0);
  CHECK(static_bounds(std::span<const Vec3>(scaled(grid, 0x1p-110))).scale == 0);
  check_set(scaled(grid, 0.1), 300, doubles);
  check_set(scaled(grid, 0x1p-110), 300, doubles);
}

TEST_CASE("doubles: cubes, flat and tiny boxes, far from the origin, all exponents") {
  Doubles doubles(kSeed + 3);
  for (const auto& [low, high] :
       {std::pair{0, 0}, {-20, 0}, {-60, 0}, {-1022, -900}, {-1022, 1023}, {150, 160}}) {
    std::vector<Vec3> points(40);
    for (Vec3& p : points) p = doubles.vec(low, high);
    check_set(points, 200, doubles);
    for (Vec3& p : points) p.z = points[0].z;
    check_set(points, 50, doubles);
    for (Vec3& p : points) p = Vec3{1e6, 1e6, 1e6} + 0x1p-20 * doubles.vec(-3, 0);
    check_set(points, 200, doubles);
  }
  std::vector<Vec3> sphere(100);
  for (Vec3& p : sphere) {
    const Vec3 direction = doubles.vec(-5, 0);
    p = (1 / norm(direction)) * direction;
  }
  check_set(sphere, 1000, doubles);
}

TEST_CASE("a small grid with coordinates that vanish where they are scaled are no multiples of its unit") {
  Doubles doubles(kSeed + 4);
  for (const double tiny : {0x1p-1074, 0x1p-1022, 0x1p-980, 0x1p-130}) {
    std::vector<Vec3> points;
    for (int i = 0; i < 27; ++i)
      points.push_back(
          {i % 3 == 2 ? tiny : i % 3, static_cast<double>(i / 3 % 3), static_cast<double>(i / 9)});
    CHECK(static_bounds(std::span<const Vec3>(points)).scale == 0);
    check_set(points, 1000, doubles);
  }
}

TEST_CASE("rational lattice points among explicit ones") {
  samples::Generator generator(kSeed + 4);
  Doubles doubles(kSeed + 4);
  LatticePointStore store;
  std::vector<LatticePoint> points;
  for (int i = 0; i < 40; ++i) points.push_back(generator.point(store, kNormalLimit, 1000, 50));
  check_set(points, 200, doubles);
}

TEST_CASE("rational lattice points near one plane at a corner of the lattice: the blur decides") {
  samples::Generator generator(kSeed + 8);
  Doubles doubles(kSeed + 8);
  LatticePointStore store;
  for (int round = 0; round < 1500; ++round) {
    samples::NearPlane near(generator, store);
    std::vector<LatticePoint> points;
    for (int i = 0; i < 6; ++i) points.push_back(near.point());
    check_set(points, 4, doubles);
  }
}

TEST_CASE("power tests with bounds") {
  Doubles doubles(kSeed + 5);
  for (const int exponents : {0, 3, 30, 500}) {
    std::vector<WeightedPoint> points(60);
    for (WeightedPoint& p : points) p = {doubles.vec(-exponents, exponents), doubles.value(-exponents, 1)};
    points.resize(80, points[0]);
    for (std::size_t i = 60; i < 80; ++i) points[i] = points[i - 60];
    const StaticBounds bounds = static_bounds(std::span<const WeightedPoint>(points));
    for (int round = 0; round < 500; ++round) {
      const auto any = [&] { return points[doubles.index(points.size())]; };
      const WeightedPoint a = any(), b = any(), c = any(), d = any(), e = any();
      CHECK(power_test(bounds, a, b, c, d, e) == power_test(a, b, c, d, e));
      CHECK(orient3d(bounds, a.position, b.position, c.position, d.position) ==
            orient3d(a.position, b.position, c.position, d.position));
    }
  }
}

TEST_CASE("NaN and infinity: no bound, and the answer 0") {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()})
    for (int at = 0; at < 15; ++at) {
      std::vector<Vec3> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0.5, 0.5}};
      Vec3& v = p[static_cast<std::size_t>(at / 3)];
      (at % 3 == 0 ? v.x : at % 3 == 1 ? v.y : v.z) = bad;
      const StaticBounds bounds = static_bounds(std::span<const Vec3>(p));
      CHECK(bounds.orient3d == StaticBounds::kNone);
      CHECK(bounds.insphere == StaticBounds::kNone);
      CHECK(insphere(bounds, p[0], p[1], p[2], p[3], p[4]) == 0);
      CHECK(insphere(p[0], p[1], p[2], p[3], p[4]) == 0);
      if (at < 12) CHECK(orient3d(bounds, p[0], p[1], p[2], p[3]) == 0);
      if (at < 12) CHECK(orient3d(p[0], p[1], p[2], p[3]) == 0);
    }
}

TEST_CASE("the bound of a set is no less than that of any of its tuples") {
  Doubles doubles(kSeed + 6);
  for (const int exponents : {0, 2, 10, 60}) {
    std::vector<Vec3> points(50);
    for (Vec3& p : points) p = doubles.vec(-exponents, exponents / 2);
    const StaticBounds bounds = static_bounds(std::span<const Vec3>(points));
    for (int round = 0; round < 2000; ++round) {
      const auto any = [&] { return points[doubles.index(points.size())]; };
      const Vec3 a = any(), b = any(), c = any(), d = any(), e = any();
      CHECK(filters::kRoundedOrient3dError * filters::orient3d(b - a, c - a, d - a).size() <=
            bounds.orient3d);
      CHECK(filters::kRoundedInsphereError * filters::insphere(a - e, b - e, c - e, d - e).size() <=
            bounds.insphere);
    }
  }
}

TEST_CASE("an exact evaluation: up to its largest box, and no further") {
  Doubles doubles(kSeed + 7);
  for (const bool lifted : {false, true}) {
    double side = 1;  // the largest box for which the bound is 0
    const auto exact_on = [&](double s) {
      const std::vector<Vec3> box{{0, 0, 0}, {s, s, s}};
      const StaticBounds bounds = static_bounds(std::span<const Vec3>(box));
      return (lifted ? bounds.insphere : bounds.orient3d) == 0;
    };
    while (exact_on(side + 1)) ++side;
    CHECK(24 * 3 * std::pow(side, 5) <= (lifted ? 0x1p53 : std::numeric_limits<double>::infinity()));
    CHECK(6 * std::pow(side, 3) <= 0x1p53);
    std::vector<Vec3> points;
    const double pool[] = {0, 1, side / 2 - 1, side - 2, side - 1, side};
    for (const double x : pool)
      for (const double y : pool)
        for (const double z : pool) points.push_back({std::floor(x), std::floor(y), std::floor(z)});
    check_set(points, 2000, doubles);
  }
}

TEST_CASE("an empty set and a single point have no bound") {
  CHECK(static_bounds(std::span<const Vec3>()).orient3d == StaticBounds::kNone);
  const std::vector<Vec3> one{{1, 2, 3}};
  const StaticBounds bounds = static_bounds(std::span<const Vec3>(one));
  CHECK(orient3d(bounds, one[0], one[0], one[0], one[0]) == 0);
  CHECK(insphere(bounds, one[0], one[0], one[0], one[0], one[0]) == 0);
}
