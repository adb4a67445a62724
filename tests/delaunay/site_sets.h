#pragma once
/// Weighted points for the tests: integer positions and weights.

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "../../geom/lattice.h"
#include "../../geom/weighted_point.h"

namespace site_sets {

using crossloft::LatticePoint;
using crossloft::WeightedPoint;

/// The points with weights drawn from 0..range-1.
inline std::vector<WeightedPoint> weighted(const std::vector<LatticePoint>& points, int range,
                                           std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<WeightedPoint> sites;
  for (const LatticePoint& p : points)
    sites.push_back({{p.x, p.y, p.z}, static_cast<double>(random() % static_cast<std::uint64_t>(range))});
  return sites;
}

inline std::vector<LatticePoint> positions(const std::vector<WeightedPoint>& sites) {
  std::vector<LatticePoint> points;
  for (const WeightedPoint& s : sites) {
    const auto whole = [](double v) { return static_cast<std::int64_t>(v); };
    points.push_back(crossloft::make_point({whole(s.position.x), whole(s.position.y), whole(s.position.z)}));
  }
  return points;
}

/// The heaviest site of each place, by place.
inline std::vector<WeightedPoint> sorted_heaviest(std::vector<WeightedPoint> sites) {
  std::sort(sites.begin(), sites.end(), [](const WeightedPoint& a, const WeightedPoint& b) {
    return a.position != b.position ? a.position < b.position : a.weight > b.weight;
  });
  const auto same_place = [](const WeightedPoint& a, const WeightedPoint& b) {
    return a.position == b.position;
  };
  sites.erase(std::unique(sites.begin(), sites.end(), same_place), sites.end());
  return sites;
}

inline std::vector<int> weights(const std::vector<WeightedPoint>& sites) {
  std::vector<int> result;
  for (const WeightedPoint& s : sites) result.push_back(static_cast<int>(s.weight));
  return result;
}

}  // namespace site_sets
