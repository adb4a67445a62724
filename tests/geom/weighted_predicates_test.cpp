// The power tests against rationals: like and unlike exponents of coordinates and weights, ulps around a tie,
// denormals and the largest doubles, and the laws stated in weighted_predicates.h.

#include "../../geom/weighted_predicates.h"

#include <doctest/doctest.h>

#include <limits>

#include "../../geom/predicates.h"
#include "../../geom/weighted_filters.h"
#include "random_doubles.h"
#include "rational_reference.h"

using namespace crossloft;
using reference::dot;
using reference::exact;
using reference::operator-;
using reference::Rational3;

namespace {

constexpr std::uint64_t kSeed = 20261122;
using Five = std::array<WeightedPoint, 5>;

mpq_class height(const WeightedPoint& p, const WeightedPoint& origin) {
  const Rational3 d = exact(p.position) - exact(origin.position);
  return dot(d, d) - mpq_class(p.weight) + mpq_class(origin.weight);
}

/// Height of the hyperplane over e, from Cramer's rule without its denominator, the volume of a, b, c, d.
int reference3(const Five& p) {
  mpq_class sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<Rational3, 3> others;
    for (std::size_t j = 0, n = 0; j < 4; ++j)
      if (j != i) others[n++] = exact(p[j].position) - exact(p[4].position);
    const mpq_class term = height(p[i], p[4]) * reference::volume(others[0], others[1], others[2]);
    sum += i % 2 == 0 ? term : mpq_class(-term);
  }
  return sgn(sum);
}

int reference2(const Five& p, int drop) {
  std::array<Rational3, 3> r;
  for (std::size_t i = 0; i < 3; ++i) r[i] = exact(p[i].position) - exact(p[3].position);
  const auto area = [&](std::size_t i, std::size_t j) {
    return reference::cross(r[i], r[j])[static_cast<std::size_t>(drop)];
  };
  return sgn(mpq_class(height(p[0], p[3]) * area(1, 2) - height(p[1], p[3]) * area(0, 2) +
                       height(p[2], p[3]) * area(0, 1)));
}

/// The line's height over c along the first axis that tells a and b apart.
int reference1(const Five& p) {
  const Rational3 a = exact(p[0].position), b = exact(p[1].position), c = exact(p[2].position);
  std::size_t k = 0;
  while (k < 3 && a[k] == b[k]) ++k;
  if (k == 3) return 0;
  const mpq_class t = (c[k] - a[k]) / (b[k] - a[k]);
  return sgn(mpq_class((1 - t) * height(p[0], p[2]) + t * height(p[1], p[2])));
}

void check_answer(int expected, int filter, int answer) {
  CHECK(answer == expected);
  CHECK((filter == 0 || filter == expected));
}

void check(const Five& p) {
  const auto& [a, b, c, d, e] = p;
  check_answer(reference3(p), power_test_filter(a, b, c, d, e), power_test(a, b, c, d, e));
  for (int drop = 0; drop < 3; ++drop)
    check_answer(reference2(p, drop), power_test2d_filter(a, b, c, d, drop), power_test2d(a, b, c, d, drop));
  CHECK(power_test1d(a, b, c) == reference1(p));
}

}  // namespace

TEST_CASE("random doubles: one binade to all of them, weights too") {
  MESSAGE("seed " << kSeed);
  Doubles doubles(kSeed);
  const std::pair<int, int> bands[] = {{0, 0},        {-60, 0},      {-40, 40},   {-100, 100},
                                       {-1022, -970}, {-1022, 1023}, {990, 1023}, {-200, -140}};
  for (const auto& [low, high] : bands)
    for (const auto& [weight_low, weight_high] : bands)
      for (int round = 0; round < 15; ++round) {
        Five p;
        for (WeightedPoint& s : p) s = {doubles.vec(low, high), doubles.value(weight_low, weight_high)};
        check(p);
        p[doubles.index(5)].position = p[doubles.index(5)].position;
        check(p);
      }
}

TEST_CASE("denormals and the largest doubles in one call") {
  Doubles doubles(kSeed + 1);
  constexpr double kBiggest = std::numeric_limits<double>::max();
  constexpr double kDenormal = std::numeric_limits<double>::denorm_min();
  const double pool[] = {0, -0.0, kDenormal, -kDenormal, 3 * kDenormal, 0x1p-1022, 1e-300,
                         1, -1,   1e300,     -1e300,     kBiggest,      -kBiggest};
  for (int round = 0; round < 1000; ++round) {
    const auto pick = [&] { return pool[doubles.index(std::size(pool))]; };
    Five p;
    for (WeightedPoint& s : p) s = {{pick(), pick(), pick()}, pick()};
    check(p);
  }
}

TEST_CASE("ulps around a tie: lifted points on a hyperplane") {
  Doubles doubles(kSeed + 2);
  for (int round = 0; round < 400; ++round) {
    const Vec3 slope = doubles.vec(-2, 2);
    Five p;
    for (WeightedPoint& s : p) {
      s.position = doubles.vec(-3, 3);
      s.weight = doubles.nudged(dot(s.position, s.position) - dot(slope, s.position));
    }
    check(p);
    // Coplanar and collinear, as nearly as doubles go.
    p[3].position =
        p[0].position + 0.25 * (p[1].position - p[0].position) + 0.5 * (p[2].position - p[0].position);
    p[2].position = p[0].position + 0.375 * (p[1].position - p[0].position);
    for (const std::size_t i : {2u, 3u}) {
      WeightedPoint& s = p[i];
      s.weight = doubles.nudged(dot(s.position, s.position) - dot(slope, s.position));
    }
    check(p);
  }
}

TEST_CASE("grid points with small weights: all degeneracies at once") {
  Doubles doubles(kSeed + 3);
  for (const double unit : {1.0, 0.1, 0x1p-500, 0x1p+500})
    for (int round = 0; round < 400; ++round) {
      Five p;
      const auto pick = [&] { return static_cast<double>(doubles.index(3)); };
      for (WeightedPoint& s : p) s = {unit * Vec3{pick(), pick(), pick()}, unit * unit * pick()};
      check(p);
    }
}

TEST_CASE("laws: exchange of points, equal weights, scale, raised weights") {
  Doubles doubles(kSeed + 4);
  for (int round = 0; round < 200; ++round) {
    Five p;
    const auto pick = [&] { return static_cast<double>(doubles.index(3)); };
    for (WeightedPoint& s : p) s = {{pick(), pick(), doubles.value(-2, 2)}, pick()};
    const auto test3 = [](const Five& q) { return power_test(q[0], q[1], q[2], q[3], q[4]); };
    const auto test2 = [](const Five& q) { return power_test2d(q[0], q[1], q[2], q[3], 1); };
    const auto test1 = [](const Five& q) { return power_test1d(q[0], q[1], q[2]); };
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        Five q = p;
        std::swap(q[i], q[j]);
        CHECK(test3(q) == -test3(p));
        if (i < 3) CHECK(test2(q) == -test2(p));
        if (i < 2 && p[0].position.x != p[1].position.x) CHECK(test1(q) == test1(p));
      }
    Five even = p, raised = p;
    for (WeightedPoint& s : even) s.weight = 7;
    CHECK(test3(even) == insphere(p[0].position, p[1].position, p[2].position, p[3].position, p[4].position));
    for (WeightedPoint& s : raised) s.weight -= 1024;
    for (const double scale : {1.0, 0x1p-400, 0x1p+400}) {
      Five q = raised;
      for (WeightedPoint& s : q) s = {scale * s.position, scale * scale * s.weight};
      CHECK(test3(q) == test3(p));
      CHECK(test2(q) == test2(p));
      CHECK(test1(q) == test1(p));
    }
  }
}

TEST_CASE("signs that one can see") {
  const WeightedPoint a{{0, 0, 0}, 0}, b{{1, 0, 0}, 0}, c{{0, 1, 0}, 0}, d{{0, 0, 1}, 0};
  CHECK(power_test(a, b, c, d, {{0.5, 0.5, 0.5}, 0}) == 1);
  CHECK(power_test(a, b, c, d, {{0.5, 0.5, 0.5}, -10}) == -1);
  CHECK(power_test(a, b, c, d, {{9, 9, 9}, 1000}) == 1);
  CHECK(power_test2d(a, b, c, {{1, 1, 0}, 0}, 2) == 0);
  CHECK(power_test2d(a, b, c, {{1, 1, 0}, 1}, 2) == 1);
  CHECK(power_test1d(a, b, {{0.5, 0, 0}, 0}) == 1);
  CHECK(power_test1d(a, b, {{0.5, 0, 0}, -0.25}) == 0);
  CHECK(power_test1d(a, b, {{0.5, 0, 0}, -1}) == -1);
}

TEST_CASE("NaN and infinity answer 0") {
  const WeightedPoint a{{0, 0, 0}, 0}, b{{1, 0, 0}, 0}, c{{0, 1, 0}, 0}, d{{0, 0, 1}, 0};
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    CHECK(power_test(a, b, c, d, {{0.5, 0.5, 0.5}, bad}) == 0);
    CHECK(power_test(a, b, c, d, {{0.5, bad, 0.5}, 0}) == 0);
    CHECK(power_test2d(a, b, c, {{1, 1, 0}, bad}, 2) == 0);
    CHECK(power_test1d(a, b, {{0.5, 0, 0}, bad}) == 0);
  }
}
