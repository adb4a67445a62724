// At least 10^7 inputs per lattice predicate around zero: filters, double-double and intervals never
// contradict the exact sign, and the production predicates give it.
//
// Around an exactly degenerate configuration one point takes all integer places of a square, the finest there
// are; in half of the configurations another point is rational.

#include "../../bench/predicate_questions.h"
#include "around_zero.h"
#include "lattice_samples.h"

using namespace crossloft;
using namespace crossloft::strategies;
using around_zero::Tally;

namespace {

constexpr std::int64_t kRadius = 48;
constexpr std::int64_t kFar = std::int64_t{1} << 48, kSteps = std::int64_t{1} << 27;

using Watched = std::tuple<StaticFilter, SemiStaticFilter, IntervalStrategy, Ball, DoubleDoubleStrategy,
                           Cascade<SemiStaticFilter, DoubleDoubleStrategy, FixedIntegers>, Crossloft>;

LatticeVector moved(const LatticeVector& p, std::int64_t i, const LatticeVector& u, std::int64_t j,
                    const LatticeVector& v) {
  LatticeVector r;
  for (std::size_t k = 0; k < 3; ++k) r[k] = p[k] + i * u[k] + j * v[k];
  return r;
}

/// A configuration with its point of all places: move(i, j) changes the case.
template <class Q, class Move>
void sweep(bench::LatticeCase& c, const Move& move, Tally& tally) {
  ExtentBuilder builder;
  for (const std::int64_t corner : {-kRadius, kRadius}) move(corner, corner), bench::include_case(builder, c);
  const Watched watched{StaticFilter(builder.extent()), {}, {}, {}, {}, {}, {}};
  for (std::int64_t i = -kRadius; i <= kRadius; ++i)
    for (std::int64_t j = -kRadius; j <= kRadius; ++j) {
      move(i, j);
      around_zero::judge<Q>(c, watched, tally);
    }
}

/// configure(generator, store, case, tally) sweeps one configuration.
template <class Q, class Configure>
void sweep_all(const Configure& configure) {
  samples::Generator random(around_zero::kSeed);
  around_zero::ask_enough<Q>([&](Tally& tally) {
    LatticePointStore store;
    bench::LatticeCase c;
    c.plane = random.plane(kNormalLimit, kFar);
    c.planes = {c.plane, c.plane, c.plane, c.plane};
    c.points.fill(make_point(c.plane.origin)), c.in_plane.fill(c.points[0]);
    configure(random, store, c, tally);
  });
}

/// Another plane's point on c.plane, or false.
bool rational_in(const bench::LatticeCase& c, samples::Generator& random, LatticePointStore& store,
                 LatticePoint& point) {
  const LatticePlane other = random.plane(kNormalLimit, kFar);
  return store.meet(c.plane, other, make_axis_plane(static_cast<int>(random.index(3)), random.integer(kFar)),
                    point);
}

/// Points of one plane; the last one asked for moves along two axes.
template <class Q, std::size_t Moving>
void coplanar(samples::Generator& random, LatticePointStore& store, bench::LatticeCase& c, Tally& tally) {
  LatticeVector last{};
  for (std::size_t k = 0; k <= Moving; ++k) {
    last = moved(c.plane.origin, random.integer(kSteps), c.plane.e1, random.integer(kSteps), c.plane.e2);
    c.points[k] = make_point(last);
  }
  if (Moving > 0 && random.chance(50)) rational_in(c, random, store, c.points[0]);
  sweep<Q>(
      c,
      [&](std::int64_t i, std::int64_t j) {
        c.points[Moving] = make_point(moved(last, i, {1, 0, 0}, j, {0, 1, 0}));
      },
      tally);
}

/// Points on one line of the plane, of which the last moves within the plane.
template <class Q, std::size_t Moving>
void collinear(samples::Generator& random, LatticePointStore&, bench::LatticeCase& c, Tally& tally) {
  const std::int64_t u = random.integer(1 << 10), v = random.integer(1 << 10);
  LatticeVector last{};
  for (std::size_t k = 0; k <= Moving; ++k) {
    const std::int64_t t = random.integer(1 << 17);
    last = moved(c.plane.origin, t * u, c.plane.e1, t * v, c.plane.e2);
    c.in_plane[k] = make_point(last);
  }
  sweep<Q>(
      c,
      [&](std::int64_t i, std::int64_t j) {
        c.in_plane[Moving] = make_point(moved(last, i, c.plane.e1, j, c.plane.e2));
      },
      tally);
}

/// Four planes through one point, of which the last moves.
void concurrent(samples::Generator& random, LatticePointStore&, bench::LatticeCase& c, Tally& tally) {
  for (LatticePlane& p : c.planes) {
    p = random.plane(kNormalLimit, kFar);
    p.origin = moved(c.plane.origin, random.integer(kSteps), p.e1, random.integer(kSteps), p.e2);
  }
  const LatticeVector origin = c.planes[3].origin;
  sweep<bench::SideOfMeet>(
      c,
      [&](std::int64_t i, std::int64_t j) {
        c.planes[3].origin = moved(origin, i, {1, 0, 0}, j, {0, 1, 0});
      },
      tally);
}

}  // namespace

TEST_CASE("orient3d of lattice points") {
  sweep_all<bench::LatticeOrient3d>(coplanar<bench::LatticeOrient3d, 3>);
}
TEST_CASE("insphere of lattice points") {
  sweep_all<bench::LatticeInsphere>(coplanar<bench::LatticeInsphere, 4>);
}
TEST_CASE("side_of_plane") { sweep_all<bench::SideOfPlane>(coplanar<bench::SideOfPlane, 0>); }
TEST_CASE("orient2d in a plane") {
  sweep_all<bench::LatticeOrient2d>(collinear<bench::LatticeOrient2d, 2>);
}
TEST_CASE("incircle in a plane") {
  sweep_all<bench::LatticeIncircle>(collinear<bench::LatticeIncircle, 3>);
}
TEST_CASE("side_of_meet") { sweep_all<bench::SideOfMeet>(concurrent); }
