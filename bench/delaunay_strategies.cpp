// The Delaunay triangulation in space under every strategy that can carry it: milliseconds, multiple of the
// product, and which stage decided how often. The product, the last row, has bounds for the set of points and
// lifts them; the row "crossloft" has its predicates alone.
//
//   bench_delaunay_strategies [POINTS] [REPETITIONS]        default 20000 points, 5 repetitions
//
// Exact strategies run on everything. The naive one runs on random points only: elsewhere its wrong signs can
// make a triangulation loop or break. Filters alone do not run, nor strategies that would take longer than
// some ten seconds a triangulation, judged by the first thousand points.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "../delaunay/delaunay3.h"
#include "../delaunay/vec3_predicates.h"
#include "../geom/strategies/list.h"
#include "measurement.h"
#include "predicate_cases.h"
#include "strategy_predicates.h"

namespace {

using namespace crossloft;
using namespace crossloft::bench;
using namespace crossloft::strategies;

static_assert(PointPredicates3<StrategyPredicates3<Crossloft>>);

/// All different points of a distribution, shuffled.
std::vector<Vec3> distinct_points(const CaseSet<SpaceCase>& set, std::size_t count) {
  std::set<Vec3> seen;
  std::vector<Vec3> points;
  for (const SpaceCase& c : set.cases)
    for (const WeightedPoint& p : c)
      if (points.size() < count && seen.insert(p.position).second) points.push_back(p.position);
  return points;
}

std::vector<Vec3> grid(std::size_t count) {
  std::vector<Vec3> points;
  const auto edge = static_cast<int>(std::cbrt(static_cast<double>(count)));
  for (int x = 0; x < edge; ++x)
    for (int y = 0; y < edge; ++y)
      for (int z = 0; z < edge; ++z) points.push_back({double(x), double(y), double(z)});
  std::mt19937_64 engine(1);
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[engine() % i]);
  return points;
}

template <class P>
std::size_t triangulate(const P& predicates) {
  Delaunay3 triangulation(predicates);
  triangulation.build();
  return triangulation.tet_mesh().size();
}

template <class S>
std::string stages(std::span<const Vec3> points, const Extent& extent) {
  if (StagesOf<S>::kCount == 1) return {};
  const StrategyPredicates3<Counted<S>> counted(points, Counted<S>(extent));
  triangulate(counted);
  const auto& counts = counted.strategy().counts();
  std::uint64_t sum = 0;
  for (const std::uint64_t n : counts) sum += n;
  std::string text;
  for (std::size_t i = 0; i + 1 < counts.size(); ++i) {
    char share[32];
    std::snprintf(share, sizeof share, "%s%.3f", i == 0 ? "" : " / ",
                  100 * static_cast<double>(counts[i]) / static_cast<double>(sum));
    text += share;
  }
  return text;
}

constexpr double kPatience = 10;  // seconds
constexpr std::size_t kProbe = 1000;

/// Seconds that all points are likely to take, from the first of them.
template <class S>
double foreseen(std::span<const Vec3> points, const Extent& extent) {
  const auto few = points.first(std::min(points.size(), kProbe));
  const StrategyPredicates3<S> predicates(few, S(extent));
  const auto start = std::chrono::steady_clock::now();
  triangulate(predicates);
  const double taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return taken * static_cast<double>(points.size()) / static_cast<double>(few.size());
}

struct Row {
  std::string name, stages;
  std::size_t tets;
};

void compare(const std::string& name, const std::vector<Vec3>& points, int repetitions) {
  std::printf("\n%s, %zu points\n", name.c_str(), points.size());
  ExtentBuilder builder;
  for (const Vec3& p : points) builder.include(p);
  for (const Vec3& corner : {Vec3{0, 0, 0}, Vec3{1, 1, 1}}) builder.include(corner);  // for collinear()
  const Extent extent = builder.extent();
  std::vector<Row> rows;
  std::vector<Contestant> contestants;
  const auto enter = [&](std::string_view strategy, std::string decided, const auto& predicates) {
    rows.push_back({std::string(strategy), std::move(decided), triangulate(predicates)});
    contestants.push_back({[predicates](std::size_t calls) {
      for (; calls > 0; --calls) triangulate(predicates);
    }});
  };
  for_each_strategy([&]<class S>() {
    if (S::kGuarantee == Guarantee::filter) return;
    if (S::kGuarantee == Guarantee::none && name != "random") return;
    if (const double seconds = foreseen<S>(points, extent); seconds > kPatience) {
      std::printf("  %s: left out, some %.0f seconds\n", std::string(S::kName).c_str(), seconds);
      return;
    }
    enter(S::kName, stages<S>(points, extent), StrategyPredicates3<S>(points, S(extent)));
  });
  enter("the product", {}, Vec3Predicates3(points));
  const std::vector<double> times = take_turns(std::move(contestants), repetitions, 0, 1);
  const double own = times.back();
  std::printf("  milliseconds, multiple of the product, tetrahedra, stages in %%\n");
  for (std::size_t i = 0; i < rows.size(); ++i)
    std::printf("  %-50s %9.1f %7.2fx %9zu%s  %s\n", rows[i].name.c_str(), 1e-6 * times[i], times[i] / own,
                rows[i].tets, rows[i].tets == rows.back().tets ? "" : " WRONG", rows[i].stages.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 20'000;
  const int repetitions = argc > 2 ? std::max(1, std::atoi(argv[2])) : 5;
  for (const auto& set : space_cases(count, 1, {})) {
    if (set.name == "coplanar, z = const" || set.name == "coplanar, oblique") continue;  // no tetrahedra
    compare(set.name, set.name == "integer grid" ? grid(count) : distinct_points(set, count), repetitions);
  }
}
