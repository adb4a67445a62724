// Double-double numbers against rationals: every claimed error holds, claimed signs are true, and the errors
// are as small as promised.

#include "../../geom/double_double.h"

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <limits>
#include <vector>

#include "../../geom/exact_rows.h"
#include "random_doubles.h"
#include "rational_reference.h"

using namespace crossloft;
using reference::exact;

namespace {

constexpr std::uint64_t kSeed = 20261125;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Pair {
  DoubleDouble number;
  mpq_class exact;
};

bool is_finite(const DoubleDouble& n) {
  return std::isfinite(n.high) && std::isfinite(n.low) && std::isfinite(n.error);
}

void check(const Pair& p) {
  if (p.number.is_certain()) CHECK(p.number.sign() == sgn(p.exact));
  if (!is_finite(p.number)) return;
  CHECK(abs(mpq_class(p.exact - mpq_class(p.number.high) - mpq_class(p.number.low))) <=
        mpq_class(p.number.error));
  CHECK(std::fabs(p.number.low) <= 0x1p-53 * std::fabs(p.number.high));
}

Pair combine(const Pair& a, const Pair& b, std::size_t operation) {
  if (operation == 0) return {a.number + b.number, a.exact + b.exact};
  if (operation == 1) return {a.number - b.number, a.exact - b.exact};
  return {a.number * b.number, a.exact * b.exact};
}

/// A row relative to an origin, for the determinants.
struct Row {
  DoubleDouble x, y, z;
  Row(const Vec3& p, const Vec3& origin)
      : x(DoubleDouble::difference(p.x, origin.x)),
        y(DoubleDouble::difference(p.y, origin.y)),
        z(DoubleDouble::difference(p.z, origin.z)) {}
};

DoubleDouble in_sphere(const Row& p, const Row& q, const Row& r, const Row& s) {
  const auto lift = [](const Row& d) { return d.x * d.x + d.y * d.y + d.z * d.z; };
  return (lift(p) * det3(q, r, s) - lift(q) * det3(p, r, s)) +
         (lift(r) * det3(p, q, s) - lift(s) * det3(p, q, r));
}

}  // namespace

TEST_CASE("differences are exact") {
  Doubles doubles(kSeed);
  for (int round = 0; round < 20000; ++round) {
    const double a = doubles.value(-1074, 1000);
    const double b = round % 2 == 0 ? doubles.value(-1074, 1000) : doubles.nudged(a * 0.75);
    const DoubleDouble d = DoubleDouble::difference(a, b);
    CHECK(d.error == 0);
    CHECK(mpq_class(d.high) + mpq_class(d.low) == mpq_class(a) - mpq_class(b));
  }
}

TEST_CASE("random expressions: the error claimed holds") {
  MESSAGE("seed " << kSeed);
  for (const int exponents : {1, 30, 200, 500, 1000}) {
    Doubles doubles(kSeed + static_cast<std::uint64_t>(exponents));
    for (int round = 0; round < 200; ++round) {
      std::vector<Pair> pairs;
      for (int i = 0; i < 8; ++i) {
        const double v = doubles.value(-exponents, exponents);
        pairs.push_back({v, mpq_class(v)});
      }
      pairs.push_back({DoubleDouble(0), 0});
      for (int i = 0; i < 20; ++i) {
        const Pair& a = pairs[doubles.index(pairs.size())];
        const Pair& b = pairs[doubles.index(pairs.size())];
        pairs.push_back(combine(a, b, doubles.index(3)));
        check(pairs.back());
        if (abs(pairs.back().exact) > mpq_class(1e300)) pairs.pop_back();
      }
    }
  }
}

TEST_CASE("one operation is off by a few 2^-106 at most") {
  Doubles doubles(kSeed + 1);
  for (int round = 0; round < 20000; ++round) {
    const DoubleDouble a = DoubleDouble::sum(doubles.value(-3, 3), doubles.value(-58, -50));
    const DoubleDouble b = DoubleDouble::sum(doubles.value(-3, 3), doubles.value(-58, -50));
    const auto value = [](const DoubleDouble& n) -> mpq_class {
      return mpq_class(n.high) + mpq_class(n.low);
    };
    for (std::size_t operation = 0; operation < 3; ++operation) {
      const Pair r = combine({a, value(a)}, {b, value(b)}, operation);
      check(r);
      const double scale =
          operation == 2 ? std::fabs(a.high * b.high) : std::fabs(a.high) + std::fabs(b.high);
      CHECK(r.number.error <= 9 * 0x1p-106 * scale);
    }
  }
}

TEST_CASE("in-sphere of nearly cospherical doubles: certain nearly always, and true") {
  Doubles doubles(kSeed + 2);
  int certain = 0;
  constexpr int kRounds = 2000;
  for (int round = 0; round < kRounds; ++round) {
    std::array<Vec3, 5> p;
    for (Vec3& v : p) {
      const Vec3 direction = doubles.vec(-2, 0);
      v = (1 / norm(direction)) * direction;
    }
    const DoubleDouble det = in_sphere({p[0], p[4]}, {p[1], p[4]}, {p[2], p[4]}, {p[3], p[4]});
    if (!det.is_certain()) continue;
    ++certain;
    CHECK(det.sign() == reference::insphere(exact(p[0]), exact(p[1]), exact(p[2]), exact(p[3]), exact(p[4])));
  }
  CHECK(certain > kRounds * 99 / 100);
}

TEST_CASE("zero, overflow, underflow, NaN") {
  CHECK((DoubleDouble(0) * DoubleDouble(1e300)).is_zero());
  CHECK(DoubleDouble::difference(0.1, 0.1).is_zero());
  for (const double bad : {kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK(!(DoubleDouble(bad) * DoubleDouble(2)).is_certain());
    CHECK(!(DoubleDouble(bad) + DoubleDouble(2)).is_certain());
  }
  CHECK(!(DoubleDouble(1e300) * DoubleDouble(1e300)).is_certain());
  CHECK(!(DoubleDouble(1e-200) * DoubleDouble(1e-200)).is_certain());
  CHECK(!(DoubleDouble(0x1p1020) * DoubleDouble(0.5)).is_certain());  // splitting overflows
}
