#include "../../geom/box_tree.h"

#include <doctest/doctest.h>

#include <random>
#include <set>
#include <utility>

using namespace crossloft;

namespace {

/// Boxes on a coarse grid, so that many only touch; some are points.
std::vector<Bounds> random_boxes(std::uint32_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<Bounds> boxes;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto coordinate = [&] { return static_cast<double>(random() % 16); };
    const auto size = [&] { return static_cast<double>(random() % 3); };
    const Vec3 low{coordinate(), coordinate(), coordinate()};
    boxes.push_back({low, low + Vec3{size(), size(), size()}});
  }
  return boxes;
}

}  // namespace

TEST_CASE("overlaps, pairs and the nearest box are those of a search through all") {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    const auto boxes = random_boxes(seed * 15, seed), queries = random_boxes(20, seed + 100);
    const BoxTree tree(boxes);
    CHECK(tree.empty() == boxes.empty());
    for (const Bounds& query : queries) {
      std::multiset<std::uint32_t> found, expected;
      double nearest = Bounds::kFar;
      for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        if (overlap(boxes[i], query)) expected.insert(i);
        nearest = std::min(nearest, squared_distance(boxes[i], query.low));
      }
      tree.for_overlaps(query, [&](std::uint32_t i) { found.insert(i); });
      CHECK(found == expected);
      CHECK(tree.nearest(query.low, [&](std::uint32_t i) { return squared_distance(boxes[i], query.low); }) == nearest);
    }
    std::multiset<std::pair<std::uint32_t, std::uint32_t>> found, expected;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
      for (std::uint32_t j = 0; j < i; ++j)
        if (overlap(boxes[i], boxes[j])) expected.insert({j, i});
    tree.for_pairs([&](std::uint32_t i, std::uint32_t j) { found.insert(std::minmax(i, j)); });
    CHECK(found == expected);
  }
}
