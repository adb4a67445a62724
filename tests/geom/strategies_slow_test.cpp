// At least 10^7 inputs per predicate within ulps of zero: filters, double-double and intervals never
// contradict the exact sign, and the production predicates and a cascade on expansions give it.
//
// Around an exactly degenerate configuration of integers one point takes all places of a square of ulps, as
// in the well-known pictures of orient2d; the exact sign is that of fixed-width integers.

#include <cmath>
#include <random>

#include "../../bench/predicate_questions.h"
#include "around_zero.h"

using namespace crossloft;
using namespace crossloft::strategies;
using around_zero::Tally;

namespace {

constexpr int kRadius = 48;  // ulps: (2 * 48 + 1)^2 places

using Watched = std::tuple<StaticFilter, SemiStaticFilter, IntervalStrategy, Ball, DoubleDoubleStrategy,
                           Cascade<SemiStaticFilter, Expansions>, Crossloft>;

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double whole(std::int64_t limit) {
    return static_cast<double>(
        static_cast<std::int64_t>(engine_() % (2 * static_cast<std::uint64_t>(limit) + 1)) - limit);
  }
  std::size_t index(std::size_t n) { return engine_() % n; }

 private:
  std::mt19937_64 engine_;
};

double& at(Vec2& p, std::size_t axis) { return axis == 0 ? p.x : p.y; }
double& at(WeightedPoint& p, std::size_t axis) {
  return axis == 0 ? p.position.x : axis == 1 ? p.position.y : p.position.z;
}

/// The case with its point `moved` at all places of the square.
template <class Q, class Case>
void sweep(Case c, std::size_t moved, std::size_t axis, std::size_t other, Tally& tally) {
  const double x = at(c[moved], axis), y = at(c[moved], other);
  const auto ulp = [](double v) { return std::nextafter(std::fabs(v), INFINITY) - std::fabs(v); };
  const double dx = ulp(x), dy = ulp(y);
  const auto place = [&](int i, int j) {
    at(c[moved], axis) = x + i * dx;
    at(c[moved], other) = y + j * dy;
  };
  ExtentBuilder builder;
  for (const int corner : {-kRadius, kRadius}) place(corner, corner), bench::include_case(builder, c);
  const Watched watched{StaticFilter(builder.extent()),
                        SemiStaticFilter(),
                        IntervalStrategy(),
                        Ball(),
                        DoubleDoubleStrategy(),
                        Cascade<SemiStaticFilter, Expansions>(),
                        Crossloft()};
  for (int i = -kRadius; i <= kRadius; ++i)
    for (int j = -kRadius; j <= kRadius; ++j) {
      place(i, j);
      around_zero::judge<Q>(c, watched, tally);
    }
}

/// Degenerate cases until there are enough inputs; make(random) has all points on one line, plane, circle or
/// sphere, at coordinates of some 2^-6..2^6 units.
template <class Q, class Make>
void sweep_all(const Make& make, std::size_t points, std::size_t axes) {
  Random random(around_zero::kSeed);
  around_zero::ask_enough<Q>([&](Tally& tally) {
    const std::size_t axis = random.index(axes);
    sweep<Q>(make(random), random.index(points), axis, (axis + 1) % axes, tally);
  });
}

double scaled(double whole, Random& random) { return std::ldexp(whole, -static_cast<int>(random.index(8))); }

bench::PlanarCase on_line(Random& random) {
  const double u = random.whole(50), v = random.whole(50), x = scaled(random.whole(100), random),
               y = random.whole(100);
  bench::PlanarCase c;
  for (Vec2& p : c) {
    const double t = scaled(random.whole(50), random);
    p = {x + t * u, y + t * v};
  }
  return c;
}

bench::SpaceCase on_plane(Random& random) {
  const double u = random.whole(20), v = random.whole(20), offset = scaled(random.whole(100), random);
  bench::SpaceCase c;
  for (WeightedPoint& p : c) {
    const double x = scaled(random.whole(200), random), y = scaled(random.whole(200), random);
    p.position = {x, y, u * x + v * y + offset};
  }
  return c;
}

/// Signed permutations of two vectors of equal length, about a common centre.
bench::PlanarCase on_circle(Random& random) {
  // 65^2 = 16^2 + 63^2 = 25^2 + 60^2 = 33^2 + 56^2 = 39^2 + 52^2.
  constexpr std::array<std::pair<double, double>, 4> kPairs{{{16, 63}, {25, 60}, {33, 56}, {39, 52}}};
  const double x = scaled(random.whole(1000), random), y = scaled(random.whole(1000), random);
  bench::PlanarCase c;
  for (Vec2& p : c) {
    auto [a, b] = kPairs[random.index(4)];
    if (random.index(2) == 0) std::swap(a, b);
    p = {x + (random.index(2) == 0 ? a : -a), y + (random.index(2) == 0 ? b : -b)};
  }
  return c;
}

bench::SpaceCase on_sphere(Random& random) {
  // All of squared length 1105.
  constexpr std::array<std::array<double, 3>, 4> kVectors{{{4, 33, 0}, {9, 32, 0}, {12, 31, 0}, {23, 24, 0}}};
  const Vec3 centre{scaled(random.whole(1000), random), random.whole(1000),
                    scaled(random.whole(1000), random)};
  bench::SpaceCase c;
  for (WeightedPoint& p : c) {
    std::array<double, 3> v = kVectors[random.index(4)];
    std::swap(v[0], v[random.index(3)]), std::swap(v[1], v[1 + random.index(2)]);
    for (double& k : v) k = random.index(2) == 0 ? k : -k;
    p = {centre + Vec3{v[0], v[1], v[2]}, 7};
  }
  return c;
}

/// Heights |x|^2 - w that are an affine function of the place.
bench::SpaceCase on_lifted_plane(Random& random) {
  const double u = random.whole(20), v = random.whole(20), w = random.whole(20);
  bench::SpaceCase c;
  for (WeightedPoint& p : c) {
    const Vec3 d{scaled(random.whole(100), random), random.whole(100), scaled(random.whole(100), random)};
    p = {d, dot(d, d) - dot(d, Vec3{u, v, w})};
  }
  return c;
}

}  // namespace

TEST_CASE("orient2d") { sweep_all<bench::Orient2d>(on_line, 3, 2); }
TEST_CASE("orient3d") { sweep_all<bench::Orient3d>(on_plane, 4, 3); }
TEST_CASE("incircle") { sweep_all<bench::Incircle>(on_circle, 4, 2); }
TEST_CASE("insphere") { sweep_all<bench::Insphere>(on_sphere, 5, 3); }
TEST_CASE("power_test") { sweep_all<bench::PowerTest>(on_lifted_plane, 5, 3); }
