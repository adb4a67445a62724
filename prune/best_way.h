#pragma once
/// Ways through tetrahedra, from facet to facet, that are as good as can be where they are worst.

#include <algorithm>
#include <cstdint>
#include <queue>
#include <span>
#include <vector>

#include "cell_complex.h"
#include "star.h"

namespace crossloft {

/// What a way prefers to go through. By confidence, then by sorted vertices.
enum class Prefers : std::uint8_t { sure, unsure };

/// By tetrahedron the one before it on ways from their starts, kNone where none has come to.
class Ways {
 public:
  explicit Ways(std::size_t tets) : before_(tets, kNone) {}

  std::uint32_t before(std::uint32_t t) const { return before_[t]; }
  void set(std::uint32_t t, std::uint32_t before) {
    before_[t] = before;
    set_.push_back(t);
  }
  /// O(what has been set).
  void clear() {
    for (const std::uint32_t t : set_) before_[t] = kNone;
    set_.clear();
  }

 private:
  std::vector<std::uint32_t> before_, set_;
};

/// From one of `starts` to a tetrahedron with goal(t), over those with usable(t), so that the worst one on
/// the way is as good as can be; from the start on, empty if there is no way. (Prim's algorithm: the first
/// goal it comes to.) Only what it comes to is measured, once each. O(n log n) for n of these.
template <class Measure, class Usable, class Goal>
std::vector<std::uint32_t> best_way(const TetMesh& mesh, Prefers prefers, const Measure& measure,
                                    std::span<const std::uint32_t> starts, Usable usable, Goal goal,
                                    Ways& ways) {
  struct Step {  // what a way has come to
    std::int32_t confidence;
    TetName name;
    std::uint32_t tet;
  };
  const auto comes_later = [prefers](const Step& x, const Step& y) {
    const bool is_surer = x.confidence != y.confidence ? x.confidence > y.confidence : x.name < y.name;
    return x.tet != y.tet && is_surer != (prefers == Prefers::sure);
  };
  std::priority_queue<Step, std::vector<Step>, decltype(comes_later)> queue(comes_later);
  ways.clear();
  const auto see = [&](std::uint32_t t, std::uint32_t from) {
    if (ways.before(t) != kNone || !usable(t)) return;
    ways.set(t, from);
    queue.push({measure(t), sorted_vertices(mesh, t), t});
  };
  for (const std::uint32_t t : starts) see(t, t);
  while (!queue.empty()) {
    std::uint32_t t = queue.top().tet;
    queue.pop();
    if (goal(t)) {
      std::vector<std::uint32_t> way{t};
      for (; ways.before(t) != t; t = ways.before(t)) way.push_back(ways.before(t));
      std::reverse(way.begin(), way.end());
      return way;
    }
    for (const std::uint32_t n : mesh.neighbours[t])
      if (n != kNone) see(n, t);
  }
  return {};
}

}  // namespace crossloft
