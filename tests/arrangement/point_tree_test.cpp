#include "../../arrangement/point_tree.h"

#include <doctest/doctest.h>

#include <random>

using namespace crossloft;

TEST_CASE("no points, nothing found") {
  const PointTree tree({});
  CHECK(tree.find({-1, -1}, {1, 1}, [](std::uint32_t) { return true; }) == kNone);
}

TEST_CASE("finds what a pass over all points finds, while points go") {
  const std::uint64_t seed = 11;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (const std::uint64_t range : {3u, 40u, 1000000u}) {  // many equal points, some, hardly any
    const auto coordinate = [&] { return static_cast<double>(random() % range); };
    std::vector<Vec2> points(300);
    for (Vec2& p : points) p = {coordinate(), coordinate()};
    PointTree tree(points);
    std::vector<bool> there(points.size(), true);
    for (std::size_t step = 0; step < points.size(); ++step) {
      const Vec2 a{coordinate(), coordinate()}, b{coordinate(), coordinate()};
      const Vec2 low{std::min(a.x, b.x), std::min(a.y, b.y)}, high{std::max(a.x, b.x), std::max(a.y, b.y)};
      std::vector<std::uint32_t> expected, found;
      for (std::uint32_t i = 0; i < points.size(); ++i)
        if (there[i] && points[i].x >= low.x && points[i].x <= high.x && points[i].y >= low.y && points[i].y <= high.y)
          expected.push_back(i);
      tree.find(low, high, [&](std::uint32_t i) { return found.push_back(i), false; });
      std::sort(found.begin(), found.end());
      CHECK(found == expected);
      std::size_t out = random() % points.size();
      while (!there[out]) out = (out + 1) % points.size();
      there[out] = false;
      tree.remove(static_cast<std::uint32_t>(out));
    }
  }
}

TEST_CASE("the first that is wanted ends the search") {
  const std::vector<Vec2> points(100, Vec2{1, 2});
  const PointTree tree(points);
  int asked = 0;
  CHECK(tree.find({1, 2}, {1, 2}, [&](std::uint32_t i) { return ++asked, i == 37; }) == 37);
  CHECK(asked <= 100);
  CHECK(tree.find({1, 2}, {1, 2}, [](std::uint32_t i) { return i == 100; }) == kNone);
}
