#pragma once
/// Predicates over lattice points (geom/lattice.h) for the triangulations, their filters inlined.

#include <cstdint>
#include <span>
#include <vector>

#include "../geom/inline_filters.h"
#include "../geom/static_bounds.h"
#include "point_predicates.h"

namespace crossloft {

/// True iff the points lie on one line, or two are equal.
bool collinear(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c);

inline LiftedRow lifted_row(const LatticePoint& p, const LatticePoint& origin) {
  const Vec3 d = filters::difference(p, origin);
  return {d, dot(d, d)};
}
/// Only the bounds of explicit points alone have a scale; then nothing is blurred.
inline LiftedError lifted_error(const StaticBounds& bounds) {
  LiftedError error{.absolute = bounds.insphere};
  if (bounds.scale != 0) error.relative = filters::kTermsError;
  return error;
}

/// Points in space; the span must stay as it is.
class LatticePredicates3 {
 public:
  explicit LatticePredicates3(std::span<const LatticePoint> points)
      : points_(points), bounds_(static_bounds(points)) {}

  std::uint32_t size() const { return static_cast<std::uint32_t>(points_.size()); }
  double coordinate(std::uint32_t i, int axis) const { return points_[i][axis]; }
  int orient3d(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    return crossloft::orient3d(bounds_, points_[a], points_[b], points_[c], points_[d]);
  }
  int insphere(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t e) const {
    return crossloft::insphere(bounds_, points_[a], points_[b], points_[c], points_[d], points_[e]);
  }
  bool collinear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return crossloft::collinear(points_[a], points_[b], points_[c]);
  }
  int compare_lex(std::uint32_t a, std::uint32_t b) const {
    return crossloft::compare_lex(points_[a], points_[b]);
  }
  LiftedRow lifted(std::uint32_t i, std::uint32_t origin) const {
    return lifted_row(points_[i], points_[origin]);
  }
  LiftedError lifted_error() const { return crossloft::lifted_error(bounds_); }

 private:
  std::span<const LatticePoint> points_;
  StaticBounds bounds_;
};

/// Points of one plane, oriented by its normal; the vector may grow between calls of the triangulation.
/// Ranked in space, so that the triangulation fits that of a cell. Coordinates are those off the dominant
/// axis.
class LatticePredicates2 {
 public:
  /// REQUIRES: all points on the plane.
  LatticePredicates2(const LatticePlane& plane, const std::vector<LatticePoint>& points);

  std::uint32_t size() const { return static_cast<std::uint32_t>(points_->size()); }
  double coordinate(std::uint32_t i, int axis) const {
    return (*points_)[i][axis == 0 ? projection_.u : projection_.v];
  }
  int orient2d(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    if constexpr (!kInlineFilters)
      return crossloft::orient2d(plane_, (*points_)[a], (*points_)[b], (*points_)[c]);
    if (const int sign = orient2d_filter(projection_, (*points_)[a], (*points_)[b], (*points_)[c]))
      return sign;
    return orient2d_exact(plane_, (*points_)[a], (*points_)[b], (*points_)[c]);
  }
  int incircle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    if constexpr (!kInlineFilters)
      return crossloft::incircle(plane_, (*points_)[a], (*points_)[b], (*points_)[c], (*points_)[d]);
    if (const int sign =
            incircle_filter(projection_, (*points_)[a], (*points_)[b], (*points_)[c], (*points_)[d]))
      return sign;
    return incircle_exact(plane_, (*points_)[a], (*points_)[b], (*points_)[c], (*points_)[d]);
  }
  int compare_lex(std::uint32_t a, std::uint32_t b) const {
    return crossloft::compare_lex((*points_)[a], (*points_)[b]);
  }
  double squared_distance(std::uint32_t a, std::uint32_t b) const;

 private:
  LatticePlane plane_;
  const std::vector<LatticePoint>* points_;
  filters::Projection projection_;
};

static_assert(PointPredicates3<LatticePredicates3> && LiftsPoints<LatticePredicates3>);
static_assert(MetricPredicates2<LatticePredicates2>);

}  // namespace crossloft
