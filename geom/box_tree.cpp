#include "box_tree.h"

namespace crossloft {
namespace {

constexpr std::uint32_t kLeafSize = 4;

double coordinate(const Vec3& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

int longest_axis(const Bounds& box) {
  const Vec3 d = box.high - box.low;
  if (d.x >= d.y && d.x >= d.z) return 0;
  return d.y >= d.z ? 1 : 2;
}

}  // namespace

BoxTree::BoxTree(std::span<const Bounds> boxes) {
  items_.reserve(boxes.size());
  for (const Bounds& box : boxes) items_.push_back({box, static_cast<std::uint32_t>(items_.size())});
  nodes_.reserve(boxes.size());
  if (!items_.empty()) build(0, static_cast<std::uint32_t>(items_.size()));
}

/// Half of the space where each side gets a fair part of the items, which takes one pass; half of the items
/// else, so that the depth is logarithmic.
std::uint32_t BoxTree::split(std::uint32_t begin, std::uint32_t end) {
  constexpr std::uint32_t kLeastPart = 8;
  Bounds centers;  // twice
  for (std::uint32_t i = begin; i < end; ++i) centers.add(items_[i].box.low + items_[i].box.high);
  const int axis = longest_axis(centers);
  const auto at = [&](const Item& item) {
    return coordinate(item.box.low, axis) + coordinate(item.box.high, axis);
  };
  const double half = 0.5 * coordinate(centers.low + centers.high, axis);
  const auto first = items_.begin() + begin, last = items_.begin() + end;
  const auto parted = std::partition(first, last, [&](const Item& item) { return at(item) < half; });
  const auto left = static_cast<std::uint32_t>(parted - first), right = end - begin - left;
  if (std::min(left, right) >= std::max(1U, (end - begin) / kLeastPart)) return begin + left;
  const std::uint32_t middle = (end - begin) / 2;
  std::nth_element(first, first + middle, last, [&](const Item& a, const Item& b) { return at(a) < at(b); });
  return begin + middle;
}

std::uint32_t BoxTree::build(std::uint32_t begin, std::uint32_t end) {
  const auto at = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({{}, begin, end, 0});
  Bounds box;
  if (end - begin <= kLeafSize) {
    for (std::uint32_t i = begin; i < end; ++i) box.join(items_[i].box);
  } else {
    const std::uint32_t middle = split(begin, end);
    box = nodes_[build(begin, middle)].box;
    const std::uint32_t right = build(middle, end);
    nodes_[at].right = right;
    box.join(nodes_[right].box);
  }
  nodes_[at].box = box;
  return at;
}

}  // namespace crossloft
