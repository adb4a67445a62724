// Minimum cuts against all subsets, against Boost's Boykov-Kolmogorov, and against their own certificate.
#include "prune/min_cut.h"
#include "prune/cut_reduction.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <random>

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // false alarms on Boost's edge iterators
#endif
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

namespace {

using namespace crossloft;

using Neighbours = std::vector<std::array<std::uint32_t, 4>>;
using Kept = std::vector<std::uint8_t>;

/// A number in [0, n). The distributions of the standard library differ from one to the next.
std::uint32_t below(std::mt19937& random, std::uint32_t n) { return random() % n; }

unsigned slot(const Neighbours& graph, std::uint32_t t, std::uint32_t n) {
  return static_cast<unsigned>(std::find(graph[t].begin(), graph[t].end(), n) - graph[t].begin());
}

/// Slots joined in pairs at random, no two nodes twice. The fewer tries the more slots stay without
/// neighbour.
Neighbours random_graph(std::uint32_t n, std::uint32_t tries, std::mt19937& random) {
  Neighbours graph(n, {kNone, kNone, kNone, kNone});
  for (; tries > 0; --tries) {
    const std::uint32_t a = below(random, n), b = below(random, n);
    const unsigned i = below(random, 4), j = below(random, 4);
    if (a == b || graph[a][i] != kNone || graph[b][j] != kNone || slot(graph, a, b) < 4) continue;
    graph[a][i] = b;
    graph[b][j] = a;
  }
  return graph;
}

/// Rings of `width` nodes around a tube, each joined to the rings before and after: long paths, as in a cell.
Neighbours tube(std::uint32_t length, std::uint32_t width) {
  Neighbours graph;
  for (std::uint32_t t = 0; t < length * width; ++t) {
    const std::uint32_t x = t % width, ring = t - x;
    graph.push_back({ring + (x + 1) % width, t < width ? kNone : t - width, ring + (x + width - 1) % width,
                     t + width >= length * width ? kNone : t + width});
  }
  return graph;
}

/// Capacities 0..facet and terminals -terminal..terminal, in units; `neutral` of ten terminals are 0.
struct Weights {
  std::uint32_t facet, terminal, neutral;
  std::int64_t unit = 1;
};

CutProblem weighted(const Neighbours& graph, const Weights& w, std::mt19937& random) {
  CutProblem problem{graph, {}, {}};
  problem.capacity.resize(graph.size());
  for (std::uint32_t t = 0; t < graph.size(); ++t) {
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t n = graph[t][i];
      if (n == kNone || n < t) continue;
      problem.capacity[t][i] = w.unit * below(random, w.facet + 1);
      problem.capacity[n][slot(graph, n, t)] = problem.capacity[t][i];
    }
    const std::int64_t price = std::int64_t{below(random, 2 * w.terminal + 1)} - w.terminal;
    problem.terminal.push_back(below(random, 10) < w.neutral ? 0 : w.unit * price);
  }
  return problem;
}

constexpr Weights kWeights[] = {{0, 5, 0},  {1, 1, 0}, {2, 2, 5}, {3, 50, 0},
                                {50, 3, 0}, {9, 9, 8}, {9, 0, 0}};

std::int64_t value_of(const CutProblem& problem, const Kept& kept) {
  std::int64_t value = 0;
  for (std::uint32_t t = 0; t < kept.size(); ++t) {
    value += std::max<std::int64_t>(kept[t] != 0 ? -problem.terminal[t] : problem.terminal[t], 0);
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t n = problem.neighbours[t][i];
      if (n != kNone && kept[t] != 0 && kept[n] == 0) value += problem.capacity[t][i];
    }
  }
  return value;
}

/// What there is to know of a problem: the value, and the smallest and the largest source side.
struct Answer {
  std::int64_t value;
  Kept smallest, largest;
};

Answer try_all_subsets(const CutProblem& problem) {
  const std::size_t n = problem.terminal.size();
  Answer best{INT64_MAX, {}, {}};
  for (std::uint32_t subset = 0; subset < 1U << n; ++subset) {
    Kept kept(n);
    for (std::uint32_t t = 0; t < n; ++t) kept[t] = subset >> t & 1U;
    const std::int64_t value = value_of(problem, kept);
    if (value > best.value) continue;
    if (value < best.value) best = {value, kept, kept};
    for (std::uint32_t t = 0; t < n; ++t) {
      best.smallest[t] = best.smallest[t] & kept[t];
      best.largest[t] = best.largest[t] | kept[t];
    }
  }
  return best;
}

class BoostReferee {
 public:
  explicit BoostReferee(const CutProblem& problem)
      : n_(problem.terminal.size()), source_(n_), sink_(n_ + 1), graph_(n_ + 2) {
    for (std::uint32_t t = 0; t < n_; ++t) {
      for (unsigned i = 0; i < 4; ++i) {
        const std::uint32_t n = problem.neighbours[t][i];
        if (n != kNone && n > t) add(t, n, problem.capacity[t][i], problem.capacity[t][i]);
      }
      if (problem.terminal[t] > 0) add(source_, t, problem.terminal[t], 0);
      if (problem.terminal[t] < 0) add(t, sink_, -problem.terminal[t], 0);
    }
  }

  Answer run() {
    const std::int64_t value = boost::boykov_kolmogorov_max_flow(
        graph_, get(&Arc::capacity, graph_), get(&Arc::residual, graph_), get(&Arc::reverse, graph_),
        get(&Vertex::predecessor, graph_), get(&Vertex::colour, graph_), get(&Vertex::distance, graph_),
        get(boost::vertex_index, graph_), source_, sink_);
    Kept largest = reached(sink_, false);
    for (std::uint8_t& side : largest) side = 1 - side;
    return {value, reached(source_, true), largest};
  }

 private:
  using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
  struct Vertex {
    boost::default_color_type colour;
    std::int64_t distance;
    Traits::edge_descriptor predecessor;
  };
  struct Arc {
    std::int64_t capacity, residual;
    Traits::edge_descriptor reverse;
  };

  void add(std::size_t a, std::size_t b, std::int64_t there, std::int64_t back) {
    const auto e = add_edge(a, b, graph_).first, f = add_edge(b, a, graph_).first;
    graph_[e] = {there, 0, f};
    graph_[f] = {back, 0, e};
  }

  /// What residual arcs lead to from `start`, or to `start`.
  Kept reached(std::size_t start, bool forward) const {
    Kept seen(n_ + 2);
    std::vector<std::size_t> queue{start};
    seen[start] = 1;
    for (std::size_t head = 0; head < queue.size(); ++head) {
      for (const auto e : boost::make_iterator_range(out_edges(queue[head], graph_))) {
        const auto to = target(e, graph_);
        const std::int64_t residual = graph_[forward ? e : graph_[e].reverse].residual;
        if (residual == 0 || seen[to] != 0) continue;
        seen[to] = 1;
        queue.push_back(to);
      }
    }
    seen.resize(n_);
    return seen;
  }

  std::size_t n_, source_, sink_;
  boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, Vertex, Arc> graph_;
};

/// Terminals told in ranges, closer each time: the same, and not all are asked for to the end.
struct RoughPrices {
  explicit RoughPrices(const CutProblem& of) : problem(of), step_of(of.terminal.size(), kNone) {
    for (const std::int64_t x : problem.terminal) most = std::max(most, std::abs(x));
  }

  PriceRange at(std::uint32_t t, unsigned step) {
    CHECK(step_of[t] + 1 == step);  // in turn, once each
    step_of[t] = step;
    const std::int64_t x = problem.terminal[t];
    const std::int64_t off = step == 0 ? most : step == 1 ? (most / 2 ^ t) % (most / 2 + 1) : 0;
    return {std::max(-most, x - off / (1 + t % 3)), std::min(most, x + off / (1 + t % 5))};
  }

  const CutProblem& problem;
  std::vector<std::uint32_t> step_of;
  std::int64_t most = 0;
};

void check_answer(const CutProblem& problem, const Answer& answer) {
  const MinCut cut = minimum_cut(problem);
  CHECK(cut.value == answer.value);
  CHECK(cut.kept == answer.smallest);
  CHECK(smallest_cheapest(problem) == answer.smallest);
  RoughPrices prices(problem);
  CHECK(smallest_cheapest(problem, [&](std::uint32_t t, unsigned step) { return prices.at(t, step); }) ==
        answer.smallest);
  CHECK(value_of(problem, cut.kept) == cut.value);
  CHECK(verify(problem, cut));
}

/// How many problems had something to decide, or the tests below are empty.
struct Census {
  unsigned proper = 0, tied = 0;

  void add(const Answer& answer) {
    const auto kept = std::accumulate(answer.smallest.begin(), answer.smallest.end(), std::size_t{0});
    proper += kept > 0 && kept < answer.smallest.size() ? 1 : 0;
    tied += answer.smallest != answer.largest ? 1 : 0;
  }
};

}  // namespace

TEST_CASE("small graphs: the smallest of all best subsets") {
  Census census;
  for (std::uint32_t seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const std::uint32_t n = 1 + below(random, 11);
    const Neighbours graph = random_graph(n, below(random, 20 * n), random);
    const CutProblem problem = weighted(graph, kWeights[seed % std::size(kWeights)], random);
    const Answer answer = try_all_subsets(problem);
    census.add(answer);
    check_answer(problem, answer);
  }
  CHECK(census.proper > 100);
  CHECK(census.tied > 100);
}

TEST_CASE("what a rough price decides, or neighbours do, is not asked for its own") {
  std::size_t asked = 0, all = 0;
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    const Neighbours graph = random_graph(300, 3000, random);
    const CutProblem problem = weighted(graph, {3, 20, 0}, random);
    RoughPrices prices(problem);
    const Kept kept =
        smallest_cheapest(problem, [&](std::uint32_t t, unsigned step) { return prices.at(t, step); });
    CHECK(kept == minimum_cut(problem).kept);
    asked += static_cast<std::size_t>(std::count(prices.step_of.begin(), prices.step_of.end(), 2U));
    all += kept.size();
  }
  CHECK(asked < all / 2);
  CHECK(asked > 0);
}

TEST_CASE("random graphs and tubes: as Boost's") {
  Census census;
  for (std::uint32_t seed = 1000; seed < 1300; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const std::uint32_t n = 20 + below(random, 400);
    const Neighbours graph = seed % 2 == 0 ? random_graph(n, n << below(random, 6), random)
                                           : tube(4 + n / 8, 3 + below(random, 9));
    const CutProblem problem = weighted(graph, kWeights[seed % std::size(kWeights)], random);
    const Answer answer = BoostReferee(problem).run();
    census.add(answer);
    check_answer(problem, answer);
  }
  CHECK(census.proper > 60);
  CHECK(census.tied > 100);
}

TEST_CASE("flow through long tubes, from a few sources to a few sinks") {
  unsigned flowing = 0;
  for (std::uint32_t seed = 2000; seed < 2060; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const std::uint32_t width = 3 + below(random, 20), length = 30 + below(random, 60);
    const Neighbours graph = tube(length, width);
    CutProblem problem = weighted(graph, {20, 0, 0}, random);
    for (std::uint32_t x = 0; x < width; ++x) {
      problem.terminal[x] = below(random, 40);
      problem.terminal[problem.terminal.size() - 1 - x] = -std::int64_t{below(random, 40)};
    }
    const Answer answer = BoostReferee(problem).run();
    flowing += answer.value > 0 ? 1 : 0;
    check_answer(problem, answer);
  }
  CHECK(flowing > 50);
}

TEST_CASE("the numbers of the tetrahedra and the order of their facets do not matter") {
  for (std::uint32_t seed = 3000; seed < 3100; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const std::uint32_t n = 10 + below(random, 300);
    const Neighbours graph = random_graph(n, 30 * n, random);
    const CutProblem problem = weighted(graph, kWeights[seed % std::size(kWeights)], random);
    std::vector<std::uint32_t> to(n);
    std::iota(to.begin(), to.end(), 0U);
    for (std::uint32_t t = n; t > 1; --t) std::swap(to[t - 1], to[below(random, t)]);
    Neighbours renamed(n);
    CutProblem other{renamed, problem.capacity, problem.terminal};
    for (std::uint32_t t = 0; t < n; ++t) {
      other.terminal[to[t]] = problem.terminal[t];
      const unsigned turn = below(random, 4);
      for (unsigned i = 0; i < 4; ++i) {
        renamed[to[t]][i ^ turn] = graph[t][i] == kNone ? kNone : to[graph[t][i]];
        other.capacity[to[t]][i ^ turn] = problem.capacity[t][i];
      }
    }
    const MinCut cut = minimum_cut(problem), other_cut = minimum_cut(other);
    CHECK(cut.value == other_cut.value);
    for (std::uint32_t t = 0; t < n; ++t) CHECK(cut.kept[t] == other_cut.kept[to[t]]);
  }
}

TEST_CASE("all source, all sink, nothing at all") {
  std::mt19937 random(1);
  const Neighbours graph = random_graph(50, 1000, random);
  CutProblem problem = weighted(graph, {9, 0, 0}, random);
  CHECK(minimum_cut(problem).kept == Kept(50, 0));
  problem.terminal.assign(50, 7);
  CHECK(minimum_cut(problem).kept == Kept(50, 1));
  CHECK(minimum_cut(problem).value == 0);
  problem.terminal.assign(50, -7);
  CHECK(minimum_cut(problem).kept == Kept(50, 0));
  CHECK(verify(problem, minimum_cut(problem)));
  CHECK(minimum_cut(CutProblem{}).kept.empty());
  CHECK(verify(CutProblem{}, minimum_cut(CutProblem{})));
}

TEST_CASE("weights up to the limit") {
  // 3 n c of the header: 3 * 200 * 2^50 < 2^60.
  for (std::uint32_t seed = 4000; seed < 4050; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Neighbours graph = random_graph(200, 6000, random);
    CutProblem problem = weighted(graph, {1U << 14, 1U << 14, seed % 3, std::int64_t{1} << 36}, random);
    // One that must be kept and one that must be dropped, each with a neighbour from which it can't be cut.
    problem.terminal[0] = kUncuttable;
    problem.terminal[1] = -kUncuttable;
    for (const std::uint32_t t : {0U, 1U}) {
      const std::uint32_t n = graph[t][0];
      if (n == kNone || n < 2 || slot(graph, 1 - t, n) < 4) continue;
      problem.capacity[t][0] = problem.capacity[n][slot(graph, n, t)] = kUncuttable;
    }
    const Answer answer = BoostReferee(problem).run();
    CHECK(answer.value < kUncuttable);
    check_answer(problem, answer);
  }
}

TEST_CASE("where everything is uncuttable, one cut is still the smallest") {
  const Neighbours graph{{1, kNone, kNone, kNone}, {kNone, 0, 2, kNone}, {kNone, kNone, kNone, 1}};
  CutProblem problem{
      graph, {{kUncuttable, 0, 0, 0}, {0, kUncuttable, kUncuttable, 0}, {0, 0, 0, kUncuttable}}, {}};
  problem.terminal = {kUncuttable, 0, -kUncuttable};
  const MinCut cut = minimum_cut(problem);
  CHECK(cut.value == kUncuttable);
  CHECK(cut.kept == Kept{0, 0, 0});
  CHECK(verify(problem, cut));
}

TEST_CASE("verify rejects what is not a minimum cut with the fewest kept") {
  // 0 -5- 1 -5- 2 -9- 3: the source sends 5 to the sink; {0}, {0 1} are both best.
  const Neighbours graph{
      {1, kNone, kNone, kNone}, {0, 2, kNone, kNone}, {3, 1, kNone, kNone}, {2, kNone, kNone, kNone}};
  const CutProblem problem{graph, {{5, 0, 0, 0}, {5, 5, 0, 0}, {9, 5, 0, 0}, {9, 0, 0, 0}}, {8, 0, 0, -6}};
  const MinCut good = minimum_cut(problem);
  CHECK(good.value == 5);
  CHECK(good.kept == Kept{1, 0, 0, 0});
  CHECK(verify(problem, good));
  const auto rejects = [&](auto change) {
    MinCut bad = good;
    change(bad);
    return !verify(problem, bad);
  };
  CHECK(rejects([](MinCut& c) { c.kept[1] = 1; }));  // a minimum cut, but not the smallest
  CHECK(rejects([](MinCut& c) { c.kept[3] = 1; }));
  CHECK(rejects([](MinCut& c) { ++c.value; }));
  CHECK(rejects([](MinCut& c) { --c.value; }));
  CHECK(rejects([](MinCut& c) { --c.flow[1][1]; }));  // not the negative of the other direction
  // One unit ends at 2, which is no sink; one starts at 1, which is no source. Values and sides still fit.
  CHECK(rejects([](MinCut& c) { --c.flow[2][0], ++c.flow[3][0]; }));
  CHECK(rejects([](MinCut& c) { --c.flow[0][0], ++c.flow[1][0], c.kept[1] = 1; }));
  CHECK(rejects([](MinCut& c) { c.flow.assign(4, {}), c.value = 0; }));  // not maximal
  CHECK(rejects([](MinCut& c) { c.kept.pop_back(); }));
}

TEST_CASE("verify rejects a flow that goes around in circles beyond the capacity") {
  const Neighbours graph{{1, 2, kNone, kNone}, {2, 0, kNone, kNone}, {0, 1, kNone, kNone}};
  const CutProblem problem{graph, {{1, 1, 0, 0}, {1, 1, 0, 0}, {1, 1, 0, 0}}, {0, 0, 0}};
  MinCut cut = minimum_cut(problem);
  cut.flow.assign(3, {1, -1, 0, 0});
  CHECK(verify(problem, cut));
  cut.flow.assign(3, {2, -2, 0, 0});
  CHECK_FALSE(verify(problem, cut));
}

TEST_CASE("once the flag is raised nothing is looked for any more") {
  // Two tetrahedra: one wants to be kept, the other to be dropped, and the facet between them is cheap.
  const std::vector<std::array<std::uint32_t, 4>> neighbours{{1, kNone, kNone, kNone},
                                                             {0, kNone, kNone, kNone}};
  CutProblem problem{neighbours, {{1, 0, 0, 0}, {1, 0, 0, 0}}, {5, -5}};
  CHECK(minimum_cut(problem).value == 1);
  const std::atomic<bool> raised{true};
  problem.cancel = &raised;
  CHECK(minimum_cut(problem).value == 0);
  unsigned closest = 0;
  smallest_cheapest(problem, [&](std::uint32_t, unsigned step) {
    closest = std::max(closest, step);
    return PriceRange{-9, 9};
  });
  CHECK(closest == 0);
}
