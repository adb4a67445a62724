// Every strategy of the list against rationals, on every distribution of the benchmarks and on doubles that
// over- and underflow; what each guarantees is what it is held to.

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "../../geom/strategies/list.h"
#include "example_strategy.h"
#include "question_reference.h"
#include "random_doubles.h"

using namespace crossloft;
using namespace crossloft::strategies;

namespace {

constexpr std::uint64_t kSeed = 20261125;
constexpr std::size_t kCount = 40;

/// Exact strategies must give the answer, filters may not know, no more is asked of the naive one.
template <class S>
bool keeps_promise(Verdict verdict, int expected) {
  if (S::kGuarantee == Guarantee::exact) return verdict == expected;
  if (S::kGuarantee == Guarantee::filter) return verdict == expected || verdict == kUnknown;
  return verdict >= -1 && verdict <= 1;
}

template <class Questions, class Case>
void check_all(const bench::CaseSet<Case>& set, bool print = true) {
  bench::for_each_question<Questions>([&]<class Q>() {
    std::vector<int> expected;
    for (const Case& c : set.cases) expected.push_back(reference::answer(Q{}, c));
    const Extent extent = bench::extent_of(set.cases);
    for_each_strategy([&]<class S>() {
      const S strategy(extent);
      std::size_t broken = 0, unknown = 0;
      for (std::size_t i = 0; i < set.cases.size(); ++i) {
        const Verdict verdict = Q::ask(strategy, set.cases[i]);
        broken += !keeps_promise<S>(verdict, expected[i]);
        unknown += verdict == kUnknown;
      }
      INFO(std::string(S::kName) << ", " << std::string(Q::kName) << ", " << set.name);
      CHECK(broken == 0);
      if (print && S::kGuarantee == Guarantee::filter && set.name == "random") CHECK(unknown < kCount / 4);
    });
  });
}

/// Coordinates of any exponent in a band, some repeated, so that differences vanish.
template <class Case, class Make>
bench::CaseSet<Case> extremes(int low, int high, Doubles& random, const Make& make) {
  bench::CaseSet<Case> set{"exponents " + std::to_string(low) + " to " + std::to_string(high), {}};
  for (std::size_t i = 0; i < kCount; ++i) {
    std::array<double, 4> pool;
    for (double& v : pool) v = random.value(low, high);
    const auto draw = [&] { return i % 2 == 0 ? random.value(low, high) : pool[random.index(4)]; };
    Case c;
    for (auto& p : c) p = make(draw);
    set.cases.push_back(c);
  }
  return set;
}

struct Band {
  int low, high;
};
constexpr std::array<Band, 8> kBands{Band{-1074, 1023}, Band{-1074, -1000}, Band{1000, 1023}, Band{-40, 40},
                                     Band{-300, 300},   Band{-160, 190},    Band{-170, -150}, Band{180, 200}};

}  // namespace

TEST_CASE("doubles in the plane") {
  MESSAGE("seed " << kSeed);
  for (const auto& set : bench::planar_cases(kCount, kSeed)) check_all<bench::PlanarQuestions>(set);
}

TEST_CASE("doubles in space, with and without weights") {
  MESSAGE("seed " << kSeed);
  for (const auto& set : bench::space_cases(kCount, kSeed, {})) check_all<bench::SpaceQuestions>(set);
}

TEST_CASE("lattice points of every kind") {
  MESSAGE("seed " << kSeed);
  LatticePointStore store;
  for (const auto& set : bench::lattice_cases(kCount, kSeed, store)) check_all<bench::LatticeQuestions>(set);
}

TEST_CASE("products that over- and underflow") {
  MESSAGE("seed " << kSeed);
  Doubles random(kSeed);
  for (const Band& band : kBands) {
    check_all<bench::PlanarQuestions>(
        extremes<bench::PlanarCase>(band.low, band.high, random, [](const auto& draw) {
          const double x = draw();
          return Vec2{x, draw()};
        }));
    check_all<bench::SpaceQuestions>(
        extremes<bench::SpaceCase>(band.low, band.high, random, [](const auto& draw) {
          const double x = draw(), y = draw(), z = draw();
          return WeightedPoint{{x, y, z}, draw()};
        }));
  }
}

TEST_CASE("weights of another size than the coordinates' squares") {
  MESSAGE("seed " << kSeed);
  Doubles random(kSeed + 1);
  for (const Band& weights : kBands)
    check_all<std::tuple<bench::PowerTest>>(
        extremes<bench::SpaceCase>(-30, 30, random, [&](const auto& draw) {
          const double x = draw(), y = draw(), z = draw();
          return WeightedPoint{{x, y, z}, random.value(weights.low, weights.high)};
        }));
}

TEST_CASE("NaN and infinity: exact strategies say 0, filters don't know") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const bench::PlanarCase flat{Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}, Vec2{1, 1}};
  const bench::SpaceCase solid{WeightedPoint{{0, 0, 0}, 0}, WeightedPoint{{1, 0, 0}, 0},
                               WeightedPoint{{0, 1, 0}, 0}, WeightedPoint{{0, 0, 1}, 0},
                               WeightedPoint{{1, 1, 1}, 0}};
  const auto check = [&]<class Questions>(Questions*, const auto& c, const Extent& extent) {
    bench::for_each_question<Questions>([&]<class Q>() {
      for_each_strategy([&]<class S>() {
        INFO(std::string(S::kName) << ", " << std::string(Q::kName));
        if (S::kGuarantee == Guarantee::exact) CHECK(Q::ask(S(extent), c) == 0);
        if (S::kGuarantee == Guarantee::filter) CHECK(Q::ask(S(extent), c) == kUnknown);
      });
    });
  };
  for (const double bad : {nan, inf, -inf})
    for (std::size_t i = 0; i < 3; ++i) {
      bench::PlanarCase p = flat;
      (i % 2 == 0 ? p[i].x : p[i].y) = bad;
      check(static_cast<bench::PlanarQuestions*>(nullptr), p, bench::extent_of(std::vector{p}));
      bench::SpaceCase q = solid;
      (i == 0 ? q[i].position.x : i == 1 ? q[i].position.y : q[i].position.z) = bad;
      check(static_cast<bench::SpaceQuestions*>(nullptr), q, bench::extent_of(std::vector{q}));
      bench::SpaceCase w = solid;
      w[i].weight = bad;
      check(static_cast<std::tuple<bench::PowerTest>*>(nullptr), w, bench::extent_of(std::vector{w}));
    }
}

TEST_CASE("laws: an exchange of two points negates every known answer") {
  MESSAGE("seed " << kSeed);
  for (const auto& set : bench::space_cases(kCount, kSeed + 2, {})) {
    const Extent extent = bench::extent_of(set.cases);
    bench::for_each_question<bench::SpaceQuestions>([&]<class Q>() {
      for_each_strategy([&]<class S>() {
        if constexpr (S::kGuarantee == Guarantee::exact) {
          const S strategy(extent);
          std::size_t broken = 0;
          for (std::size_t i = 0; i < set.cases.size(); ++i) {
            bench::SpaceCase c = set.cases[i];
            std::swap(c[i % 4], c[(i + 1) % 4]);
            broken += Q::ask(strategy, c) != -Q::ask(strategy, set.cases[i]);
          }
          INFO(std::string(S::kName) << ", " << std::string(Q::kName) << ", " << set.name);
          CHECK(broken == 0);
        }
      });
    });
  }
}

TEST_CASE("a cascade tells its stage, and a counted strategy its histogram") {
  using Both = Cascade<SemiStaticFilter, FixedIntegers>;
  static_assert(Strategy<Both> && Strategy<Counted<Both>> && Both::kGuarantee == Guarantee::exact);
  static_assert(Both::kName == "semi-static > fixed");
  const Vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0}, up{0, 0, 1}, flat{1, 1, 0};
  const Both both;
  const auto at = [&](const Vec3& d) {
    return both.decide([&](const auto& s) { return s.orient3d(a, b, c, d); });
  };
  CHECK((at(up).verdict == 1 && at(up).stage == 0));
  CHECK((at(flat).verdict == 0 && at(flat).stage == 1));
  const Counted<Both> counted;
  CHECK(counted.orient3d(a, b, c, up) == 1);
  CHECK(counted.orient3d(a, b, c, flat) == 0);
  CHECK(counted.orient3d(a, b, c, flat) == 0);
  CHECK(counted.counts() == std::array<std::uint64_t, 3>{1, 2, 0});
  const Counted<SemiStaticFilter> filter;
  CHECK(filter.orient3d(a, b, c, flat) == kUnknown);
  CHECK(filter.counts() == std::array<std::uint64_t, 2>{0, 1});
}

TEST_CASE("the example of docs/strategies.md is the file that is compiled here, and it works") {
  const auto text_of = [](const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(std::string(CROSSLOFT_SOURCE_DIR "/") + path).rdbuf();
    return text.str();
  };
  const std::string example = text_of("tests/geom/example_strategy.h");
  const std::string body = example.substr(example.find("namespace"));
  CHECK(text_of("docs/strategies.md").find(body) != std::string::npos);
  CHECK(LongDouble().orient3d(Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 0x1p-60}) == 1);
  CHECK(LongDouble().orient3d(Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{1, 1, 0}) == 0);
}
