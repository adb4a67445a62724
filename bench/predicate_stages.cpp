// Nanoseconds of single stages of the lattice predicates: the inlined filter's hit, the exact stage by kind
// of point, the width on doubles, the construction of a point. All on random points, so nothing is degenerate
// unless the name says so. bench_predicates compares whole predicates.
//
//   bench_predicate_stages --benchmark_min_time=0.2

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "../geom/lattice_filters.h"
#include "../geom/predicates.h"

namespace {

using namespace crossloft;

constexpr std::size_t kCount = 1024;  // fits the cache: the arithmetic is timed, not the memory

struct Data {
  LatticePointStore store;
  std::vector<LatticePlane> planes;
  std::vector<LatticePoint> integral, rational;
  std::vector<Vec3> doubles;

  Data() {
    std::mt19937_64 engine(1);
    const auto integer = [&](std::int64_t limit) {
      return static_cast<std::int64_t>(engine() % (2 * static_cast<std::uint64_t>(limit) + 1)) - limit;
    };
    const auto vector = [&](std::int64_t limit) {
      return LatticeVector{integer(limit), integer(limit), integer(limit)};
    };
    for (std::size_t i = 0; i < kCount + 8; ++i) {
      planes.push_back(make_lattice_plane(vector(kLatticeLimit), vector(1 << 19), vector(1 << 19)));
      integral.push_back(make_point(vector(kLatticeLimit)));
      const LatticePoint& p = integral.back();
      doubles.push_back(0x1p-50 * Vec3{p.x, p.y, p.z});
    }
    while (rational.size() < kCount + 8) {
      const auto any = [&]() -> const LatticePlane& { return planes[engine() % planes.size()]; };
      LatticePoint p;
      if (store.meet(any(), any(), any(), p)) rational.push_back(p);
    }
  }
};

const Data& data() {
  static const Data d;
  return d;
}

/// f(i) for i = 0, 1, ..., round and round.
template <class F>
void run(benchmark::State& state, const F& f) {
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(f(i));
    i = (i + 1) % kCount;
  }
}

void orient3d_filter_inline(benchmark::State& state) {
  const auto& p = data().integral;
  run(state, [&](std::size_t i) { return orient3d_filter(p[i], p[i + 1], p[i + 2], p[i + 3]); });
}
void insphere_filter_inline(benchmark::State& state) {
  const auto& p = data().integral;
  run(state, [&](std::size_t i) { return insphere_filter(p[i], p[i + 1], p[i + 2], p[i + 3], p[i + 4]); });
}
void orient3d_filter_rational(benchmark::State& state) {
  const auto& p = data().rational;
  run(state, [&](std::size_t i) { return orient3d_filter(p[i], p[i + 1], p[i + 2], p[i + 3]); });
}
void insphere_filter_rational(benchmark::State& state) {
  const auto& p = data().rational;
  run(state, [&](std::size_t i) { return insphere_filter(p[i], p[i + 1], p[i + 2], p[i + 3], p[i + 4]); });
}

/// The exact stage with `rational` of the points rational.
void orient3d_exact_stage(benchmark::State& state) {
  const auto rational = static_cast<std::size_t>(state.range(0));
  const auto at = [&](std::size_t i, std::size_t k) {
    return k < rational ? data().rational[i + k] : data().integral[i + k];
  };
  run(state, [&](std::size_t i) { return orient3d_exact(at(i, 0), at(i, 1), at(i, 2), at(i, 3)); });
}
void insphere_exact_stage(benchmark::State& state) {
  const auto rational = static_cast<std::size_t>(state.range(0));
  const auto at = [&](std::size_t i, std::size_t k) {
    return k < rational ? data().rational[i + k] : data().integral[i + k];
  };
  run(state, [&](std::size_t i) { return insphere_exact(at(i, 0), at(i, 1), at(i, 2), at(i, 3), at(i, 4)); });
}
void incircle_exact_stage(benchmark::State& state) {
  const auto& p = data().integral;
  const auto& planes = data().planes;
  run(state, [&](std::size_t i) { return incircle_exact(planes[i], p[i], p[i + 1], p[i + 2], p[i + 3]); });
}

void meet_three_planes(benchmark::State& state) {
  const auto& p = data().planes;
  LatticePointStore store;
  run(state, [&](std::size_t i) {
    LatticePoint point;
    return store.meet(p[i], p[i + 1], p[i + 2], point);
  });
}

/// Two equal points, x scaled down by 2^range: the width of the exact stage grows with the span of exponents.
void doubles_insphere_degenerate(benchmark::State& state) {
  std::vector<Vec3> p = data().doubles;
  for (Vec3& v : p) {
    v.x = std::ldexp(v.x, -static_cast<int>(state.range(0)));
    v.y = std::ldexp(v.y, static_cast<int>(state.range(0)));
  }
  run(state, [&](std::size_t i) { return insphere(p[i], p[i + 1], p[i + 2], p[i + 3], p[i + 3]); });
}

BENCHMARK(orient3d_filter_inline);
BENCHMARK(insphere_filter_inline);
BENCHMARK(orient3d_filter_rational);
BENCHMARK(insphere_filter_rational);
BENCHMARK(orient3d_exact_stage)->DenseRange(0, 4);
BENCHMARK(insphere_exact_stage)->DenseRange(0, 5);
BENCHMARK(incircle_exact_stage);
BENCHMARK(meet_three_planes);
BENCHMARK(doubles_insphere_degenerate)->Arg(0)->Arg(20)->Arg(80)->Arg(900);

}  // namespace
