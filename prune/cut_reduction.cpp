#include "cut_reduction.h"

#include <array>
#include <utility>

namespace crossloft {
namespace {

class CutReduction {
 public:
  explicit CutReduction(const CutProblem& problem)
      : problem_(problem), rest_(problem.neighbours.size()), state_(rest_.size(), kOpen) {
    for (std::uint32_t t = 0; t < rest_.size(); ++t) {
      const auto& c = problem.capacity[t];
      rest_[t] = {problem.terminal[t], c[0] + c[1] + c[2] + c[3]};
    }
  }

  std::vector<std::uint8_t> run() {
    for (std::uint32_t t = 0; t < rest_.size(); ++t) {
      decide(t);
      while (!decided_.empty()) {
        const std::uint32_t next = decided_.back();
        decided_.pop_back();
        tell_neighbours(next);
      }
    }
    cut_rest();
    for (std::uint8_t& state : state_) state = state == kKept ? 1 : 0;
    return std::move(state_);
  }

 private:
  enum : std::uint8_t { kOpen, kKept, kDropped };
  struct Prices {
    std::int64_t terminal;  ///< with the facets to what is decided
    std::int64_t facets;    ///< of those to what is open
  };

  void decide(std::uint32_t t) {
    if (state_[t] != kOpen) return;
    const Prices& p = rest_[t];
    if (p.terminal > p.facets)
      state_[t] = kKept;
    else if (-p.terminal >= p.facets)
      state_[t] = kDropped;
    else
      return;
    decided_.push_back(t);
  }

  void tell_neighbours(std::uint32_t t) {
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t n = problem_.neighbours[t][i];
      if (n == kNone || state_[n] != kOpen) continue;
      const std::int64_t price = problem_.capacity[t][i];
      rest_[n].facets -= price;
      rest_[n].terminal += state_[t] == kKept ? price : -price;
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
    for (std::uint32_t k = 0; k < open.size(); ++k) {
      rest.terminal.push_back(rest_[open[k]].terminal);
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
  std::vector<Prices> rest_;
  std::vector<std::uint8_t> state_;
  std::vector<std::uint32_t> decided_;  ///< their neighbours have not been told yet
};

}  // namespace

std::vector<std::uint8_t> smallest_cheapest(const CutProblem& problem) { return CutReduction(problem).run(); }

}  // namespace crossloft
