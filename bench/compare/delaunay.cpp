// Delaunay triangulations of points in space against CGAL's, on the point sets of point_distributions.h. Both
// get the points as they are (in random order but for the curves) and sort them themselves: CGAL by its range
// insertion. Our time includes the mesh as plain arrays.
//
//   bench_compare_delaunay --benchmark_filter=uniform

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <benchmark/benchmark.h>

#include "../../delaunay/triangulation.h"
#include "../point_distributions.h"
#include "duel.h"

namespace {

using namespace crossloft;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

void against_cgal(benchmark::State& state, const std::vector<Vec3>& points, unsigned threads = 1) {
  std::vector<Kernel::Point_3> theirs;
  for (const Vec3& p : points) theirs.emplace_back(p.x, p.y, p.z);
  bench::Duel duel;
  std::size_t tets = 0, their_tets = 0;
  for (auto _ : state)
    duel.round([&] { tets = delaunay_triangulation(points, threads).tets.size(); },
               [&] {
                 const CGAL::Delaunay_triangulation_3<Kernel> triangulation(theirs.begin(), theirs.end());
                 their_tets = triangulation.number_of_finite_cells();
               });
  if (tets != their_tets) state.SkipWithError("not the same number of tetrahedra");
  duel.report(state);
}

void two_threads(benchmark::State& state) {
  const std::vector<Vec3> points = bench::uniform_cube(static_cast<std::size_t>(state.range(0)));
  bench::Duel duel;
  for (auto _ : state)
    duel.round([&] { delaunay_triangulation(points, 2); }, [&] { delaunay_triangulation(points, 1); });
  duel.report(state);
}

void uniform(benchmark::State& state) {
  against_cgal(state, bench::uniform_cube(static_cast<std::size_t>(state.range(0))));
}
void curves(benchmark::State& state) { against_cgal(state, bench::curves_on_planes(20, 2000)); }
void unit_sphere(benchmark::State& state) { against_cgal(state, bench::sphere(200'000, 1)); }
void integer_sphere(benchmark::State& state) { against_cgal(state, bench::integer_sphere(200'000, 1e6)); }
void grid_50(benchmark::State& state) { against_cgal(state, bench::grid(50)); }

BENCHMARK(uniform)->Arg(100'000)->Iterations(7)->Unit(benchmark::kMillisecond);
BENCHMARK(uniform)->Arg(1'000'000)->Iterations(3)->Unit(benchmark::kMillisecond);
BENCHMARK(curves)->Iterations(5)->Unit(benchmark::kMillisecond);
BENCHMARK(unit_sphere)->Iterations(3)->Unit(benchmark::kMillisecond);
BENCHMARK(integer_sphere)->Iterations(5)->Unit(benchmark::kMillisecond);
BENCHMARK(grid_50)->Iterations(5)->Unit(benchmark::kMillisecond);
BENCHMARK(two_threads)->Arg(1'000'000)->Iterations(3)->Unit(benchmark::kMillisecond);

}  // namespace
