#pragma once
/// Strategies one after the other: the first that knows decides. Which one did can be observed; who does not
/// ask pays nothing.

#include <array>
#include <cstdint>
#include <tuple>

#include "strategy.h"

namespace crossloft::strategies {

/// A verdict and the stage of the cascade it came from, counted from 0.
struct Decision {
  Verdict verdict = kUnknown;
  unsigned stage = 0;
};

namespace detail {

/// The names, joined by " > ", with static storage.
template <class... Stages>
struct JoinedName {
  static constexpr std::string_view kSeparator = " > ";
  static constexpr std::size_t kSize =
      (Stages::kName.size() + ...) + kSeparator.size() * (sizeof...(Stages) - 1);
  static constexpr std::array<char, kSize> kText = [] {
    std::array<char, kSize> text{};
    std::size_t at = 0;
    for (const std::string_view name : {Stages::kName...}) {
      if (at > 0)
        for (const char c : kSeparator) text[at++] = c;
      for (const char c : name) text[at++] = c;
    }
    return text;
  }();
};

}  // namespace detail

/// Exact if the last strategy is, else a filter. No stage may be Guarantee::none.
template <class First, class... Rest>
class Cascade : public Asking<Cascade<First, Rest...>> {
  using Stages = std::tuple<First, Rest...>;
  using Name = detail::JoinedName<First, Rest...>;
  static_assert(First::kGuarantee != Guarantee::none && ((Rest::kGuarantee != Guarantee::none) && ...));

 public:
  static constexpr unsigned kStages = 1 + sizeof...(Rest);
  static constexpr std::string_view kName{Name::kText.data(), Name::kSize};
  static constexpr std::array<std::string_view, kStages> kStageNames{First::kName, Rest::kName...};
  static constexpr Guarantee kGuarantee = std::tuple_element_t<kStages - 1, Stages>::kGuarantee;

  Cascade() = default;
  explicit Cascade(const Extent& extent) : stages_(First(extent), Rest(extent)...) {}

  template <class Question>
  Verdict ask(const Question& question) const {
    return decide(question).verdict;
  }
  /// As in cascade.decide([&](const auto& strategy) { return strategy.orient3d(a, b, c, d); }).
  template <class Question>
  Decision decide(const Question& question) const {
    return decide_from<0>(question);
  }

 private:
  template <unsigned Stage, class Question>
  Decision decide_from(const Question& question) const {
    const Verdict verdict = question(std::get<Stage>(stages_));
    if constexpr (Stage + 1 < kStages) {
      if (verdict == kUnknown) return decide_from<Stage + 1>(question);
    }
    return {verdict, Stage};
  }

  Stages stages_;
};

/// How a strategy is seen by a histogram: its stages, one if it is not a cascade, and one more for unknown.
template <class S>
struct StagesOf {
  static constexpr unsigned kCount = 1;
  static constexpr std::array<std::string_view, 1> kNames{S::kName};
  template <class Question>
  static Decision decide(const S& strategy, const Question& question) {
    return {question(strategy), 0};
  }
};
template <class... S>
struct StagesOf<Cascade<S...>> {
  static constexpr unsigned kCount = Cascade<S...>::kStages;
  static constexpr std::array<std::string_view, kCount> kNames = Cascade<S...>::kStageNames;
  template <class Question>
  static Decision decide(const Cascade<S...>& strategy, const Question& question) {
    return strategy.decide(question);
  }
};

/// A strategy that counts which stage decided; the last count is of unknown answers. Counts are not
/// synchronised: one object per thread.
template <class S>
class Counted : public Asking<Counted<S>> {
 public:
  static constexpr std::string_view kName = S::kName;
  static constexpr Guarantee kGuarantee = S::kGuarantee;
  using Counts = std::array<std::uint64_t, StagesOf<S>::kCount + 1>;

  Counted() = default;
  explicit Counted(const Extent& extent) : strategy_(extent) {}

  template <class Question>
  Verdict ask(const Question& question) const {
    const Decision d = StagesOf<S>::decide(strategy_, question);
    ++counts_[d.verdict == kUnknown ? StagesOf<S>::kCount : d.stage];
    return d.verdict;
  }
  const Counts& counts() const { return counts_; }

 private:
  S strategy_;
  mutable Counts counts_{};
};

}  // namespace crossloft::strategies
