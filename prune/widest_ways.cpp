#include "widest_ways.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "../geom/disjoint_sets.h"
#include "star.h"

namespace crossloft {
namespace {

/// How well a tetrahedron conducts; the ground, with no tetrahedron, does best.
struct Width {
  std::int32_t confidence = std::numeric_limits<std::int32_t>::max();
  std::uint32_t tet = kNone;
};

/// A section that the search has met, and the worst on the way since the one before.
struct Met {
  std::uint32_t before = 0, part = 0;
  Width worst;
};

class WidestWays {
 public:
  WidestWays(const CellComplex& complex, const Ground& ground, const std::vector<std::uint8_t>& kept,
             std::span<const std::uint32_t> body, const std::function<std::int32_t(std::uint32_t)>& measure)
      : complex_(complex),
        ground_(ground),
        kept_(kept),
        body_(body),
        measure_(measure),
        width_(kept.size()),
        state_(kept.size(), State::unknown),
        met_(ground.size(), 0) {}

  std::vector<Join> run() {
    sort_ground();
    for (const std::uint32_t part : by_size_)
      if (met_[part] == 0 && left_[body_[part]] > 1) search_from(part);
    return name_joins();
  }

 private:
  enum class State : std::uint8_t { unknown, measured, reached };
  /// A tetrahedron by the width of the step to it: the lesser of its own and its neighbour's, which alone is
  /// known before it is measured.
  struct Step {
    Width width;
    std::uint32_t tet;
  };

  /// A total order that does not depend on the numbers of the tetrahedra.
  bool is_worse(const Width& x, const Width& y) const {
    if (x.confidence != y.confidence) return x.confidence < y.confidence;
    if (x.tet == y.tet || x.tet == kNone || y.tet == kNone) return x.tet != y.tet && y.tet == kNone;
    return sorted_vertices(complex_.mesh, y.tet) < sorted_vertices(complex_.mesh, x.tet);
  }
  Width worse(const Width& x, const Width& y) const { return is_worse(x, y) ? x : y; }

  /// Ground triangles by part; parts by size, as the search begins with all that stands on one; how many
  /// parts each body has.
  void sort_ground() {
    of_part_.resize(ground_.size());
    std::iota(of_part_.begin(), of_part_.end(), 0U);
    std::vector<std::uint32_t> count(ground_.size() + std::size_t{1}, 0);
    left_.assign(ground_.size(), 0);
    for (std::uint32_t g = 0; g < ground_.size(); ++g) ++count[ground_.part(g) + std::size_t{1}];
    for (std::uint32_t g = 0; g < ground_.size(); ++g)
      if (count[g + std::size_t{1}] != 0) by_size_.push_back(g), ++left_[body_[g]];
    begin_ = count;
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end());
    for (std::uint32_t g = 0; g < ground_.size(); ++g) of_part_[next[ground_.part(g)]++] = g;
    std::stable_sort(by_size_.begin(), by_size_.end(), [&](std::uint32_t x, std::uint32_t y) {
      return count[x + std::size_t{1}] < count[y + std::size_t{1}];
    });
  }

  auto worse_first() const {
    return [this](const Step& x, const Step& y) { return is_worse(x.width, y.width); };
  }

  void search_from(std::uint32_t part) {
    steps_.clear();
    worst_ = {}, last_ = part;
    meet(part);
    while (left_[body_[part]] > 1 && !steps_.empty()) {
      std::pop_heap(steps_.begin(), steps_.end(), worse_first());
      const Step step = steps_.back();
      steps_.pop_back();
      take(step);
    }
  }

  /// From here on its ground is a way.
  void meet(std::uint32_t part) {
    met_[part] = 1;
    for (std::uint32_t i = begin_[part]; i < begin_[part + 1]; ++i) offer(ground_.facet(of_part_[i]).tet, {});
  }

  /// What has been measured is on the heap with its own width, the most that a way to it can have.
  void offer(std::uint32_t t, const Width& width) {
    if (kept_[t] != 0 && state_[t] == State::unknown) push({width, t});
  }

  void push(const Step& step) {
    steps_.push_back(step);
    std::push_heap(steps_.begin(), steps_.end(), worse_first());
  }

  /// Measured only when nothing better is left.
  void take(const Step& step) {
    if (state_[step.tet] == State::reached) return;
    const bool is_new = state_[step.tet] == State::unknown;
    if (is_new) width_[step.tet] = {measure_(step.tet), step.tet}, state_[step.tet] = State::measured;
    if (is_worse(width_[step.tet], step.width)) {
      if (is_new) push({width_[step.tet], step.tet});
      return;
    }
    reach(step);
  }

  void reach(const Step& step) {
    const std::uint32_t t = step.tet;
    state_[t] = State::reached;
    worst_ = worse(worst_, step.width);
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t n = complex_.mesh.neighbours[t][i];
      if (n != kNone) offer(n, width_[t]);
      if (!ground_.is_ground(t, i)) continue;
      const std::uint32_t part = ground_.part(ground_.at(t, i));
      if (met_[part] != 0) continue;
      --left_[body_[part]];
      found_.push_back({last_, part, worse(worst_, width_[t])});
      worst_ = {}, last_ = part;
      meet(part);
    }
  }

  /// In Kruskal's order: what one tetrahedron joins becomes one body.
  std::vector<Join> name_joins() {
    std::sort(found_.begin(), found_.end(),
              [&](const Met& x, const Met& y) { return is_worse(y.worst, x.worst); });
    std::vector<Join> joins;
    DisjointSets bodies(ground_.size());
    std::vector<std::uint32_t> names = part_names(complex_, ground_), joined;
    for (std::size_t first = 0, last = 0; first < found_.size(); first = last) {
      joined.clear();
      for (; last < found_.size() && found_[last].worst.tet == found_[first].worst.tet; ++last)
        for (const std::uint32_t part : {found_[last].before, found_[last].part})
          joined.push_back(bodies.find(part));
      for (std::size_t i = first; i < last; ++i) bodies.join(found_[i].before, found_[i].part);
      std::sort(joined.begin(), joined.end());
      joined.erase(std::unique(joined.begin(), joined.end()), joined.end());
      const std::uint32_t body = joined[0];
      for (std::uint32_t& set : joined) set = names[set];
      std::sort(joined.begin(), joined.end());
      for (std::size_t i = 1; i < joined.size(); ++i)
        joins.push_back({joined[0], joined[i], found_[first].worst.confidence, true});
      names[body] = joined[0];
    }
    return joins;
  }

  const CellComplex& complex_;
  const Ground& ground_;
  const std::vector<std::uint8_t>& kept_;
  std::span<const std::uint32_t> body_;
  const std::function<std::int32_t(std::uint32_t)>& measure_;
  std::vector<Width> width_;  ///< by tetrahedron, if it has been measured
  std::vector<State> state_;
  std::vector<std::uint8_t> met_;               ///< by part
  std::vector<std::uint32_t> of_part_, begin_;  ///< ground triangles by part, those of p from begin_[p] on
  std::vector<std::uint32_t> by_size_;          ///< parts
  std::vector<std::uint32_t> left_;             ///< by body: parts that have not been met, and one
  std::vector<Step> steps_;                     ///< a heap, the best first
  Width worst_;                                 ///< since the last section
  std::uint32_t last_ = 0;                      ///< section that has been met last
  std::vector<Met> found_;
};

}  // namespace

std::vector<Join> find_widest_ways(const CellComplex& complex, const Ground& ground,
                                   const std::vector<std::uint8_t>& kept, std::span<const std::uint32_t> body,
                                   const std::function<std::int32_t(std::uint32_t)>& measure) {
  return WidestWays(complex, ground, kept, body, measure).run();
}

}  // namespace crossloft
