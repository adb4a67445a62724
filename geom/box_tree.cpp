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

std::uint32_t BoxTree::build(std::uint32_t begin, std::uint32_t end) {
  const auto at = static_cast<std::uint32_t>(nodes_.size());
  Node node{{}, begin, end, 0};
  Bounds centers;
  for (std::uint32_t i = begin; i < end; ++i) {
    node.box.join(items_[i].box);
    centers.add(items_[i].box.center());
  }
  nodes_.push_back(node);
  if (end - begin <= kLeafSize) return at;
  const int axis = longest_axis(centers);
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                   [axis](const Item& a, const Item& b) {
                     return coordinate(a.box.low + a.box.high, axis) <
                            coordinate(b.box.low + b.box.high, axis);
                   });
  build(begin, middle);
  const std::uint32_t right = build(middle, end);
  nodes_[at].right = right;
  return at;
}

}  // namespace crossloft
