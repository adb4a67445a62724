// The pipeline under strategies: three kinds of Answers. One gives those of a strategy, one collects how far
// the data of each predicate reach, one answers exactly and watches what a strategy would have said.

#include <array>
#include <memory>
#include <tuple>

#include "../../geom/strategies/list.h"
#include "routed_predicates.h"
#include "run.h"

namespace crossloft::bench {
namespace {

using namespace strategies;
using pipeline_bench::Outcome;
using pipeline_bench::Way;

enum Predicate : std::size_t { kOrient3d, kInsphere, kOrient2d, kIncircle, kSideOfPlane };
using Extents = std::array<Extent, pipeline_bench::kPredicates.size()>;

/// answer(predicate, question, data...) of the Derived class, where question(strategy) is a verdict.
template <class Derived>
class Questions : public Answers {
 public:
  int orient3d(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
               const LatticePoint& d) const final {
    return put(
        kOrient3d, [](const auto& s, const auto&... data) { return s.orient3d(data...); }, a, b, c, d);
  }
  int insphere(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d,
               const LatticePoint& e) const final {
    return put(
        kInsphere, [](const auto& s, const auto&... data) { return s.insphere(data...); }, a, b, c, d, e);
  }
  int orient2d(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b,
               const LatticePoint& c) const final {
    return put(
        kOrient2d, [](const auto& s, const auto&... data) { return s.orient2d(data...); }, plane, a, b, c);
  }
  int incircle(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
               const LatticePoint& d) const final {
    return put(
        kIncircle, [](const auto& s, const auto&... data) { return s.incircle(data...); }, plane, a, b, c, d);
  }
  int side_of_plane(const LatticePlane& plane, const LatticePoint& p) const final {
    return put(
        kSideOfPlane, [](const auto& s, const auto&... data) { return s.side_of_plane(data...); }, plane, p);
  }

 private:
  template <class Question, class... Data>
  int put(Predicate predicate, const Question& question, const Data&... data) const {
    return static_cast<const Derived&>(*this).answer(
        predicate, [&](const auto& strategy) { return question(strategy, data...); }, data...);
  }
};

/// One strategy a predicate, each with the extent of its own data.
template <class S>
std::array<S, pipeline_bench::kPredicates.size()> made_from(const Extents& extents) {
  return std::apply([](const auto&... extent) { return std::array{S(extent)...}; }, extents);
}

/// An unknown answer of a filter alone counts as 0: it is not fit for the pipeline, and the outcome will
/// tell.
template <class S>
class ByStrategy : public Questions<ByStrategy<S>> {
 public:
  explicit ByStrategy(const Extents& extents) : strategies_(made_from<S>(extents)) {}

  template <class Question, class... Data>
  int answer(Predicate predicate, const Question& question, const Data&...) const {
    const Verdict verdict = question(strategies_[predicate]);
    if constexpr (S::kGuarantee == Guarantee::filter) return verdict == kUnknown ? 0 : verdict;
    return verdict;
  }

 private:
  std::array<S, pipeline_bench::kPredicates.size()> strategies_;
};

class Measuring : public Questions<Measuring> {
 public:
  template <class Question, class... Data>
  int answer(Predicate predicate, const Question& question, const Data&... data) const {
    (builders_[predicate].include(data), ...);
    return question(FixedIntegers());
  }
  Extents extents() const {
    return std::apply([](const auto&... builder) { return Extents{builder.extent()...}; }, builders_);
  }

 private:
  mutable std::array<ExtentBuilder, pipeline_bench::kPredicates.size()> builders_;
};

template <class S>
class Watching : public Questions<Watching<S>> {
 public:
  explicit Watching(const Extents& extents) : strategies_(made_from<S>(extents)) {}

  template <class Question, class... Data>
  int answer(Predicate predicate, const Question& question, const Data&...) const {
    const Verdict truth = question(FixedIntegers());
    const Decision d = StagesOf<S>::decide(strategies_[predicate], question);
    const bool unknown = d.verdict == kUnknown;
    ++counts_.asked[predicate];
    ++counts_.decided[unknown ? StagesOf<S>::kCount : d.stage];
    counts_.wrong += !unknown && d.verdict != truth;
    return truth;
  }
  /// With the counts and without the rest.
  const Outcome& counts() const { return counts_; }

 private:
  static_assert(StagesOf<S>::kCount < Outcome::kMostStages);
  std::array<S, pipeline_bench::kPredicates.size()> strategies_;
  mutable Outcome counts_;
};

template <class S>
Outcome count(const std::string& path, const Extents& extents) {
  const Watching<S> watching(extents);
  let_answer(watching);
  const Outcome outcome = run(path);
  return outcome.ok() ? watching.counts() : outcome;
}

template <class S>
Way way(const std::string& path, const Extents& extents) {
  const auto run_it = [path, answers = std::make_shared<ByStrategy<S>>(extents)] {
    let_answer(*answers);
    return run(path, pipeline_bench::kLeastSeconds);
  };
  Way way{std::string(S::kName), S::kGuarantee == Guarantee::exact, {}, run_it, [path, extents] {
            return count<S>(path, extents);
          }};
  for (const std::string_view name : StagesOf<S>::kNames) way.stages.emplace_back(name);
  return way;
}

}  // namespace
}  // namespace crossloft::bench

std::vector<pipeline_bench::Way> pipeline_bench::under_strategies(const std::string& path) {
  using namespace crossloft::bench;
  const Measuring measuring;
  let_answer(measuring);
  std::vector<Way> ways;
  if (!run(path).ok()) return ways;
  const Extents extents = measuring.extents();
  crossloft::strategies::for_each_strategy([&]<class S>() {
    if constexpr (!std::is_same_v<S, crossloft::strategies::Crossloft>) ways.push_back(way<S>(path, extents));
  });
  return ways;
}
