#pragma once
/// Points of a plane, searched by box while they are removed one by one.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "../geom/ids.h"
#include "../geom/vec2.h"

namespace crossloft {

/// A kd-tree: halves by count along the longer side of their box, so that points crowded along curves cost no
/// more than points spread evenly. O(n log n) to build, O(log n) to remove a point. Source: Bentley,
/// *Multidimensional binary search trees used for associative searching* (1975).
class PointTree {
 public:
  /// Points are known by their place in the list; coordinates finite, equal ones allowed.
  explicit PointTree(std::span<const Vec2> points);

  /// Takes point i out. REQUIRES: it is there.
  void remove(std::uint32_t i);
  /// The first point found that is there, lies in the closed box low..high, and has wanted(i); kNone if there
  /// is none.
  template <class Wanted>
  std::uint32_t find(Vec2 low, Vec2 high, Wanted&& wanted) const;

 private:
  struct Node {
    Vec2 low, high;                    ///< box of all its points, also of those taken out
    std::uint32_t begin = 0, end = 0;  ///< of its points in order_
    std::uint32_t left = kNone;        ///< number of the left child, the right one is next; kNone for a leaf
    std::uint32_t count = 0;           ///< points still there
  };
  void build(std::uint32_t node);

  std::vector<Vec2> points_;
  std::vector<std::uint32_t> order_;     ///< points by node
  std::vector<std::uint32_t> position_;  ///< in order_, by point
  std::vector<bool> there_;              ///< by point
  std::vector<Node> nodes_;
};

template <class Wanted>
std::uint32_t PointTree::find(Vec2 low, Vec2 high, Wanted&& wanted) const {
  const auto apart = [&](Vec2 a, Vec2 b) {
    return a.x > high.x || b.x < low.x || a.y > high.y || b.y < low.y;
  };
  std::array<std::uint32_t, 64>
      open;  // halves of at most 2^32 points: depth 32, one node waits on each level
  std::size_t count = 0;
  open[count++] = 0;
  while (count > 0) {
    const Node& node = nodes_[open[--count]];
    if (node.count == 0 || apart(node.low, node.high)) continue;
    if (node.left != kNone) {
      open[count++] = node.left + 1;
      open[count++] = node.left;
      continue;
    }
    for (std::uint32_t k = node.begin; k < node.end; ++k) {
      const std::uint32_t i = order_[k];
      if (there_[i] && !apart(points_[i], points_[i]) && wanted(i)) return i;
    }
  }
  return kNone;
}

}  // namespace crossloft
