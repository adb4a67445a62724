#include "../../delaunay/insertion_order.h"

#include "../../delaunay/hilbert_curve.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "../../bench/point_distributions.h"

namespace {

template <std::size_t N>
void check_permutation(const std::vector<std::array<double, N>>& points) {
  std::vector<std::uint32_t> order =
      crossloft::insertion_order(std::span<const std::array<double, N>>(points));
  std::sort(order.begin(), order.end());
  REQUIRE(order.size() == points.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) CHECK(order[i] == i);
}

/// Of the way through points first..first + count - 1 in their order.
template <std::size_t N>
double length_of_way(const std::vector<std::array<double, N>>& points, std::size_t first, std::size_t count) {
  double length = 0;
  const std::array<double, N>* last = nullptr;
  for (const std::uint32_t i : crossloft::insertion_order(std::span<const std::array<double, N>>(points))) {
    if (i < first || i >= first + count) continue;
    for (std::size_t axis = 0; last != nullptr && axis < N; ++axis)
      length += std::abs(points[i][axis] - (*last)[axis]);
    last = &points[i];
  }
  return length;
}

/// Each cluster a 10^6th of the one before, and far from them all a point on each axis.
template <std::size_t N>
void check_clusters(std::size_t size) {
  constexpr std::size_t kClusters = 4;
  crossloft::bench::Draw draw(7);
  std::vector<std::array<double, N>> points(kClusters * size + N);
  double extent = 1;
  for (std::size_t k = 0; k < kClusters; ++k, extent *= 1e-6)
    for (std::size_t i = k * size; i < (k + 1) * size; ++i)
      for (double& x : points[i]) x = extent * draw.unit();
  for (std::size_t axis = 0; axis < N; ++axis) points[kClusters * size + axis][axis] = 1e9;
  check_permutation(points);
  auto first_cluster = points;
  first_cluster.resize(size);
  const double alone = length_of_way(first_cluster, 0, size);
  extent = 1;
  for (std::size_t k = 0; k < kClusters; ++k, extent *= 1e-6)
    CHECK(length_of_way(points, k * size, size) < 1.5 * extent * alone);
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

TEST_CASE("the steps in a cluster are short, however small it is beside the whole") {
  check_clusters<2>(3'000);  // these are sorted by counting,
  check_clusters<3>(3'000);
  check_clusters<3>(500);  // and these not
}

TEST_CASE("many points in one place, and beside it, come in some order") {
  std::vector<std::array<double, 2>> points(3'000, {0.25, 0.5});
  check_permutation(points);
  points.insert(points.end(), 100, {0.25, std::nextafter(0.5, 1)});
  points.push_back({1e300, -1e300});
  check_permutation(points);
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
