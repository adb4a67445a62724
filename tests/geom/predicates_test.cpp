// The predicates on arbitrary doubles against rationals: like and unlike exponents, ulps around degeneracy,
// denormals and the largest doubles, and the laws stated in predicates.h.

#include "../../geom/predicates.h"

#include <doctest/doctest.h>

#include <limits>

#include "../../geom/double_filters.h"
#include "random_doubles.h"
#include "rational_reference.h"

using namespace crossloft;
using reference::exact;

namespace {

constexpr std::uint64_t kSeed = 20260303;

constexpr double kBiggest = std::numeric_limits<double>::max();
constexpr double kDenormal = std::numeric_limits<double>::denorm_min();

Vec2 flat(Vec3 v) { return {v.x, v.y}; }
reference::Rational3 exact_flat(Vec3 v) { return exact(Vec3{v.x, v.y, 0}); }
const reference::Rational3 kUp{0, 0, 1};

void check_answer(int expected, int filter, int answer) {
  CHECK(answer == expected);
  CHECK((filter == 0 || filter == expected));
}

void check(const std::array<Vec3, 5>& p) {
  const auto& [a, b, c, d, e] = p;
  check_answer(reference::orient3d(exact(a), exact(b), exact(c), exact(d)), orient3d_filter(a, b, c, d),
               orient3d(a, b, c, d));
  check_answer(reference::insphere(exact(a), exact(b), exact(c), exact(d), exact(e)),
               insphere_filter(a, b, c, d, e), insphere(a, b, c, d, e));
  const Vec2 s = flat(a), t = flat(b), u = flat(c), v = flat(d);
  check_answer(reference::orient2d(kUp, exact_flat(a), exact_flat(b), exact_flat(c)),
               orient2d_filter(s, t, u), orient2d(s, t, u));
  check_answer(reference::incircle(kUp, exact_flat(a), exact_flat(b), exact_flat(c), exact_flat(d)),
               incircle_filter(s, t, u, v), incircle(s, t, u, v));
}

}  // namespace

TEST_CASE("halves of integers around powers of two, where these stop to be doubles") {
  MESSAGE("seed " << kSeed + 20);
  Doubles doubles(kSeed + 20);
  for (int exponent = 48; exponent <= 54; ++exponent)
    for (const double sign : {-1.0, 1.0})
      for (int round = 0; round < 300; ++round) {
        const double least = std::ldexp(1.0, exponent) - (round % 2 == 0 ? 0 : 8);
        const auto near = [&] { return sign * (least + 0.5 * static_cast<double>(doubles.index(5))); };
        std::array<Vec3, 5> p;
        for (Vec3& v : p) v = {near(), near(), near()};
        check(p);
        for (Vec3& v : p) v.y -= sign * std::ldexp(1.0, exponent), v.z = v.y + 1;
        check(p);
      }
}

TEST_CASE("random doubles: one binade to all of them") {
  MESSAGE("seed " << kSeed);
  Doubles doubles(kSeed);
  const std::pair<int, int> bands[] = {{0, 0},        {-8, 0},       {-60, 0},    {-40, 40},    {-100, 100},
                                       {-1022, -970}, {-1022, 1023}, {990, 1023}, {-200, -140}, {140, 300}};
  for (const auto& [low, high] : bands)
    for (int round = 0; round < 150; ++round) {
      std::array<Vec3, 5> p;
      for (Vec3& v : p) v = doubles.vec(low, high);
      check(p);
      p[doubles.index(5)] = p[doubles.index(5)];
      check(p);
    }
}

TEST_CASE("denormals and the largest doubles in one call") {
  Doubles doubles(kSeed + 1);
  const double pool[] = {0, -0.0, kDenormal, -kDenormal, 3 * kDenormal, 0x1p-1022, 1e-300,
                         1, -1,   1e300,     -1e300,     kBiggest,      -kBiggest};
  for (int round = 0; round < 1500; ++round) {
    const auto pick = [&] { return pool[doubles.index(std::size(pool))]; };
    std::array<Vec3, 5> p;
    for (Vec3& v : p) v = {pick(), pick(), pick()};
    check(p);
  }
}

TEST_CASE("ulps around a plane, a line, a sphere and a circle") {
  Doubles doubles(kSeed + 2);
  for (int round = 0; round < 400; ++round) {
    const Vec3 a = doubles.vec(-3, 3), b = doubles.vec(-3, 3), c = doubles.vec(-3, 3);
    const double s = doubles.value(-2, 0), t = doubles.value(-2, 0);
    const Vec3 on_plane = a + s * (b - a) + t * (c - a);
    check({a, b, c, doubles.nudged(on_plane), doubles.nudged(a)});
    check({a, b, doubles.nudged(a + s * (b - a)), c, doubles.nudged(b)});
    std::array<Vec3, 5> ball;
    for (Vec3& v : ball) {
      const Vec3 direction = doubles.vec(-2, 0);
      v = doubles.nudged(a + (1 / norm(direction)) * direction);
    }
    check(ball);
    for (Vec3& v : ball) {
      const Vec3 direction = doubles.vec(-2, 0);
      v = Vec3{1, 2, 0} + (1 / std::sqrt(direction.x * direction.x + direction.y * direction.y)) * direction;
    }
    check(ball);
  }
}

TEST_CASE("the classic grid of ulps around a diagonal") {
  for (int i = -8; i < 8; ++i)
    for (int j = -8; j < 8; ++j) {
      const Vec2 a{0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53};
      const int expected =
          reference::orient2d(kUp, {mpq_class(a.x), mpq_class(a.y), 0}, {12, 12, 0}, {24, 24, 0});
      CHECK(orient2d(a, {12, 12}, {24, 24}) == expected);
    }
}

TEST_CASE("grid points: all degeneracies at once") {
  Doubles doubles(kSeed + 3);
  for (const double unit : {1.0, 0.1, 1e-170, 1e160})
    for (int round = 0; round < 400; ++round) {
      std::array<Vec3, 5> p;
      const auto pick = [&] { return unit * static_cast<double>(doubles.index(3)); };
      for (Vec3& v : p) v = {pick(), pick(), pick()};
      check(p);
    }
}

TEST_CASE("laws: exchange of points, mirror, scale") {
  Doubles doubles(kSeed + 4);
  for (int round = 0; round < 200; ++round) {
    std::array<Vec3, 5> p;
    for (Vec3& v : p)
      v = {static_cast<double>(doubles.index(3)), static_cast<double>(doubles.index(3)),
           doubles.value(-2, 2)};
    const int o3 = orient3d(p[0], p[1], p[2], p[3]), is = insphere(p[0], p[1], p[2], p[3], p[4]);
    const int o2 = orient2d(flat(p[0]), flat(p[1]), flat(p[2]));
    const int ic = incircle(flat(p[0]), flat(p[1]), flat(p[2]), flat(p[3]));
    for (std::size_t i = 0; i < 5; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        auto q = p;
        std::swap(q[i], q[j]);
        CHECK(insphere(q[0], q[1], q[2], q[3], q[4]) == -is);
        if (i < 4) CHECK(orient3d(q[0], q[1], q[2], q[3]) == -o3);
        if (i < 4) CHECK(incircle(flat(q[0]), flat(q[1]), flat(q[2]), flat(q[3])) == -ic);
        if (i < 3) CHECK(orient2d(flat(q[0]), flat(q[1]), flat(q[2])) == -o2);
      }
    for (const double scale : {0x1p-600, 0x1p+700}) {
      auto q = p;
      for (Vec3& v : q) v = {-scale * v.x, scale * v.y, scale * v.z};
      CHECK(insphere(q[0], q[1], q[2], q[3], q[4]) == -is);
      CHECK(orient3d(q[0], q[1], q[2], q[3]) == -o3);
      CHECK(incircle(flat(q[0]), flat(q[1]), flat(q[2]), flat(q[3])) == -ic);
      CHECK(orient2d(flat(q[0]), flat(q[1]), flat(q[2])) == -o2);
    }
  }
}

TEST_CASE("signs that one can see") {
  CHECK(orient2d({0, 0}, {1, 0}, {0, 1}) == 1);
  CHECK(incircle({0, 0}, {1, 0}, {0, 1}, {0.5, 0.5}) == 1);
  CHECK(orient3d(Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}) == 1);
  CHECK(insphere(Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{0.5, 0.5, 0.5}) == 1);
}

TEST_CASE("NaN and infinity answer 0") {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()}) {
    CHECK(orient2d({0, 0}, {1, 0}, {0, bad}) == 0);
    CHECK(incircle({0, 0}, {1, 0}, {0, 1}, {bad, 0.5}) == 0);
    CHECK(orient3d(Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, bad}) == 0);
    CHECK(insphere(Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, bad, 1}, Vec3{0.5, 0.5, 0.5}) == 0);
  }
}
