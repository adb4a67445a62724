#pragma once
/// A bounding box tree over any items: overlap queries, all overlapping pairs, nearest item.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "bounds.h"

namespace crossloft {

inline bool overlap(const Bounds& a, const Bounds& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

/// Squared distance from a point to a box, 0 inside.
inline double squared_distance(const Bounds& box, const Vec3& p) {
  const auto gap = [](double low, double high, double x) {
    return x < low ? low - x : x > high ? x - high : 0.0;
  };
  const Vec3 d{gap(box.low.x, box.high.x, p.x), gap(box.low.y, box.high.y, p.y),
               gap(box.low.z, box.high.z, p.z)};
  return dot(d, d);
}

/// Static tree, split across the longest side, O(n log n) to build. Items are numbered as given;
/// the order in which a query meets them is not specified.
class BoxTree {
 public:
  explicit BoxTree(std::span<const Bounds> boxes);

  bool empty() const { return items_.empty(); }

  /// visit(item) for every item whose box meets the closed box `query`.
  template <class Visit>
  void for_overlaps(const Bounds& query, Visit&& visit) const {
    for_admitted([&](const Bounds& box) { return overlap(box, query); }, visit);
  }

  /// visit(item) for every item whose box is admitted. REQUIRES: a box around one that is admitted is.
  template <class Admits, class Visit>
  void for_admitted(Admits&& admits, Visit&& visit) const {
    if (!empty()) admitted(0, admits, visit);
  }

  /// visit(i, j) once for every pair of items whose boxes meet.
  template <class Visit>
  void for_pairs(Visit&& visit) const {
    if (!empty()) self_pairs(0, visit);
  }

  /// Smallest distance2(item), `bound` if none is smaller. Where rounding makes it less than the squared
  /// distance to the item's box, it is raised to that: so it does not depend on the order of the visits, as
  /// rounded distances to boxes never are less for a box within another one. A good bound saves time.
  template <class Distance2>
  double nearest(const Vec3& p, Distance2&& distance2, double bound = Bounds::kFar) const {
    if (!empty()) closest(0, p, distance2, bound);
    return bound;
  }

 private:
  struct Item {
    Bounds box;
    std::uint32_t id = 0;
  };
  struct Node {
    Bounds box;
    std::uint32_t begin = 0, end = 0;  // items, if a leaf
    std::uint32_t right = 0;           // second child, the first is the next node; 0 if a leaf
  };

  std::uint32_t split(std::uint32_t begin, std::uint32_t end);
  std::uint32_t build(std::uint32_t begin, std::uint32_t end);

  template <class Admits, class Visit>
  void admitted(std::uint32_t at, Admits& admits, Visit& visit) const {
    const Node& node = nodes_[at];
    if (!admits(node.box)) return;
    if (node.right != 0) {
      admitted(at + 1, admits, visit);
      admitted(node.right, admits, visit);
      return;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i)
      if (admits(items_[i].box)) visit(items_[i].id);
  }

  template <class Visit>
  void self_pairs(std::uint32_t at, Visit& visit) const {
    const Node& node = nodes_[at];
    if (node.right != 0) {
      self_pairs(at + 1, visit);
      self_pairs(node.right, visit);
      cross_pairs(at + 1, node.right, visit);
      return;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i)
      for (std::uint32_t j = i + 1; j < node.end; ++j)
        if (overlap(items_[i].box, items_[j].box)) visit(items_[i].id, items_[j].id);
  }

  template <class Visit>
  void cross_pairs(std::uint32_t a, std::uint32_t b, Visit& visit) const {
    const Node &na = nodes_[a], &nb = nodes_[b];
    if (!overlap(na.box, nb.box)) return;
    if (na.right != 0 && (nb.right == 0 || na.end - na.begin >= nb.end - nb.begin)) {
      cross_pairs(a + 1, b, visit);
      cross_pairs(na.right, b, visit);
    } else if (nb.right != 0) {
      cross_pairs(a, b + 1, visit);
      cross_pairs(a, nb.right, visit);
    } else {
      leaf_pairs(na, nb, visit);
    }
  }

  template <class Visit>
  void leaf_pairs(const Node& a, const Node& b, Visit& visit) const {
    for (std::uint32_t i = a.begin; i < a.end; ++i)
      for (std::uint32_t j = b.begin; j < b.end; ++j)
        if (overlap(items_[i].box, items_[j].box)) visit(items_[i].id, items_[j].id);
  }

  template <class Distance2>
  void closest(std::uint32_t at, const Vec3& p, Distance2& distance2, double& best) const {
    const Node& node = nodes_[at];
    if (node.right == 0) {
      for (std::uint32_t i = node.begin; i < node.end; ++i)
        if (const double least = squared_distance(items_[i].box, p); least < best)
          best = std::min(best, std::max(least, static_cast<double>(distance2(items_[i].id))));
      return;
    }
    const double left = squared_distance(nodes_[at + 1].box, p),
                 right = squared_distance(nodes_[node.right].box, p);
    const bool left_first = left <= right;
    if (std::min(left, right) < best) closest(left_first ? at + 1 : node.right, p, distance2, best);
    if (std::max(left, right) < best) closest(left_first ? node.right : at + 1, p, distance2, best);
  }

  std::vector<Item> items_;
  std::vector<Node> nodes_;
};

}  // namespace crossloft
