#include "point_tree.h"

#include <algorithm>
#include <numeric>

namespace crossloft {

PointTree::PointTree(std::span<const Vec2> points)
    : points_(points.begin(), points.end()),
      order_(points.size()),
      position_(points.size()),
      there_(points.size(), true) {
  const auto n = static_cast<std::uint32_t>(points.size());
  std::iota(order_.begin(), order_.end(), 0u);
  nodes_.push_back({{}, {}, 0, n, kNone, n});
  if (n > 0) build(0);
  for (std::uint32_t k = 0; k < n; ++k) position_[order_[k]] = k;
}

void PointTree::build(std::uint32_t node) {
  constexpr std::uint32_t kLeaf = 8;
  const std::uint32_t begin = nodes_[node].begin, end = nodes_[node].end;
  Vec2 low = points_[order_[begin]], high = low;
  for (std::uint32_t k = begin; k < end; ++k) {
    const Vec2 p = points_[order_[k]];
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  nodes_[node].low = low, nodes_[node].high = high;
  if (end - begin <= kLeaf) return;
  const bool by_x = high.x - low.x >= high.y - low.y;
  const auto key = [&](std::uint32_t i) { return std::pair{by_x ? points_[i].x : points_[i].y, i}; };
  const std::uint32_t middle = begin + (end - begin) / 2, left = static_cast<std::uint32_t>(nodes_.size());
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t i, std::uint32_t j) { return key(i) < key(j); });
  nodes_[node].left = left;
  nodes_.push_back({{}, {}, begin, middle, kNone, middle - begin});
  nodes_.push_back({{}, {}, middle, end, kNone, end - middle});
  build(left);
  build(left + 1);
}

void PointTree::remove(std::uint32_t i) {
  there_[i] = false;
  for (std::uint32_t node = 0;;) {
    --nodes_[node].count;
    const std::uint32_t left = nodes_[node].left;
    if (left == kNone) return;
    node = position_[i] < nodes_[left].end ? left : left + 1;
  }
}

}  // namespace crossloft
