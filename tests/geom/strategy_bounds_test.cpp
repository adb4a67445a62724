// The constants and bounds of the strategies, recomputed in rationals, and the number types against rationals
// operation by operation.

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <cmath>
#include <type_traits>
#include <vector>

#include "../../geom/strategies/ball.h"
#include "../../geom/strategies/double_double.h"
#include "../../geom/strategies/expansion.h"
#include "../../geom/strategies/interval.h"
#include "../../geom/strategies/meet_filter.h"
#include "../../geom/strategies/static_filter.h"
#include "random_doubles.h"

using namespace crossloft;
using namespace crossloft::strategies;

namespace {

constexpr std::uint64_t kSeed = 20261125;

mpq_class rational(double v) { return mpq_class(v); }
mpq_class power(double base, int exponent) {
  mpq_class r = 1;
  for (int i = 0; i < exponent; ++i) r *= rational(base);
  return r;
}

bool contains(const Interval& v, const mpq_class& exact) {
  return rational(v.low) <= exact && exact <= rational(v.high);
}
bool contains(const DoubleDouble& v, const mpq_class& exact) {
  return abs(exact - rational(v.high) - rational(v.low)) <= rational(v.error);
}
bool contains(const Bounded& v, const mpq_class& exact) {
  return abs(exact - rational(v.value)) <= rational(v.error);
}
bool contains(const Expansion& v, const mpq_class& exact) {
  mpq_class sum = 0;
  for (std::size_t i = 0; i < v.size(); ++i) sum += rational(v[i]);
  return sum == exact;
}

double lowest_bit(double v) { return std::ldexp(1.0, aligned::parts_of(v).exponent - AlignedUnit::kBias); }

template <class A>
bool sign_is_true(const typename A::Number& v, const mpq_class& exact) {
  const Verdict verdict = A::sign(v);
  return verdict == sgn(exact) || (verdict == kUnknown && A::kGuarantee == Guarantee::filter);
}

/// Random sums and products, nothing beyond degree 5, starting from doubles of exponents in a band.
template <class A>
std::size_t wrong_operations(int low, int high, std::uint64_t seed) {
  struct Pair {
    typename A::Number number;
    mpq_class exact;
    int degree;
  };
  Doubles random(seed);
  std::size_t wrong = 0;
  for (int run = 0; run < 200; ++run) {
    std::vector<Pair> pairs;
    for (int i = 0; i < 6; ++i) {
      const double v = i == 5 ? 0 : i == 4 ? 3 : random.value(low, high);
      pairs.push_back({A::from_double(v), rational(v), 1});
    }
    for (int i = 0; i < 30; ++i) {
      const Pair a = pairs[random.index(pairs.size())], b = pairs[random.index(pairs.size())];
      const std::size_t kind = random.index(3);
      if (kind == 0 && a.degree + b.degree <= 5)
        pairs.push_back({a.number * b.number, a.exact * b.exact, a.degree + b.degree});
      else if (kind == 1)
        pairs.push_back({a.number + b.number, a.exact + b.exact, std::max(a.degree, b.degree)});
      else
        pairs.push_back({a.number - b.number, a.exact - b.exact, std::max(a.degree, b.degree)});
      wrong += !contains(pairs.back().number, pairs.back().exact);
      wrong += !sign_is_true<A>(pairs.back().number, pairs.back().exact);
    }
  }
  return wrong;
}

/// As in filters_test.cpp: size and error as multiples of the maxima, every operation rounded.
struct Tracked {
  mpq_class size, error;
};
const mpq_class kUnit(filters::kU);
Tracked rounded(const mpq_class& size, const mpq_class& error) {
  return {size * (1 + kUnit), error + size * kUnit};
}
Tracked operator+(const Tracked& a, const Tracked& b) { return rounded(a.size + b.size, a.error + b.error); }
Tracked operator*(const Tracked& a, const Tracked& b) {
  return rounded(a.size * b.size, a.size * b.error + b.size * a.error + a.error * b.error);
}

}  // namespace

TEST_CASE("the error of side_of_meet in doubles") {
  const Tracked exact{1, 0}, product = exact * exact, offset = product + product + product;
  const Tracked minor = product + product, term = minor * exact, det3 = term + term + term;
  const Tracked whole = offset * det3, value = whole + whole + whole;
  mpq_class least = rational(kMeetError);
  for (int i = 0; i < 6; ++i) least *= 1 - kUnit;
  CHECK(least >= value.error);
  CHECK(least <= value.error * mpq_class(101, 100));
}

TEST_CASE("ranges: formulas of degree 5 neither overflow nor lose a bit") {
  const mpq_class largest = rational(range::kLargest), weight = rational(range::kLargestWeight);
  const mpq_class d = 2 * largest, lift = 3 * d * d + 2 * weight, det3 = 6 * d * d * d;
  CHECK(4 * lift * det3 * power(2, 27) < rational(std::numeric_limits<double>::max()));
  const mpq_class grain = rational(range::kSmallest) * power(0.5, 52);
  const mpq_class weight_grain = rational(range::kSmallestWeight) * power(0.5, 52);
  CHECK(grain * grain * grain * grain * grain >= rational(0x1p-1074));
  CHECK(weight_grain >= rational(0x1p-424));
  CHECK(weight_grain * grain * grain * grain >= rational(0x1p-1074));
  CHECK(power(range::kHomogeneousScale, 10) >= rational(0x1p-1074));
  CHECK(power(2, 1480) * power(range::kHomogeneousScale, 10) < power(2, 990));
  // With an explicit origin: four rows of degree 2.
  CHECK(power(2, 1239) * power(range::kHomogeneousScale, 8) < power(2, 990));
}

TEST_CASE("intervals: an end moves by more than a rounding") {
  // e >= 3u v (1 - u)^2 and v - e rounds by u |v - e| <= u v (1 + 4u).
  const mpq_class e = 3 * kUnit * (1 - kUnit) * (1 - kUnit);
  CHECK(e - kUnit * (1 + 4 * kUnit) > kUnit);
  CHECK(3 * kUnit * mpq_class(5, 6) - kUnit * (1 + 4 * kUnit) > kUnit);  // where 3u v underflows
}

TEST_CASE("errors of ball and double-double: the factor that makes up for their own roundings") {
  mpq_class shrunk = 1;
  for (int i = 0; i < 12; ++i) shrunk *= 1 - kUnit;
  CHECK(shrunk * (1 + 16 * kUnit) >= 1);
}

TEST_CASE("every number holds what it stands for, sums and products of all sizes") {
  MESSAGE("seed " << kSeed);
  for (const auto& [least, most] : {std::pair{-1, 1}, {-30, 30}, {-160, 189}, {-159, -150}, {180, 189}}) {
    const int low = least, high = most;
    CAPTURE(low);
    CHECK(wrong_operations<ExpansionArithmetic>(low, high, kSeed) == 0);
    CHECK(wrong_operations<DoubleDoubleArithmetic>(low, high, kSeed) == 0);
    CHECK(wrong_operations<IntervalArithmetic>(low, high, kSeed) == 0);
    CHECK(wrong_operations<BallArithmetic>(low, high, kSeed) == 0);
  }
  // Where products underflow the filters go on.
  for (const auto& [least, most] : {std::pair{-1074, -1000}, {-600, -500}, {-1074, 189}, {-250, -200}}) {
    const int low = least, high = most;
    CAPTURE(low);
    CHECK(wrong_operations<DoubleDoubleArithmetic>(low, high, kSeed) == 0);
    CHECK(wrong_operations<IntervalArithmetic>(low, high, kSeed) == 0);
    CHECK(wrong_operations<BallArithmetic>(low, high, kSeed) == 0);
  }
}

TEST_CASE("sums and products of two doubles are exact") {
  MESSAGE("seed " << kSeed);
  Doubles random(kSeed);
  for (int i = 0; i < 10000; ++i) {
    const double a = random.value(-200, 200), b = random.value(-200, 200);
    const Exact2 s = two_sum(a, b), p = two_product(a, b), h = split(a);
    CHECK(rational(s.high) + rational(s.low) == rational(a) + rational(b));
    CHECK(rational(p.high) + rational(p.low) == rational(a) * rational(b));
    CHECK((s.high == a + b && p.high == a * b && h.high + h.low == a));
    CHECK(h.high * h.high / h.high == h.high);
  }
}

TEST_CASE("expansions are kept in order, without overlap and zeros") {
  MESSAGE("seed " << kSeed);
  Doubles random(kSeed);
  for (int run = 0; run < 300; ++run) {
    Expansion e(random.value(-60, 60));
    for (int i = 0; i < 5; ++i) {
      const Expansion f(random.value(-60, 60));
      e = random.index(2) == 0 ? e + f : e * (f - Expansion(random.value(-60, 60)));
      for (std::size_t k = 0; k < e.size(); ++k) CHECK(e[k] != 0);
      for (std::size_t k = 1; k < e.size(); ++k) CHECK(std::fabs(e[k - 1]) < lowest_bit(e[k]));
    }
    CHECK((e - e).sign() == 0);
  }
}

TEST_CASE("double-double knows the zeros that fit into two doubles, a static filter none") {
  const DoubleDouble a(0x1.fffffffffffffp+50), b(0x1.0000000000001p+50), c(3);
  CHECK(DoubleDoubleArithmetic::sign(a * b - b * a) == 0);
  CHECK(DoubleDoubleArithmetic::sign(a * b - b * a + c) == 1);
  CHECK(DoubleDoubleArithmetic::sign((a * b) * (b * a) - (b * a) * (a * b)) == kUnknown);
}

TEST_CASE("a static filter holds for the data of its extent, and says nothing without one") {
  const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, d{0, 0, 1};
  CHECK(StaticFilter().orient3d(a, b, c, d) == kUnknown);
  ExtentBuilder builder;
  for (const Vec3& p : {a, b, c, d}) builder.include(p);
  const StaticFilter filter(builder.extent());
  CHECK(filter.orient3d(a, b, c, d) == 1);
  // The bound is 46 u of a unit cube: a tetrahedron under it is left open, one above is decided.
  CHECK(filter.orient3d(a, b, c, Vec3{0, 0, 0x1p-48}) == kUnknown);
  CHECK(filter.orient3d(a, b, c, Vec3{0, 0, 0x1p-47}) == 1);
  builder.include(Vec3{1e60, 0, 0});
  CHECK(StaticFilter(builder.extent()).orient3d(a, b, c, d) == kUnknown);
}
