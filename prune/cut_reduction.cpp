#include "cut_reduction.h"

#include <array>
#include <utility>

namespace crossloft {
namespace {

class CutReduction {
 public:
  CutReduction(const CutProblem& problem, const PriceOf& price)
      : problem_(problem), price_(price), rest_(problem.neighbours.size()), state_(rest_.size(), kOpen) {
    for (std::uint32_t t = 0; t < rest_.size(); ++t) {
      const auto& c = problem.capacity[t];
      rest_[t] = {price(t, 0), 0, c[0] + c[1] + c[2] + c[3]};
    }
  }

  std::vector<std::uint8_t> run() {
    for (unsigned step = 0; step <= 2; ++step) {
      for (std::uint32_t t = 0; t < rest_.size(); ++t) {
        if (state_[t] != kOpen) continue;
        if (is_raised(problem_.cancel)) return std::move(state_);
        PriceRange& own = rest_[t].own;
        if (step > 0 && own.low != own.high) own = price_(t, step);
        decide(t);
        tell_neighbours();
      }
    }
    cut_rest();
    for (std::uint8_t& state : state_) state = state == kKept ? 1 : 0;
    return std::move(state_);
  }

 private:
  enum : std::uint8_t { kOpen, kKept, kDropped };
  struct Prices {
    PriceRange own;
    std::int64_t decided;  ///< of the facets to what is decided
    std::int64_t facets;   ///< of those to what is open
  };

  void decide(std::uint32_t t) {
    if (state_[t] != kOpen) return;
    const Prices& p = rest_[t];
    if (p.own.low + p.decided > p.facets)
      state_[t] = kKept;
    else if (-(p.own.high + p.decided) >= p.facets)
      state_[t] = kDropped;
    else
      return;
    decided_.push_back(t);
  }

  /// Those of what has been decided, and so on.
  void tell_neighbours() {
    while (!decided_.empty()) {
      const std::uint32_t next = decided_.back();
      decided_.pop_back();
      tell_neighbours(next);
    }
  }

  void tell_neighbours(std::uint32_t t) {
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t n = problem_.neighbours[t][i];
      if (n == kNone || state_[n] != kOpen) continue;
      const std::int64_t price = problem_.capacity[t][i];
      rest_[n].facets -= price;
      rest_[n].decided += state_[t] == kKept ? price : -price;
      decide(n);
    }
  }

  void cut_rest() {
    std::vector<std::uint32_t> open, place(state_.size(), kNone);
    for (std::uint32_t t = 0; t < state_.size(); ++t) {
      if (state_[t] != kOpen) continue;
      place[t] = static_cast<std::uint32_t>(open.size());
      open.push_back(t);
    }
    if (open.empty()) return;
    std::vector<std::array<std::uint32_t, 4>> neighbours(open.size());
    CutProblem rest;
    rest.cancel = problem_.cancel;
    for (std::uint32_t k = 0; k < open.size(); ++k) {
      rest.terminal.push_back(rest_[open[k]].own.low + rest_[open[k]].decided);
      auto& capacity = rest.capacity.emplace_back(problem_.capacity[open[k]]);
      for (unsigned i = 0; i < 4; ++i) {
        const std::uint32_t n = problem_.neighbours[open[k]][i];
        neighbours[k][i] = n == kNone ? kNone : place[n];
        if (neighbours[k][i] == kNone) capacity[i] = 0;
      }
    }
    rest.neighbours = neighbours;
    const std::vector<std::uint8_t> kept = minimum_cut(rest).kept;
    for (std::uint32_t k = 0; k < open.size(); ++k)
      if (kept[k] != 0) state_[open[k]] = kKept;
  }

  const CutProblem& problem_;
  const PriceOf& price_;
  std::vector<Prices> rest_;
  std::vector<std::uint8_t> state_;
  std::vector<std::uint32_t> decided_;  ///< their neighbours have not been told yet
};

}  // namespace

std::vector<std::uint8_t> smallest_cheapest(const CutProblem& problem, const PriceOf& price) {
  return CutReduction(problem, price).run();
}

std::vector<std::uint8_t> smallest_cheapest(const CutProblem& problem) {
  return smallest_cheapest(problem, [&](std::uint32_t t, unsigned) {
    return PriceRange{problem.terminal[t], problem.terminal[t]};
  });
}

}  // namespace crossloft
