#include "merge_places.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "../geom/box_tree.h"
#include "../geom/triangle_meeting.h"
#include "lists.h"

namespace crossloft {
namespace {

using Pair = std::array<std::uint32_t, 2>;

/// Around more triangles than these it is not asked what a merge leaves: it would take too long.
constexpr std::size_t kLargest = 100;
/// A new tree when so many of its triangles, one in so many, have moved since it was built.
constexpr std::size_t kMovedShare = 16;

/// Of all vertices at one place to another one.
struct Merge {
  std::uint32_t from = 0, to = 0;  ///< places, numbered in lexicographic order
  bool is_exact = false;           ///< moves an exact point
  double length2 = 0;
  double cost = 0;  ///< squared length; if no fewer pairs cross afterwards, times the square of how many more
};

bool is_better(const Merge& a, const Merge& b) {
  return std::tie(a.is_exact, a.cost, a.from, a.to) < std::tie(b.is_exact, b.cost, b.from, b.to);
}

Corners corners_of(const Surface& surface, std::uint32_t t) {
  const auto& c = surface.triangles[t];
  return {surface.points[c[0]], surface.points[c[1]], surface.points[c[2]]};
}

std::vector<Bounds> boxes_of(const Surface& surface) {
  std::vector<Bounds> boxes;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    boxes.push_back(bounds_of(corners_of(surface, t)));
  return boxes;
}

class Merger {
 public:
  Merger(Surface& surface, std::span<const std::uint8_t> exact, const MergingEffort& effort,
         const Context& context)
      : surface_(surface),
        points_(surface.points),
        exact_(exact),
        effort_(effort),
        context_(context),
        umbrellas_(umbrellas_of(points_.size(), surface.triangles)),
        boxes_(boxes_of(surface)),
        tree_(boxes_),
        has_moved_(boxes_.size(), 0),
        touched_(boxes_.size(), 0) {
    find_places();
    for (std::uint32_t t = 0; t < boxes_.size(); ++t) is_idle_.push_back(is_idle(t) ? 1 : 0);
  }

  Merging run(std::vector<Pair> bad) {
    const std::vector<Vec3> before = points_;
    for (; !bad.empty() && !context_.cancelled(); renew(bad)) merge_round(bad);
    Merging result;
    for (std::size_t v = 0; v < points_.size(); ++v) result.merged += points_[v] != before[v] ? 1U : 0U;
    return result;
  }

 private:
  Corners corners(std::uint32_t t) const { return corners_of(surface_, t); }
  std::array<std::uint32_t, 3> places(std::uint32_t t) const {
    const auto& c = surface_.triangles[t];
    return {place_[c[0]], place_[c[1]], place_[c[2]]};
  }
  bool is_bad(std::uint32_t s, std::uint32_t t) const {
    return meeting(corners(s), corners(t)) != Meeting::none;
  }
  bool is_exact(std::size_t v) const { return !exact_.empty() && exact_[v] != 0; }

  void find_places() {
    std::vector<std::uint32_t> order(points_.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::uint32_t v, std::uint32_t w) {
      return std::tie(points_[v], v) < std::tie(points_[w], w);
    });
    place_.resize(points_.size());
    for (const std::uint32_t v : order) {
      if (members_.empty() || points_[members_.back()[0]] != points_[v]) {
        members_.emplace_back();
        is_exact_place_.push_back(0);
      }
      if (is_exact(v)) is_exact_place_.back() = 1;
      place_[v] = static_cast<std::uint32_t>(members_.size() - 1);
      members_.back().push_back(v);
    }
  }

  /// Needs no questions: a point, or a segment that is also an edge of a triangle with three corners. That
  /// crosses whatever the segment crosses, and stays the segment's edge until one of both moves.
  bool is_idle(std::uint32_t t) const {
    std::array<std::uint32_t, 3> p = places(t);
    std::sort(p.begin(), p.end());
    if (p[0] == p[2]) return true;
    if (p[0] != p[1] && p[1] != p[2]) return false;
    for (const std::uint32_t v : members_[p[0]])
      for (const std::uint32_t s : umbrellas_.of(v)) {
        const auto q = places(s);
        const bool has_three = q[0] != q[1] && q[1] != q[2] && q[2] != q[0];
        if (has_three && std::find(q.begin(), q.end(), p[2]) != q.end()) return true;
      }
    return false;
  }

  /// visit(s) for all triangles that need questions and whose boxes meet this one.
  template <class Visit>
  void for_overlaps(const Bounds& box, Visit&& visit) const {
    tree_.for_overlaps(box, [&](std::uint32_t s) {
      if (has_moved_[s] == 0 && is_idle_[s] == 0) visit(s);
    });
    for (const std::uint32_t s : moved_)
      if (is_idle_[s] == 0 && overlap(boxes_[s], box)) visit(s);
  }

  /// After a round: of the pairs that crossed those stay that it did not touch.
  void renew(std::vector<Pair>& bad) {
    for (const std::uint32_t t : round_) is_idle_[t] = is_idle(t) ? 1 : 0;
    std::erase_if(bad, [&](const Pair& pair) { return touched_[pair[0]] != 0 || touched_[pair[1]] != 0; });
    for (const std::uint32_t t : round_) {
      if (is_idle_[t] != 0) continue;
      for_overlaps(boxes_[t], [&](std::uint32_t s) {
        if (s == t || (s < t && touched_[s] != 0)) return;
        ++renewed_;
        if (is_bad(s, t)) bad.push_back({std::min(s, t), std::max(s, t)});
      });
    }
    std::sort(bad.begin(), bad.end());
    for (const std::uint32_t t : round_) touched_[t] = 0;
    round_.clear();
    if (moved_.size() > boxes_.size() / kMovedShare) plant();
  }

  /// A new tree.
  void plant() {
    tree_ = BoxTree(boxes_);
    for (const std::uint32_t t : moved_) has_moved_[t] = 0;
    moved_.clear();
  }

  void merge_round(const std::vector<Pair>& bad) {
    for (const auto& [s, t] : bad) {
      if (context_.cancelled()) return;
      if (!is_bad(s, t)) continue;
      if (renewed_ < effort_.renewing)
        merge(best_merge(s, t));
      else
        collapse(s, t);
    }
  }

  void merge(const Merge& best) {
    auto moving = std::move(members_[best.from]);
    members_[best.from].clear();
    std::vector<std::uint32_t>& there = members_[best.to];
    const Vec3 to = points_[there[0]];
    for (const std::uint32_t v : moving) {
      points_[v] = to;
      place_[v] = best.to;
    }
    for (const std::uint32_t v : moving)
      for (const std::uint32_t t : umbrellas_.of(v)) touch(t);
    there.insert(there.end(), moving.begin(), moving.end());
  }

  void touch(std::uint32_t t) {
    boxes_[t] = bounds_of(corners(t));
    if (touched_[t] == 0) round_.push_back(t);
    if (has_moved_[t] == 0) moved_.push_back(t);
    touched_[t] = has_moved_[t] = 1;
  }

  /// Of both triangles' corners, ascending: three at least, as they have an inside in common.
  std::vector<std::uint32_t> places_of(std::uint32_t s, std::uint32_t t) const {
    std::vector<std::uint32_t> list;
    for (const std::uint32_t c : {s, t})
      for (const std::uint32_t p : places(c)) list.push_back(p);
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
  }

  const Vec3& point_of(std::uint32_t place) const { return points_[members_[place][0]]; }

  /// So that what crosses in a tangle is at one place after a few rounds.
  void collapse(std::uint32_t s, std::uint32_t t) {
    const std::vector<std::uint32_t> list = places_of(s, t);
    for (std::size_t i = 1; i < list.size(); ++i) merge({.from = list[i], .to = list[0]});
  }

  /// Short ones first, as a longer one can't be better than a short one that helps.
  Merge best_merge(std::uint32_t s, std::uint32_t t) {
    const std::vector<Merge> merges = merges_of(places_of(s, t));
    std::optional<Merge> best;
    for (Merge merge : merges) {
      if (best && (merge.is_exact != best->is_exact || merge.length2 > best->cost)) break;
      const double more = growth(merge);
      merge.cost = more * more * merge.length2;
      if (!best || is_better(merge, *best)) best = merge;
    }
    return *best;
  }

  /// Of any of the places to any other; the best first as far as is known without questions.
  std::vector<Merge> merges_of(const std::vector<std::uint32_t>& list) const {
    std::vector<Merge> merges;
    for (const std::uint32_t from : list)
      for (const std::uint32_t to : list) {
        if (to == from) continue;
        const Vec3 d = point_of(to) - point_of(from);
        merges.push_back({from, to, is_exact_place_[from] != 0, dot(d, d), dot(d, d)});
      }
    std::sort(merges.begin(), merges.end(), is_better);
    return merges;
  }

  /// 1 if fewer pairs cross after the merge, else 2 and how many more. Not asked, as many as it moves
  /// triangles: that keeps hubs of needles where they are, which sweep the most together.
  double growth(const Merge& merge) {
    const std::vector<std::uint32_t> triangles = around(members_[merge.from]);
    if (triangles.size() > kLargest || asked_ >= effort_.choosing)
      return std::max(2.0, static_cast<double>(triangles.size()));
    const std::size_t before = count_bad(triangles);
    const std::vector<std::uint32_t>& vertices = members_[merge.from];
    const Vec3 from = points_[vertices[0]], to = point_of(merge.to);
    for (const std::uint32_t v : vertices) points_[v] = to;
    const std::size_t after = count_bad(triangles);
    for (const std::uint32_t v : vertices) points_[v] = from;
    return after < before ? 1 : static_cast<double>(after - before + 2);
  }

  /// Triangles of these vertices, ascending.
  std::vector<std::uint32_t> around(std::span<const std::uint32_t> vertices) const {
    std::vector<std::uint32_t> list;
    for (const std::uint32_t v : vertices)
      list.insert(list.end(), umbrellas_.of(v).begin(), umbrellas_.of(v).end());
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    std::erase_if(list, [&](std::uint32_t t) { return is_idle_[t] != 0; });
    return list;
  }

  /// Bad pairs with one of the triangles, which are ascending.
  std::size_t count_bad(const std::vector<std::uint32_t>& triangles) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const std::uint32_t t = triangles[i];
      const Corners c = corners(t);
      if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;  // an edge of others
      for_overlaps(bounds_of(c), [&](std::uint32_t s) {
        if (std::binary_search(triangles.begin(), triangles.end(), s)) return;
        ++asked_;
        count += is_bad(s, t) ? 1U : 0U;
      });
      for (std::size_t j = 0; j < i; ++j) count += is_bad(triangles[j], t) ? 1U : 0U;
      asked_ += i;
    }
    return count;
  }

  Surface& surface_;
  std::vector<Vec3>& points_;
  std::span<const std::uint8_t> exact_;
  const MergingEffort& effort_;
  const Context& context_;
  Lists umbrellas_;                                  ///< by vertex
  std::vector<std::uint32_t> place_;                 ///< by vertex
  std::vector<std::vector<std::uint32_t>> members_;  ///< by place: vertices
  std::vector<std::uint8_t> is_exact_place_;
  std::vector<Bounds> boxes_;  ///< by triangle
  BoxTree tree_;               ///< of these, out of date for those that have moved since
  std::vector<std::uint32_t> moved_;
  std::vector<std::uint8_t> has_moved_;  ///< by triangle
  std::vector<std::uint32_t> round_;     ///< triangles touched in this round
  std::vector<std::uint8_t> touched_;    ///< by triangle
  std::vector<std::uint8_t> is_idle_;    ///< by triangle, before this round
  mutable std::uint64_t asked_ = 0;      ///< pairs to choose
  std::uint64_t renewed_ = 0;            ///< pairs after rounds
};

}  // namespace

Merging merge_crossing_places(Surface& surface, std::vector<std::array<std::uint32_t, 2>> crossing,
                              std::span<const std::uint8_t> exact, const Context& context,
                              const MergingEffort& effort) {
  if (crossing.empty()) return {};
  return Merger(surface, exact, effort, context).run(std::move(crossing));
}

}  // namespace crossloft
