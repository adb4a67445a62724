#include "merge_places.h"

#include <algorithm>
#include <array>
#include <map>
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
constexpr std::size_t kUnknown = 1000;
/// Pairs of triangles that are asked to choose merges; from then on clusters collapse.
constexpr std::uint64_t kMostAsked = 1U << 24;

/// Of all vertices at one place to another one.
struct Merge {
  Vec3 from, to;
  double cost = 0;  ///< squared length; if no fewer pairs cross afterwards, times the square of how many more
};

bool is_better(const Merge& a, const Merge& b) {
  return std::tie(a.cost, a.from, a.to) < std::tie(b.cost, b.from, b.to);
}

class Merger {
 public:
  Merger(Surface& surface, const Context& context)
      : surface_(surface), points_(surface.points), context_(context) {}

  Merging run() {
    std::vector<Pair> bad = find_bad();
    result_.pairs = bad.size();
    if (bad.empty()) return result_;
    umbrellas_ = umbrellas_of(points_.size(), surface_.triangles);
    for (std::uint32_t v = 0; v < points_.size(); ++v) vertices_at_[points_[v]].push_back(v);
    merged_.assign(points_.size(), 0);
    for (; !bad.empty() && !context_.cancelled(); renew(bad)) merge_round(bad);
    result_.merged = static_cast<std::uint32_t>(std::count(merged_.begin(), merged_.end(), 1));
    return result_;
  }

 private:
  Corners corners(std::uint32_t t) const {
    const auto& c = surface_.triangles[t];
    return {points_[c[0]], points_[c[1]], points_[c[2]]};
  }
  bool is_bad(std::uint32_t s, std::uint32_t t) const {
    return meeting(corners(s), corners(t)) != Meeting::none;
  }

  void build_tree() {
    std::vector<Bounds> boxes;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) boxes.push_back(bounds_of(corners(t)));
    tree_.emplace(boxes);
  }

  /// All pairs that cross, ascending.
  std::vector<Pair> find_bad() {
    build_tree();
    std::vector<Pair> bad;
    tree_->for_pairs([&](std::uint32_t s, std::uint32_t t) {
      if (is_bad(s, t)) bad.push_back({std::min(s, t), std::max(s, t)});
    });
    std::sort(bad.begin(), bad.end());
    return bad;
  }

  /// After a round: of the pairs that crossed those stay that it did not touch.
  void renew(std::vector<Pair>& bad) {
    build_tree();
    std::erase_if(bad, [&](const Pair& pair) { return touched_[pair[0]] != 0 || touched_[pair[1]] != 0; });
    for (std::uint32_t t = 0; t < touched_.size(); ++t)
      if (touched_[t] != 0)
        tree_->for_overlaps(bounds_of(corners(t)), [&](std::uint32_t s) {
          if (s == t || (s < t && touched_[s] != 0)) return;
          if (is_bad(s, t)) bad.push_back({std::min(s, t), std::max(s, t)});
        });
    std::sort(bad.begin(), bad.end());
  }

  void merge_round(const std::vector<Pair>& bad) {
    touched_.assign(surface_.triangles.size(), 0);
    for (const auto& [s, t] : bad) {
      if (context_.cancelled()) return;
      if (!is_bad(s, t)) continue;
      if (asked_ < kMostAsked)
        merge(best_merge(s, t));
      else
        collapse(s, t);
    }
  }

  void merge(const Merge& best) {
    auto moving = std::move(vertices_at_.extract(best.from).mapped());
    for (const std::uint32_t v : moving) {
      points_[v] = best.to;
      merged_[v] = 1;
      for (const std::uint32_t t : umbrellas_.of(v)) touched_[t] = 1;
    }
    std::vector<std::uint32_t>& there = vertices_at_[best.to];
    there.insert(there.end(), moving.begin(), moving.end());
  }

  /// Of both triangles' corners, ascending: three at least, as they have an inside in common.
  std::vector<Vec3> places_of(std::uint32_t s, std::uint32_t t) const {
    std::vector<Vec3> places;
    for (const std::uint32_t c : {s, t})
      for (const Vec3& p : corners(c)) places.push_back(p);
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
  }

  /// So that what crosses in a tangle is at one place after a few rounds.
  void collapse(std::uint32_t s, std::uint32_t t) {
    const std::vector<Vec3> places = places_of(s, t);
    for (std::size_t i = 1; i < places.size(); ++i) merge({places[i], places[0], 0});
  }

  Merge best_merge(std::uint32_t s, std::uint32_t t) {
    const std::vector<Vec3> places = places_of(s, t);
    std::optional<Merge> best;
    for (const Vec3& from : places) try_merges(from, places, best);
    return *best;
  }

  void try_merges(const Vec3& from, std::span<const Vec3> places, std::optional<Merge>& best) {
    const std::vector<std::uint32_t>& vertices = vertices_at_[from];
    const std::vector<std::uint32_t> triangles = around(vertices);
    const std::size_t before = count_bad(triangles);
    for (const Vec3& to : places) {
      if (to == from) continue;
      for (const std::uint32_t v : vertices) points_[v] = to;
      const std::size_t after = count_bad(triangles);
      const double more = after < before ? 1 : static_cast<double>(after - before + 2);
      const Merge merge{from, to, more * more * dot(to - from, to - from)};
      if (!best || is_better(merge, *best)) best = merge;
    }
    for (const std::uint32_t v : vertices) points_[v] = from;
  }

  /// Triangles of these vertices, ascending.
  std::vector<std::uint32_t> around(std::span<const std::uint32_t> vertices) const {
    std::vector<std::uint32_t> list;
    for (const std::uint32_t v : vertices)
      list.insert(list.end(), umbrellas_.of(v).begin(), umbrellas_.of(v).end());
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
  }

  /// Bad pairs with one of the triangles, which are ascending; those that merges of this round have brought
  /// near are not all seen.
  std::size_t count_bad(const std::vector<std::uint32_t>& triangles) const {
    if (triangles.size() > kLargest) return kUnknown;
    std::size_t count = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const std::uint32_t t = triangles[i];
      tree_->for_overlaps(bounds_of(corners(t)), [&](std::uint32_t s) {
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
  const Context& context_;
  Lists umbrellas_;              ///< by vertex
  std::optional<BoxTree> tree_;  ///< of the triangles before a round
  std::map<Vec3, std::vector<std::uint32_t>> vertices_at_;
  std::vector<std::uint8_t> touched_;  ///< by triangle, in this round
  std::vector<std::uint8_t> merged_;   ///< by vertex
  mutable std::uint64_t asked_ = 0;
  Merging result_;
};

}  // namespace

Merging merge_crossing_places(Surface& surface, const Context& context) {
  return Merger(surface, context).run();
}

}  // namespace crossloft
