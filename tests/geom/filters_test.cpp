// Recomputes every error constant of the filters in rational arithmetic, operation by operation, and checks
// that the constant in the source covers it and wastes nothing.

#include <doctest/doctest.h>

#include "../../geom/double_filters.h"
#include "../../geom/lattice_filters.h"
#include "../../geom/lifted_row.h"
#include "../../geom/weighted_filters.h"
#include "tracked_error.h"

using namespace crossloft;
using namespace crossloft::tracked;

namespace {

/// A difference at its column's maximum: exact on the lattice, rounded for plain doubles.
const Tracked kExact{1, 0};
const Tracked kRounded{1, kUnit};

/// A lift with the largest computed one as unit: `terms` squares of relative error known, all positive.
Tracked lift(bool rounded_differences, int squares) {
  mpq_class growth = 1 + kUnit;  // the square's own rounding
  const mpq_class away = 1 / (1 - kUnit);
  if (rounded_differences) growth *= away * away;  // d = computed * (1 + e), |e| <= u, backwards
  for (int i = 1; i < squares; ++i) growth *= 1 + kUnit;
  return {1, growth * growth - growth};  // |L_c - L| <= (growth - 1) L <= (growth - 1) growth L_c, generously
}

/// A lift with a weight, the largest computed |d|^2 + |v| as unit. All of it in |d|^2, the less exact part,
/// is the worst case.
Tracked weighted_lift() {
  const mpq_class unit_error = 1 / (1 - kUnit);  // the unit's own rounding
  const Tracked square{unit_error, lift(true, 3).error * unit_error};
  return rounded(square.size, square.error);
}

Tracked incircle_of(const Tracked& d, const Tracked& l) {
  const Tracked term = det2_of(d) * l;
  return (term - term) + term;
}
Tracked insphere_of(const Tracked& d, const Tracked& l) {
  const Tracked term = l * det3_of(d), pair = term - term;
  return pair + pair;
}

/// lifted_determinant: minors of two coordinates times minors of lift and coordinate, three in each lane.
Tracked lifted_of(const Tracked& d, const Tracked& l) {
  const Tracked term = det2_of(d) * (l * d - d * l), lane = (term - term) + term;
  return lane + lane;
}

/// The filter's constant holds, if it is not the least there is.
void check_covers(double constant, const Tracked& determinant) {
  mpq_class least = mpq_class(constant);
  for (int i = 0; i < 6; ++i) least *= 1 - kUnit;
  CHECK(least >= determinant.error);
}

}  // namespace

TEST_CASE("the in-sphere constants hold for determinants of lifted rows") {
  check_covers(filters::kInsphereError, lifted_of(kExact, lift(false, 3)));
  check_covers(filters::kRoundedInsphereError, lifted_of(kRounded, lift(true, 3)));
  check_covers(filters::kPower3dError, lifted_of(kRounded, weighted_lift()));
}

TEST_CASE("bounds of lifted determinants relative to their terms") {
  const auto power = [](const mpq_class& base, int exponent) {
    mpq_class product = 1;
    for (int i = 0; i < exponent; ++i) product *= base;
    return product;
  };
  const mpq_class up = 1 + kUnit, down = 1 - kUnit;
  // How far a product of entries as computed may be off: their own errors, two roundings of each minor, one
  // of the product, three of the sums. The sum of the sizes has as many roundings, all down, and the bound
  // one more.
  const auto check = [&](double constant, const Tracked& d, const Tracked& l) {
    const mpq_class minors = power(1 + d.error, 3) * (1 + l.error) * power(up, 4);
    const mpq_class error = minors * power(up, 4) - 1;
    CHECK(mpq_class(constant) * power(down, 9) >= error);
    CHECK(mpq_class(constant) - kUnit < error);
  };
  check(filters::kTermsError, kExact, lift(false, 3));
  check(filters::kRoundedTermsError, kRounded, lift(true, 3));
}

TEST_CASE("range of lifted terms") {
  const auto row = [](double x, double y, double z) {
    const Vec3 d{x, y, z};
    return LiftedRow(d, dot(d, d));
  };
  const auto terms = [&](double side) {
    return lifted_terms(row(side, 0, 0), row(0, side, 0), row(0, 0, side), row(side, side, side));
  };
  const double unbounded = std::numeric_limits<double>::infinity();
  CHECK(terms(1) == 6);  // one term of each unit lift, and one of the diagonal, which is 3
  CHECK(terms(0x1p-90) < unbounded);
  CHECK(terms(0x1p-120) == unbounded);
  CHECK(terms(0x1p149) < unbounded);
  CHECK(terms(0x1p151) == unbounded);
  CHECK(terms(0x1p600) == unbounded);
  CHECK(terms(std::numeric_limits<double>::quiet_NaN()) == unbounded);
  // Underflows times an entry and a lift, or three entries, within the room of the least bound.
  const mpq_class high(filters::kLargest);
  const mpq_class underflow = mpq_class(0x1p-1074) * 100 * high * high * high * 3;
  CHECK(underflow < mpq_class(0x1p-500) * mpq_class(filters::kTermsError) * kUnit);
}

TEST_CASE("constants on the lattice: exact differences") {
  check_constant(filters::kOrient2dError, det2_of(kExact));
  check_constant(filters::kOrient3dError, det3_of(kExact));
  check_constant(filters::kIncircleError, incircle_of(kExact, lift(false, 3)));
  check_constant(filters::kInsphereError, insphere_of(kExact, lift(false, 3)));
}

TEST_CASE("constants on plain doubles: rounded differences") {
  check_constant(filters::kRoundedOrient2dError, det2_of(kRounded));
  check_constant(filters::kRoundedOrient3dError, det3_of(kRounded));
  check_constant(filters::kRoundedIncircleError, incircle_of(kRounded, lift(true, 2)));
  check_constant(filters::kRoundedInsphereError, insphere_of(kRounded, lift(true, 3)));
}

TEST_CASE("constants on weighted points: lifts that cancel") {
  check_constant(filters::kPower2dError, incircle_of(kRounded, weighted_lift()));
  check_constant(filters::kPower3dError, insphere_of(kRounded, weighted_lift()));
  CHECK(lift(true, 3).error > kUnit);  // the square is the less exact part
}

TEST_CASE("constant of side_of_plane: three terms that sum to the unit") {
  // Products round by u of the whole together; the two sums are at most the whole.
  Tracked sum{1, 0};
  for (int i = 0; i < 3; ++i) sum = rounded(sum.size, sum.error);
  check_constant(kSideOfPlaneError, sum);
}

TEST_CASE("room for higher orders and for the rounding of a bound") {
  mpq_class growth = 1;
  for (int i = 0; i < 20; ++i) growth *= 1 + kUnit;
  CHECK(mpq_class(filters::kRoom) > growth);
}

TEST_CASE("blur: coordinates of rational points and their differences") {
  const mpq_class largest_ulp = mpq_class(kLatticeLimit) * kUnit;  // of doubles in [2^49, 2^50)
  const mpq_class half_ulp = largest_ulp / 2;
  const mpq_class difference_half_ulp = mpq_class(2 * kLatticeLimit) * kUnit / 2;  // in [2^50, 2^51)
  CHECK(2 * half_ulp + difference_half_ulp <= mpq_class(kBlur));
}

TEST_CASE("range of the filter on doubles") {
  const double low = filters::kSmallest, high = filters::kLargest;
  CHECK(24 * 3 * high * high * high * high * high < 0x1p+1000);
  CHECK(filters::kLargestLift >= 3 * high * high);
  CHECK(24 * filters::kLargestLift * high * high * high < 0x1p+1000);
  // 100 underflows, each times three entries and a lift of the largest size, within the room of the least
  // bound.
  const double room = filters::kRoundedOrient3dError * 0x1p-49;
  mpq_class underflow(0x1p-1074);
  underflow *= mpq_class(100) * mpq_class(high) * mpq_class(high) * mpq_class(high);
  mpq_class least = mpq_class(room);
  for (int i = 0; i < 5; ++i) least *= mpq_class(low);
  CHECK(underflow < least);
}

TEST_CASE("undecided on NaN, infinity and out of range") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf, 1e-200, 1e200, 1.7e308}) {
    CAPTURE(bad);
    const Vec3 a{0, 0, 0}, b{bad, 0, 0}, c{0, bad, 0}, d{0, 0, bad};
    CHECK(orient3d_filter(a, b, c, d) == 0);
    CHECK(insphere_filter(a, b, c, d, Vec3{bad, bad, bad}) == 0);
    CHECK(orient2d_filter(Vec2{0, 0}, Vec2{bad, 0}, Vec2{0, bad}) == 0);
    CHECK(incircle_filter(Vec2{0, 0}, Vec2{bad, 0}, Vec2{0, bad}, Vec2{1, bad}) == 0);
    CHECK(power_test_filter({a, 0}, {b, 0}, {c, 0}, {d, 0}, {{bad, bad, bad}, 0}) == 0);
    CHECK(power_test2d_filter({a, 0}, {b, 0}, {c, 0}, {{bad, bad, 0}, 0}, 2) == 0);
    if (std::fabs(bad) < 1) continue;  // a small weight is no trouble
    CHECK(power_test_filter({{1, 0, 0}, bad}, {{0, 1, 0}, 0}, {{0, 0, 1}, 0}, {{1, 1, 1}, 0}, {a, 0}) == 0);
    CHECK(power_test2d_filter({{1, 0, 0}, bad}, {{0, 1, 0}, 0}, {{1, 1, 1}, 0}, {a, 0}, 2) == 0);
  }
}
