// Our triangulations in space against CGAL's on the same points, one thread each. Every iteration runs both,
// taking turns at being first; the counters are medians over the iterations: milliseconds of CPU time and
// ours / CGAL's. Ours is given the points in random order as CGAL is (range insertion, which sorts them along
// a curve), and its time includes making the mesh as plain arrays.
//
//   bench_compare_triangulations

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <random>
#include <vector>

#include "../../delaunay/delaunay3.h"
#include "../../delaunay/lattice_predicates.h"
#include "../../delaunay/triangulation.h"
#include "../../delaunay/vec3_predicates.h"

namespace {

using namespace crossloft;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr std::size_t kCount = 100'000;
constexpr int kIterations = 7;

double cpu_milliseconds() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

/// Both times and the ratio of each iteration; its medians become the counters.
class Duel {
 public:
  template <class Ours, class Theirs>
  void round(const Ours& ours, const Theirs& theirs) {
    const auto time = [](const auto& run) {
      const double start = cpu_milliseconds();
      run();
      return cpu_milliseconds() - start;
    };
    const bool first = ours_.size() % 2 == 0;
    const double a = first ? time(ours) : time(theirs), b = first ? time(theirs) : time(ours);
    ours_.push_back(first ? a : b);
    theirs_.push_back(first ? b : a);
    ratio_.push_back(ours_.back() / theirs_.back());
  }
  void report(benchmark::State& state) const {
    state.counters["ours_ms"] = median(ours_);
    state.counters["cgal_ms"] = median(theirs_);
    state.counters["ratio"] = median(ratio_);
  }

 private:
  std::vector<double> ours_, theirs_, ratio_;
};

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
  Duel duel;
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

template <class Predicates, class Point>
std::size_t delaunay_tets(const std::vector<Point>& points) {
  const Predicates predicates(points);
  Delaunay3 triangulation(predicates);
  triangulation.build();
  return triangulation.tet_mesh().size();
}

template <class Predicates, class Point>
void against_cgal_delaunay(benchmark::State& state, const std::vector<Point>& points) {
  std::vector<Kernel::Point_3> theirs;
  for (const Point& p : points) theirs.emplace_back(p.x, p.y, p.z);
  Duel duel;
  std::size_t tets = 0, their_tets = 0;
  for (auto _ : state)
    duel.round([&] { tets = delaunay_tets<Predicates>(points); },
               [&] {
                 const CGAL::Delaunay_triangulation_3<Kernel> triangulation(theirs.begin(), theirs.end());
                 their_tets = triangulation.number_of_finite_cells();
               });
  if (tets != their_tets) state.SkipWithError("not the same number of tetrahedra");
  duel.report(state);
}

void delaunay_doubles(benchmark::State& state) {
  std::vector<Vec3> points;
  for (const WeightedPoint& s : random_sites(0)) points.push_back(s.position);
  against_cgal_delaunay<Vec3Predicates3>(state, points);
}

void delaunay_lattice(benchmark::State& state) {
  std::vector<LatticePoint> points;
  const auto whole = [](double v) { return static_cast<std::int64_t>(v * 0x1p+50); };
  for (const WeightedPoint& s : random_sites(0))
    points.push_back(make_point({whole(s.position.x), whole(s.position.y), whole(s.position.z)}));
  against_cgal_delaunay<LatticePredicates3>(state, points);
}

BENCHMARK(regular)->Arg(100)->Arg(300)->Arg(1000)->Iterations(kIterations)->Unit(benchmark::kMillisecond);
BENCHMARK(delaunay_doubles)->Iterations(kIterations)->Unit(benchmark::kMillisecond);
BENCHMARK(delaunay_lattice)->Iterations(kIterations)->Unit(benchmark::kMillisecond);

}  // namespace
