// The regular triangulation against CGAL's on the same weighted points, one thread each. Ours is given the
// points in random order as CGAL is (range insertion, which sorts them along a curve), and its time includes
// making the mesh as plain arrays.
//
//   bench_compare_regular

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "../../delaunay/triangulation.h"
#include "duel.h"

namespace {

using namespace crossloft;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr std::size_t kCount = 100'000;
constexpr int kIterations = 7;

/// Uniform in the unit cube, weights uniform in [0, heaviest).
std::vector<WeightedPoint> random_sites(double heaviest) {
  std::mt19937_64 engine(1);
  const auto draw = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  std::vector<WeightedPoint> sites;
  for (std::size_t i = 0; i < kCount; ++i) {
    const double x = draw(), y = draw(), z = draw();
    sites.push_back({{x, y, z}, heaviest * draw()});
  }
  return sites;
}

/// The argument is the largest weight times 10^6.
void regular(benchmark::State& state) {
  const std::vector<WeightedPoint> sites = random_sites(1e-6 * static_cast<double>(state.range(0)));
  std::vector<Kernel::Weighted_point_3> theirs;
  for (const WeightedPoint& s : sites)
    theirs.push_back({Kernel::Point_3(s.position.x, s.position.y, s.position.z), s.weight});
  bench::Duel duel;
  std::size_t tets = 0, their_tets = 0, hidden = 0;
  for (auto _ : state)
    duel.round(
        [&] {
          const Triangulation triangulation = regular_triangulation(sites);
          tets = triangulation.tets.size();
          hidden = static_cast<std::size_t>(
              std::count(triangulation.kept.begin(), triangulation.kept.end(), kNone));
        },
        [&] {
          const CGAL::Regular_triangulation_3<Kernel> triangulation(theirs.begin(), theirs.end());
          their_tets = triangulation.number_of_finite_cells();
        });
  if (tets != their_tets) state.SkipWithError("not the same number of tetrahedra");
  duel.report(state);
  state.counters["hidden_%"] = 100.0 * static_cast<double>(hidden) / kCount;
}

BENCHMARK(regular)->Arg(100)->Arg(300)->Arg(1000)->Iterations(kIterations)->Unit(benchmark::kMillisecond);

}  // namespace
