#pragma once
/// Predicates over weighted points of arbitrary finite doubles for the regular triangulation, their filters
/// inlined.

#include <cstdint>
#include <span>

#include "../geom/static_bounds.h"
#include "point_predicates.h"

namespace crossloft {

/// Weighted points, of height |x|^2 - weight; the span must stay as it is. REQUIRES: finite coordinates and
/// weights.
class WeightedPredicates3 {
 public:
  explicit WeightedPredicates3(std::span<const WeightedPoint> points)
      : points_(points), bounds_(static_bounds(points)) {}

  std::uint32_t size() const { return static_cast<std::uint32_t>(points_.size()); }
  double coordinate(std::uint32_t i, int axis) const {
    const Vec3& p = points_[i].position;
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
  }
  int orient3d(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    return crossloft::orient3d(bounds_, at(a), at(b), at(c), at(d));
  }
  int power_test(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t e) const {
    return crossloft::power_test(bounds_, points_[a], points_[b], points_[c], points_[d], points_[e]);
  }
  LiftedRow lifted(std::uint32_t i, std::uint32_t origin) const {
    const filters::Lifted l = filters::lifted(points_[i], points_[origin]);
    return {l.d, l.lift};
  }
  /// Lifts may cancel, so the sizes of the terms say nothing.
  LiftedError lifted_error() const { return {.absolute = bounds_.insphere}; }
  int compare_lex(std::uint32_t a, std::uint32_t b) const {
    const auto order = at(a) <=> at(b);
    return order < 0 ? -1 : order > 0 ? 1 : 0;
  }
  int compare_height(std::uint32_t a, std::uint32_t b) const {
    return static_cast<int>(points_[a].weight < points_[b].weight) -
           static_cast<int>(points_[a].weight > points_[b].weight);
  }
  int orient2d(std::uint32_t a, std::uint32_t b, std::uint32_t c, int drop) const {
    return crossloft::orient2d(without_axis(at(a), drop), without_axis(at(b), drop),
                               without_axis(at(c), drop));
  }
  int power_test2d(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, int drop) const {
    return crossloft::power_test2d(points_[a], points_[b], points_[c], points_[d], drop);
  }
  int power_test1d(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return crossloft::power_test1d(points_[a], points_[b], points_[c]);
  }

 private:
  const Vec3& at(std::uint32_t i) const { return points_[i].position; }

  std::span<const WeightedPoint> points_;
  StaticBounds bounds_;
};

static_assert(PowerPredicates3<WeightedPredicates3> && LiftsPoints<WeightedPredicates3>);

}  // namespace crossloft
