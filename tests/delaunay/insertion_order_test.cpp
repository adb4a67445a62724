#include "../../delaunay/insertion_order.h"

#include "../../delaunay/hilbert_curve.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

template <std::size_t N>
void check_permutation(const std::vector<std::array<double, N>>& points) {
  std::vector<std::uint32_t> order =
      crossloft::insertion_order(std::span<const std::array<double, N>>(points));
  std::sort(order.begin(), order.end());
  REQUIRE(order.size() == points.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) CHECK(order[i] == i);
}

}  // namespace

TEST_CASE("the order is a permutation, for extents of any size") {
  check_permutation<2>({});
  check_permutation<3>({{1, 2, 3}});
  check_permutation<3>({{1, 2, 3}, {1, 2, 3}});
  constexpr double big = std::numeric_limits<double>::max(), tiny = std::numeric_limits<double>::denorm_min();
  check_permutation<3>({{big, -big, 0}, {-big, big, 0}, {0, 0, tiny}});
  check_permutation<2>({{0, 0}, {tiny, 3 * tiny}});
}

TEST_CASE("the last round walks in short steps") {
  std::vector<std::array<double, 3>> points;
  for (int x = 0; x < 32; ++x)
    for (int y = 0; y < 32; ++y)
      for (int z = 0; z < 32; ++z)
        points.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
  const auto order = crossloft::insertion_order(std::span<const std::array<double, 3>>(points));
  double length = 0;
  const std::size_t begin = points.size() / 2;
  for (std::size_t k = begin; k < order.size(); ++k)
    for (std::size_t axis = 0; axis < 3; ++axis)
      length += std::abs(points[order[k]][axis] - points[order[k - 1]][axis]);
  CHECK(length / static_cast<double>(order.size() - begin) < 1.3);  // 8/7 cells a step along the curve
}

TEST_CASE("the curve passes all cells once, each beside the one before") {
  using Cell = std::array<std::uint32_t, 3>;
  std::vector<Cell> along(16 * 16 * 16, Cell{99, 99, 99});
  for (std::uint32_t x = 0; x < 16; ++x)
    for (std::uint32_t y = 0; y < 16; ++y)
      for (std::uint32_t z = 0; z < 16; ++z)
        along[crossloft::detail::HilbertCurve<3>::position({x, y, z}, 4)] = {x, y, z};
  for (std::size_t k = 1; k < along.size(); ++k) {
    int steps = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      steps += std::abs(static_cast<int>(along[k][axis]) - static_cast<int>(along[k - 1][axis]));
    CHECK(steps == 1);
  }
  std::vector<std::array<std::uint32_t, 2>> flat(64, {99, 99});
  for (std::uint32_t x = 0; x < 8; ++x)
    for (std::uint32_t y = 0; y < 8; ++y) flat[crossloft::detail::HilbertCurve<2>::position({x, y}, 3)] = {x, y};
  for (std::size_t k = 1; k < flat.size(); ++k)
    CHECK(std::abs(static_cast<int>(flat[k][0]) - static_cast<int>(flat[k - 1][0])) +
              std::abs(static_cast<int>(flat[k][1]) - static_cast<int>(flat[k - 1][1])) ==
          1);
}
