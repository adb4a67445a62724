// Microseconds per cell of build_arrangement, cells counted beside it. The planes meet a ball of half the
// box's size, so most common points lie inside the box.
//
//   bench_arrangement --benchmark_filter=random --benchmark_repetitions=5

#include <benchmark/benchmark.h>

#include <random>
#include <vector>

#include "../arrangement/complex.h"

namespace {

using namespace crossloft;

constexpr std::int64_t kBox = std::int64_t{1} << 49;

class PlaneSource {
 public:
  /// `spread` bounds the components of e1 and e2: 2^12 gives normals of 24 bits, which frames have, 2^19 the
  /// widest that are legal.
  explicit PlaneSource(std::int64_t spread) : spread_(spread) {}

  std::vector<LatticePlane> random(std::size_t count) {
    std::vector<LatticePlane> planes;
    for (std::size_t i = 0; i < count; ++i) planes.push_back(plane(in_ball(), vector(spread_)));
    return planes;
  }
  /// All through one line.
  std::vector<LatticePlane> pencil(std::size_t count) {
    const LatticeVector origin = in_ball(), axis = vector(spread_);
    std::vector<LatticePlane> planes;
    for (std::size_t i = 0; i < count; ++i) planes.push_back(plane(origin, axis));
    return planes;
  }
  /// In `directions` stacks of equal normals.
  std::vector<LatticePlane> parallel(std::size_t count, std::size_t directions) {
    std::vector<LatticePlane> planes = random(directions);
    while (planes.size() < count) {
      LatticePlane next = planes[planes.size() - directions];
      next.origin = in_ball();
      planes.push_back(next);
    }
    return planes;
  }

 private:
  std::int64_t integer(std::int64_t bound) {
    return static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(2 * bound + 1)) - bound;
  }
  LatticeVector vector(std::int64_t bound) { return {integer(bound), integer(bound), integer(bound)}; }
  LatticeVector in_ball() {
    for (;;) {
      const LatticeVector v = vector(kBox / 2);
      double squares = 0;
      for (const std::int64_t c : v) squares += static_cast<double>(c) * static_cast<double>(c);
      if (squares <= static_cast<double>(kBox / 2) * static_cast<double>(kBox / 2)) return v;
    }
  }
  LatticePlane plane(const LatticeVector& origin, const LatticeVector& e1) {
    for (;;) {
      const LatticePlane p = make_lattice_plane(origin, e1, vector(spread_));
      if (p.normal != LatticeVector{}) return p;
    }
  }

  std::int64_t spread_;
  std::mt19937_64 engine_{40};
};

void run(benchmark::State& state, const std::vector<LatticePlane>& planes) {
  std::uint32_t cells = 0;
  for (auto _ : state) {
    LatticePointStore store;
    const auto result = build_arrangement(planes, centred_box(kBox), store);
    if (!result.ok()) return state.SkipWithError("no arrangement");
    cells = result->cell_count();
  }
  state.counters["cells"] = cells;
  // Google Benchmark prints the inverse of a rate as a time: seconds a cell.
  state.counters["per_cell"] =
      benchmark::Counter(cells, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

std::size_t count_of(const benchmark::State& state) { return static_cast<std::size_t>(state.range(0)); }

void random_planes(benchmark::State& state) {
  run(state, PlaneSource(std::int64_t{1} << 12).random(count_of(state)));
}
void random_widest(benchmark::State& state) {
  run(state, PlaneSource(std::int64_t{1} << 19).random(count_of(state)));
}
void pencil_and_random(benchmark::State& state) {
  PlaneSource source(std::int64_t{1} << 12);
  std::vector<LatticePlane> planes = source.pencil(count_of(state));
  for (const LatticePlane& p : source.random(count_of(state) / 4)) planes.push_back(p);
  run(state, planes);
}
void three_stacks(benchmark::State& state) {
  run(state, PlaneSource(std::int64_t{1} << 12).parallel(count_of(state), 3));
}
/// All vertices integral, and every second test of a plane meets ties.
void axis_grid(benchmark::State& state) {
  std::vector<LatticePlane> planes;
  for (std::int64_t i = 0; i < state.range(0); ++i)
    planes.push_back(make_axis_plane(static_cast<int>(i % 3), (i - state.range(0) / 2) * (kBox / 100)));
  run(state, planes);
}

BENCHMARK(random_planes)->Arg(10)->Arg(20)->Arg(40)->Arg(80)->Unit(benchmark::kMillisecond);
BENCHMARK(random_widest)->Arg(10)->Arg(20)->Arg(40)->Arg(80)->Unit(benchmark::kMillisecond);
BENCHMARK(pencil_and_random)->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK(three_stacks)->Arg(40)->Unit(benchmark::kMillisecond);
BENCHMARK(axis_grid)->Arg(40)->Unit(benchmark::kMillisecond);

}  // namespace
