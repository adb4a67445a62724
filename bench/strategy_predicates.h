#pragma once
/// A strategy as the predicates of a triangulation of plain points.

#include <cstdint>
#include <span>

#include "../delaunay/point_predicates.h"
#include "../geom/strategies/strategy.h"

namespace crossloft::bench {

/// Points in space; the span must stay as it is. An unknown answer counts as 0, so a filter alone is not fit
/// for a triangulation; neither is a strategy without guarantee on anything but points in general position.
template <strategies::Strategy S>
class StrategyPredicates3 {
 public:
  StrategyPredicates3(std::span<const Vec3> points, const S& strategy)
      : points_(points), strategy_(strategy) {}

  std::uint32_t size() const { return static_cast<std::uint32_t>(points_.size()); }
  double coordinate(std::uint32_t i, int axis) const {
    const Vec3& p = points_[i];
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
  }
  int orient3d(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    return known(strategy_.orient3d(points_[a], points_[b], points_[c], points_[d]));
  }
  int insphere(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t e) const {
    return known(strategy_.insphere(points_[a], points_[b], points_[c], points_[d], points_[e]));
  }
  /// Three points off a line span a plane, which misses one of four points that are affinely independent.
  bool collinear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    for (const Vec3& corner : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
      if (known(strategy_.orient3d(points_[a], points_[b], points_[c], corner)) != 0) return false;
    return true;
  }
  int compare_lex(std::uint32_t a, std::uint32_t b) const {
    const auto order = points_[a] <=> points_[b];
    return order < 0 ? -1 : order > 0 ? 1 : 0;
  }
  const S& strategy() const { return strategy_; }

 private:
  static int known(strategies::Verdict v) { return v == strategies::kUnknown ? 0 : v; }

  std::span<const Vec3> points_;
  S strategy_;
};

}  // namespace crossloft::bench
