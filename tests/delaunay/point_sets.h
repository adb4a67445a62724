#pragma once
/// Point sets for the tests, and triangulations as sets of coordinate ranks.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <vector>

#include "../../geom/lattice.h"

namespace point_sets {

using crossloft::LatticePoint;
using crossloft::make_point;

/// n points of the cube [0, range)^3.
inline std::vector<LatticePoint> random_cube(std::size_t n, std::int64_t range, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto draw = [&] { return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(range)); };
  std::vector<LatticePoint> points;
  for (std::size_t i = 0; i < n; ++i) {
    const std::int64_t x = draw(), y = draw(), z = draw();
    points.push_back(make_point({x, y, z}));
  }
  return points;
}

inline std::vector<LatticePoint> grid(std::int64_t nx, std::int64_t ny, std::int64_t nz) {
  std::vector<LatticePoint> points;
  for (std::int64_t x = 0; x < nx; ++x)
    for (std::int64_t y = 0; y < ny; ++y)
      for (std::int64_t z = 0; z < nz; ++z) points.push_back(make_point({x, y, z}));
  return points;
}

/// All integer points with |p|^2 = square.
inline std::vector<LatticePoint> sphere(std::int64_t square) {
  std::vector<LatticePoint> points;
  for (std::int64_t x = -square; x <= square; ++x)
    for (std::int64_t y = -square; y <= square; ++y)
      for (std::int64_t z = -square; z <= square; ++z)
        if (x * x + y * y + z * z == square) points.push_back(make_point({x, y, z}));
  return points;
}

/// n random points on each of the planes z = 0, gap, 2 gap, ..
inline std::vector<LatticePoint> on_planes(std::size_t planes, std::size_t n, std::int64_t range,
                                           std::int64_t gap, std::uint64_t seed) {
  std::vector<LatticePoint> points = random_cube(planes * n, range, seed);
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i].z = static_cast<double>(static_cast<std::int64_t>(i % planes) * gap);
  return points;
}

/// Grids and random points on the six faces of a cube of side 2 half, those on its edges included.
inline std::vector<LatticePoint> on_cube_faces(std::int64_t half, std::int64_t step, std::size_t n,
                                               std::uint64_t seed) {
  std::vector<LatticePoint> points;
  for (std::int64_t x = -half; x <= half; x += step)
    for (std::int64_t y = -half; y <= half; y += step)
      for (std::int64_t z = -half; z <= half; z += step)
        if (std::max({std::abs(x), std::abs(y), std::abs(z)}) == half)
          points.push_back(make_point({x, y, z}));
  std::mt19937_64 random(seed);
  const auto draw = [&] {
    return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * half + 1)) - half;
  };
  for (std::size_t i = 0; i < n; ++i) {
    crossloft::LatticeVector v{draw(), draw(), draw()};
    v[i % 3] = i % 2 ? half : -half;
    points.push_back(make_point(v));
  }
  return points;
}

/// Corners of the octahedron |x| + |y| + |z| = h and n random points on its faces.
inline std::vector<LatticePoint> on_octahedron(std::int64_t h, std::size_t n, std::uint64_t seed) {
  std::vector<LatticePoint> points;
  for (const std::int64_t s : {-h, h})
    for (const crossloft::LatticeVector& v : {crossloft::LatticeVector{s, 0, 0}, {0, s, 0}, {0, 0, s}})
      points.push_back(make_point(v));
  std::mt19937_64 random(seed);
  const auto draw = [&](std::int64_t to) {
    return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(to + 1));
  };
  for (std::size_t i = 0; i < n; ++i) {
    const std::int64_t x = draw(h), y = draw(h - x), z = h - x - y;
    points.push_back(make_point({i & 1 ? x : -x, i & 2 ? y : -y, i & 4 ? z : -z}));
  }
  return points;
}

inline void shuffle(std::vector<LatticePoint>& points, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::shuffle(points.begin(), points.end(), random);
}

/// Rank of each point in the lexicographic order of the distinct points.
inline std::vector<std::uint32_t> ranks(const std::vector<LatticePoint>& points) {
  std::vector<std::uint32_t> order(points.size()), rank(points.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto compare = [&](std::uint32_t a, std::uint32_t b) { return compare_lex(points[a], points[b]); };
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return compare(a, b) < 0; });
  for (std::size_t k = 1; k < order.size(); ++k)
    rank[order[k]] = rank[order[k - 1]] + (compare(order[k - 1], order[k]) != 0);
  return rank;
}

/// Simplices as a sorted list of sorted ranks: equal iff the triangulations are the same sets.
template <std::size_t N>
std::vector<std::array<std::uint32_t, N>> by_rank(std::vector<std::array<std::uint32_t, N>> simplices,
                                                  const std::vector<std::uint32_t>& rank) {
  for (auto& s : simplices) {
    for (auto& v : s) v = rank[v];
    std::sort(s.begin(), s.end());
  }
  std::sort(simplices.begin(), simplices.end());
  return simplices;
}

}  // namespace point_sets
