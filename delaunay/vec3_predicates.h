#pragma once
/// Predicates over arbitrary finite doubles (geom/predicates.h) for the triangulation in space.

#include <cstdint>
#include <span>

#include "../geom/static_bounds.h"
#include "point_predicates.h"

namespace crossloft {

/// Points in space; the span must stay as it is. REQUIRES: finite coordinates.
class Vec3Predicates3 {
 public:
  explicit Vec3Predicates3(std::span<const Vec3> points) : points_(points), bounds_(static_bounds(points)) {}

  std::uint32_t size() const { return static_cast<std::uint32_t>(points_.size()); }
  double coordinate(std::uint32_t i, int axis) const {
    const Vec3& p = points_[i];
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
  }
  int orient3d(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    return crossloft::orient3d(bounds_, points_[a], points_[b], points_[c], points_[d]);
  }
  int insphere(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t e) const {
    return crossloft::insphere(bounds_, points_[a], points_[b], points_[c], points_[d], points_[e]);
  }
  bool collinear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  int compare_lex(std::uint32_t a, std::uint32_t b) const {
    const auto order = points_[a] <=> points_[b];
    return order < 0 ? -1 : order > 0 ? 1 : 0;
  }
  LiftedRow lifted(std::uint32_t i, std::uint32_t origin) const {
    const Vec3 d = points_[i] - points_[origin];
    return {d, dot(d, d)};
  }
  LiftedError lifted_error() const { return {bounds_.insphere, filters::kRoundedTermsError}; }

 private:
  std::span<const Vec3> points_;
  StaticBounds bounds_;
};

static_assert(PointPredicates3<Vec3Predicates3> && LiftsPoints<Vec3Predicates3>);

}  // namespace crossloft
