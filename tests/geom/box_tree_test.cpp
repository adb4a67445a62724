#include "../../geom/box_tree.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
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

/// Against a search through all.
void check_tree(const std::vector<Bounds>& boxes, const std::vector<Bounds>& queries) {
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
    const auto distance2 = [&](std::uint32_t i) { return squared_distance(boxes[i], query.low); };
    CHECK(tree.nearest(query.low, distance2) == nearest);
  }
  std::multiset<std::pair<std::uint32_t, std::uint32_t>> found, expected;
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    for (std::uint32_t j = 0; j < i; ++j)
      if (overlap(boxes[i], boxes[j])) expected.insert({j, i});
  tree.for_pairs([&](std::uint32_t i, std::uint32_t j) { found.insert(std::minmax(i, j)); });
  CHECK(found == expected);
}

/// Points on the x axis.
std::vector<Bounds> points(std::uint32_t count, const std::function<double(std::uint32_t)>& x) {
  std::vector<Bounds> boxes;
  for (std::uint32_t i = 0; i < count; ++i) boxes.push_back({{x(i), 0, 0}, {x(i), 0, 0}});
  return boxes;
}

}  // namespace

TEST_CASE("overlaps, pairs and the nearest box are those of a search through all") {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    check_tree(random_boxes(seed * 15, seed), random_boxes(20, seed + 100));
  }
}

TEST_CASE("boxes in one place, or ever nearer together, or at the end of the doubles: a tree all the same") {
  const auto queries = random_boxes(20, 7);
  for (const std::uint32_t count : {5U, 7U, 100U}) {
    check_tree(points(count, [](std::uint32_t) { return 3.0; }), queries);
    check_tree(points(count, [](std::uint32_t i) { return std::ldexp(1.0, -static_cast<int>(i)); }), queries);
    check_tree(points(count, [](std::uint32_t i) { return i == 0 ? 3.0 : 3.5; }), queries);
    // Sums of doubled centres are infinite here.
    check_tree(points(count, [](std::uint32_t i) { return 5e307 + 4e306 * (i % 9); }), queries);
  }
}

TEST_CASE(
    "the nearest one does not depend on the order of items whose distances round below those of boxes") {
  struct Segment {
    Vec3 a, b;
  };
  // The vector to the end b is rounded twice this way.
  const auto distance2 = [](const Segment& s, Vec3 p) {
    const Vec3 along = s.b - s.a, x = p - s.a;
    const double t = std::clamp(dot(x, along) / dot(along, along), 0.0, 1.0);
    const Vec3 away = x - t * along;
    return dot(away, away);
  };
  std::mt19937 random(11);
  const auto coordinate = [&] { return static_cast<double>(random() % 100000) / 99991; };
  std::vector<Segment> segments;
  std::vector<Vec3> corners;
  for (int i = 0; i < 24; ++i) corners.push_back({coordinate(), coordinate(), 0});
  for (std::size_t i = 0; i < corners.size(); ++i)
    segments.push_back({corners[i], corners[(i + 1) % corners.size()]});
  std::vector<Vec3> queries;
  for (int i = 0; i < 20000; ++i)
    queries.push_back({3 * coordinate() - 1, 3 * coordinate() - 1, coordinate()});
  const auto nearest = [&] {
    std::vector<Bounds> boxes(segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i)
      boxes[i].add(segments[i].a), boxes[i].add(segments[i].b);
    const BoxTree tree(boxes);
    std::vector<double> found;
    for (const Vec3& p : queries)
      found.push_back(tree.nearest(p, [&](std::uint32_t i) { return distance2(segments[i], p); }));
    return found;
  };
  const std::vector<double> first = nearest();
  for (int round = 0; round < 5; ++round) {
    for (std::size_t i = segments.size() - 1; i > 0; --i)
      std::swap(segments[i], segments[random() % (i + 1)]);
    CHECK(nearest() == first);
  }
}
