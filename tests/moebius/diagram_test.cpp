#include "../../moebius/diagram.h"

#include <limits>
#include <numeric>
#include <tuple>

#include "diagram_checks.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

/// Integers -reach..reach.
class SmallIntegers {
 public:
  explicit SmallIntegers(unsigned seed) : random_(seed) {}
  double operator()(int reach) { return std::uniform_int_distribution<int>(-reach, reach)(random_); }

 private:
  std::mt19937 random_;
};

std::size_t count_whole(const MoebiusDiagram& diagram) {
  return static_cast<std::size_t>(
      std::count_if(diagram.arcs.begin(), diagram.arcs.end(),
                    [](const MoebiusArc& a) { return a.from == kNone && a.to == kNone; }));
}

using Pairs = std::vector<std::array<std::uint32_t, 2>>;

Pairs neighbours(const MoebiusDiagram& diagram) {
  Pairs pairs;
  for (const MoebiusArc& arc : diagram.arcs) pairs.push_back(arc.sites);
  return pairs;
}

/// Every arc with the names that its sites have after a permutation, its ends as places.
using NamedArc = std::tuple<std::uint32_t, std::uint32_t, std::vector<Vec2>>;

std::vector<NamedArc> named(const MoebiusDiagram& diagram, const std::vector<std::uint32_t>& names) {
  std::vector<NamedArc> arcs;
  for (const MoebiusArc& arc : diagram.arcs) {
    std::uint32_t i = names[arc.sites[0]], j = names[arc.sites[1]], from = arc.from, to = arc.to;
    if (i > j) std::swap(i, j), std::swap(from, to);
    std::vector<Vec2> ends{arc.curve.centre, {arc.curve.radius, 0}};
    for (const std::uint32_t v : {from, to})
      ends.push_back(v == kNone ? Vec2{1e9, 1e9} : diagram.vertices[v]);
    arcs.push_back({i, j, ends});
  }
  std::sort(arcs.begin(), arcs.end());
  return arcs;
}

}  // namespace

TEST_CASE("nothing to divide") {
  CHECK(diagram_of({}).arcs.empty());
  CHECK(checked({{{1, 2}, -3, 4}}, 4, 4).arcs.empty());
  CHECK(checked({{{1, 2}}, {{1, 2}}, {{1, 2}, 1, -1}}, 4, 4).arcs.empty());
  CHECK(checked({{{0, 0}, 0, 1}, {{5, 5}, 0, 2}, {{2, 3}, 0, 2}}, 4, 4).arcs.empty());
}

TEST_CASE("what is no number is refused") {
  const double infinity = std::numeric_limits<double>::infinity(),
               nan = std::numeric_limits<double>::quiet_NaN();
  for (const MoebiusSite& bad :
       Sites{{{nan, 0}}, {{0, infinity}}, {{0, 0}, nan, 0}, {{0, 0}, 1, -infinity}}) {
    const auto result = moebius_diagram(Sites{{{0, 0}}, bad});
    REQUIRE(!result.ok());
    CHECK(result.error().code == ErrorCode::usage);
  }
}

TEST_CASE("two sites: a line or a circle") {
  const MoebiusDiagram line = checked({{{0, 0}}, {{2, 0}}}, 4, 8);
  REQUIRE(line.arcs.size() == 1);
  CHECK(line.arcs[0].curve.is_line);
  CHECK(line.arcs[0].curve.centre == Vec2{1, 0});
  CHECK(line.arcs[0].curve.direction == Vec2{0, 1});  // site 0 on the left
  CHECK(count_whole(line) == 1);
  const MoebiusDiagram circle =
      checked({{{0, 0}}, {{3, 0}, 4, 0}}, 4, 8);  // Apollonius: half as far from site 1
  REQUIRE(circle.arcs.size() == 1);
  CHECK(circle.arcs[0].curve.centre == Vec2{4, 0});
  CHECK(circle.arcs[0].curve.radius == 2);
  CHECK(count_whole(circle) == 1);
  CHECK(checked({{{0, 0}}, {{3, 0}, 4, -12}}, 4, 8).arcs.empty());  // the circle is a point
  CHECK(checked({{{0, 0}}, {{3, 0}, 4, -11}}, 4, 8).arcs.size() == 1);
}

TEST_CASE("a circle keeps its radius where all digits cancel") {
  const double far = 3 * 0x1p27;
  const std::vector<MoebiusSite> sites{{{0, 0}, 1, -3}, {{far, 0}, 4, -12 * 0x1p54}};
  const auto diagram = moebius_diagram(sites);
  REQUIRE(diagram.ok());
  REQUIRE(diagram->arcs.size() == 1);
  CHECK(diagram->arcs[0].curve.radius == 1);
  CHECK(diagram->arcs[0].curve.centre == Vec2{4 * far / 3, 0});
}

TEST_CASE("concentric sites: annuli") {
  const MoebiusDiagram diagram =
      checked({{{1, 1}, 1, -3}, {{1, 1}, 4, 0}, {{1, 1}, 2, -1}, {{1, 1}, 3, -9}}, 4, 16);
  CHECK(count_whole(diagram) == 2);
  CHECK(diagram.arcs.size() == 2);
}

TEST_CASE("four cells at one point: two vertices in one place") {
  const MoebiusDiagram diagram = checked({{{0, 0}}, {{2, 0}}, {{2, 2}}, {{0, 2}}}, 4, 8);
  REQUIRE(diagram.vertices.size() == 2);
  CHECK(diagram.vertices[0] == Vec2{1, 1});
  CHECK(diagram.vertices[1] == Vec2{1, 1});
  CHECK(diagram.arcs.size() == 5);
}

TEST_CASE("a grid") {
  Sites sites;
  for (int k = 0; k < 36; ++k) sites.push_back({{double(k % 6), double(k / 6)}});
  const MoebiusDiagram diagram = checked(sites, 7, 28);
  CHECK(diagram.vertices.size() == 50);
  CHECK(diagram.arcs.size() == 85);
}

TEST_CASE("a circle that touches a line does not cut it") {
  // Half as far from the third site as from the first: through the origin, left of the line of the first two.
  const Sites sites{{{-1, 0}}, {{1, 0}}, {{-0.5, 0}, 4, 0}};
  const MoebiusDiagram touching = checked(sites, 4, 16);
  CHECK(touching.vertices.empty());
  CHECK(count_whole(touching) == 2);
  Sites wider = sites, narrower = sites;
  wider[2].mu = 0x1p-50;
  CHECK(diagram_of(wider).vertices.size() == 2);
  narrower[2].mu = -0x1p-50;
  CHECK(diagram_of(narrower).vertices.empty());
}

TEST_CASE("multiplicative weights: ratios of distances") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  Sites sites;
  for (int k = 0; k < 40; ++k) sites.push_back({{unit(random), unit(random)}, 0.2 + unit(random), 0});
  const MoebiusDiagram diagram = checked(sites, 1.5, 40);
  CHECK(diagram.arcs.size() > 60);
  for (const MoebiusArc& arc : diagram.arcs) {
    const Vec2 x = ArcPath(diagram, arc, 1).point(0.4);
    const MoebiusSite &a = sites[arc.sites[0]], &b = sites[arc.sites[1]];
    CHECK(length(x - a.p) / length(x - b.p) == doctest::Approx(std::sqrt(b.lambda / a.lambda)));
  }
}

TEST_CASE("neither the order of the sites nor a power of two changes a bit") {
  const unsigned seed = 31;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int round = 0; round < 20; ++round) {
    Sites sites, shuffled, scaled;
    const double size = std::ldexp(1.0, 10 * round - 100);
    for (int k = 0; k < 30; ++k)
      sites.push_back({{std::round(8 * unit(random)), std::round(8 * unit(random))},
                       round % 2 ? 1 : 3 + std::round(2 * unit(random)),
                       std::round(9 * unit(random))});
    std::vector<std::uint32_t> names(sites.size()), same(sites.size());
    std::iota(names.begin(), names.end(), 0u);
    std::iota(same.begin(), same.end(), 0u);
    std::shuffle(names.begin(), names.end(), random);
    for (const std::uint32_t k : names) shuffled.push_back(sites[k]);
    for (const MoebiusSite& s : sites) scaled.push_back({size * s.p, s.lambda, size * size * s.mu});
    const MoebiusDiagram diagram = diagram_of(sites), big = diagram_of(scaled);
    // Of equal sites another one has the cell then: only where all differ the names agree.
    std::vector<std::tuple<Vec2, double, double>> rows;
    for (const MoebiusSite& s : sites) rows.push_back({s.p, s.lambda, s.mu});
    std::sort(rows.begin(), rows.end());
    if (std::adjacent_find(rows.begin(), rows.end()) == rows.end())
      CHECK(named(diagram_of(shuffled), names) == named(diagram, same));
    CHECK(neighbours(big) == neighbours(diagram));
    REQUIRE(big.vertices.size() == diagram.vertices.size());
    for (std::size_t v = 0; v < big.vertices.size(); ++v)
      CHECK(big.vertices[v] == size * diagram.vertices[v]);
  }
}

TEST_CASE("far from the origin") {
  const unsigned seed = 32;
  INFO("seed " << seed);
  SmallIntegers random(seed);
  for (int round = 0; round < 100; ++round) {
    Sites sites, moved;
    for (int k = 0; k < 12; ++k) sites.push_back({{random(9), random(9)}, 2 + random(round % 3), random(9)});
    const Vec2 away{0x1p40, -0x1p39};
    for (const MoebiusSite& s : sites) moved.push_back({s.p + away, s.lambda, s.mu});
    const MoebiusDiagram here = diagram_of(sites), there = diagram_of(moved);
    CHECK(verify(there) == "");
    CHECK(neighbours(there) == neighbours(here));
    REQUIRE(there.vertices.size() == here.vertices.size());
    for (std::size_t v = 0; v < here.vertices.size(); ++v)
      CHECK(length(there.vertices[v] - away - here.vertices[v]) < 1e-3);
  }
}

TEST_CASE("random small integers: every tie there is") {
  const unsigned seed = 4711;
  INFO("seed " << seed);
  SmallIntegers random(seed);
  for (int round = 0; round < 1500; ++round) {
    Sites sites;
    const int n = 1 + round % 7, reach = 1 + round % 3;
    for (int k = 0; k < n; ++k)
      sites.push_back({{random(reach), random(reach)},
                       random(round % 5 == 0 ? 0 : 2) + (round % 5 == 0),
                       random(round % 4)});
    checked(sites, 4, 12);
  }
}

TEST_CASE("random reals") {
  const unsigned seed = 815;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int round = 0; round < 300; ++round) {
    Sites sites;
    for (int k = 0; k < 2 + round % 30; ++k)
      sites.push_back({{unit(random), unit(random)},
                       round % 3 ? unit(random) + round % 4 : 1.0,
                       round % 2 ? unit(random) : 0.0});
    checked(sites, 1.5, 24);
  }
}
