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

/// Of all vertices at one place to another one.
struct Merge {
  Vec3 from, to;
  bool helps = false;  ///< fewer pairs cross
  double length2 = 0;
};

/// By coordinates in the end: numbers depend on how the input is told.
bool is_better(const Merge& a, const Merge& b) {
  if (a.helps != b.helps) return a.helps;
  return std::tie(a.length2, a.from, a.to) < std::tie(b.length2, b.from, b.to);
}

class Merger {
 public:
  Merger(Surface& surface, const Context& context)
      : surface_(surface), points_(surface.points), context_(context) {}

  Merging run() {
    std::vector<Pair> bad = find_bad();
    result_.pairs = bad.size();
    if (!bad.empty()) list_umbrellas();
    merged_.assign(points_.size(), 0);
    for (; !bad.empty() && !context_.cancelled(); bad = find_bad()) merge_round(bad);
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

  void list_umbrellas() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t)
      for (const std::uint32_t v : surface_.triangles[t]) found.emplace_back(v, t);
    std::sort(found.begin(), found.end());
    umbrellas_ = Lists(points_.size(), found);
  }

  /// All pairs that cross, ascending, and the boxes of all triangles.
  std::vector<Pair> find_bad() {
    std::vector<Bounds> boxes;
    for (std::uint32_t t = 0; t < surface_.triangles.size(); ++t) boxes.push_back(bounds_of(corners(t)));
    tree_.emplace(boxes);
    std::vector<Pair> bad;
    tree_->for_pairs([&](std::uint32_t s, std::uint32_t t) {
      if (is_bad(s, t)) bad.push_back({std::min(s, t), std::max(s, t)});
    });
    std::sort(bad.begin(), bad.end());
    return bad;
  }

  void sort_by_place() {
    by_place_.resize(points_.size());
    std::iota(by_place_.begin(), by_place_.end(), 0u);
    std::sort(by_place_.begin(), by_place_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::tie(points_[a], a) < std::tie(points_[b], b);
    });
  }

  /// One merge for each pair whose triangles no merge of this round has touched: of the places of their
  /// corners all vertices are known.
  void merge_round(const std::vector<Pair>& bad) {
    std::vector<std::uint8_t> touched(surface_.triangles.size(), 0);
    sort_by_place();
    for (const auto& [s, t] : bad) {
      if (touched[s] != 0 || touched[t] != 0 || context_.cancelled()) continue;
      const Merge best = best_merge(s, t);
      for (const Vec3& place : {best.from, best.to})
        for (const std::uint32_t c : around(vertices_at(place))) touched[c] = 1;
      const auto vertices = vertices_at(best.from);
      for (const std::uint32_t v : vertices) merged_[v] = 1;
      put(vertices, best.to);
    }
  }

  /// As sorted: while none of them has moved.
  std::span<const std::uint32_t> vertices_at(const Vec3& place) const {
    const auto first = std::lower_bound(by_place_.begin(), by_place_.end(), place,
                                        [&](std::uint32_t v, const Vec3& p) { return points_[v] < p; });
    auto last = first;
    while (last != by_place_.end() && points_[*last] == place) ++last;
    return {first, last};
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

  /// Two triangles that cross have four places at least.
  Merge best_merge(std::uint32_t s, std::uint32_t t) {
    std::vector<Vec3> places;
    for (const std::uint32_t c : {s, t})
      for (const Vec3& p : corners(c)) places.push_back(p);
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    std::optional<Merge> best;
    for (const Vec3& from : places) try_merges(from, places, best);
    return *best;
  }

  void try_merges(const Vec3& from, std::span<const Vec3> places, std::optional<Merge>& best) {
    const auto vertices = vertices_at(from);
    const std::vector<std::uint32_t> triangles = around(vertices);
    const std::size_t before = count_bad(triangles);
    for (const Vec3& to : places) {
      if (to == from) continue;
      put(vertices, to);
      const Merge merge{from, to, count_bad(triangles) < before, dot(to - from, to - from)};
      if (!best || is_better(merge, *best)) best = merge;
    }
    put(vertices, from);
  }

  void put(std::span<const std::uint32_t> vertices, const Vec3& place) {
    for (const std::uint32_t v : vertices) points_[v] = place;
  }

  /// Bad pairs with one of the triangles, which are ascending.
  std::size_t count_bad(const std::vector<std::uint32_t>& triangles) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const std::uint32_t t = triangles[i];
      tree_->for_overlaps(bounds_of(corners(t)), [&](std::uint32_t s) {
        if (!std::binary_search(triangles.begin(), triangles.end(), s)) count += is_bad(s, t) ? 1U : 0U;
      });
      for (std::size_t j = 0; j < i; ++j) count += is_bad(triangles[j], t) ? 1U : 0U;
    }
    return count;
  }

  Surface& surface_;
  std::vector<Vec3>& points_;
  const Context& context_;
  Lists umbrellas_;              ///< by vertex
  std::optional<BoxTree> tree_;  ///< of this round: triangles that its merges touched have left their boxes
  std::vector<std::uint32_t> by_place_;
  std::vector<std::uint8_t> merged_;  ///< by vertex
  Merging result_;
};

}  // namespace

Merging merge_crossing_places(Surface& surface, const Context& context) {
  return Merger(surface, context).run();
}

}  // namespace crossloft
