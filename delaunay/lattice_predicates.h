#pragma once
/// Predicates over lattice points (geom/lattice.h) for the triangulations, their filters inlined.

#include <cstdint>
#include <span>
#include <vector>

#include "../geom/lattice_filters.h"
#include "point_predicates.h"

namespace crossloft {

/// True iff the points lie on one line, or two are equal.
bool collinear(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c);

/// Points in space; the span must stay as it is.
class LatticePredicates3 {
 public:
  explicit LatticePredicates3(std::span<const LatticePoint> points) : points_(points) {}

  std::uint32_t size() const { return static_cast<std::uint32_t>(points_.size()); }
  double coordinate(std::uint32_t i, int axis) const { return points_[i][axis]; }
  int orient3d(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    if (const int sign = orient3d_filter(points_[a], points_[b], points_[c], points_[d])) return sign;
    return orient3d_exact(points_[a], points_[b], points_[c], points_[d]);
  }
  int insphere(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t e) const {
    if (const int sign = insphere_filter(points_[a], points_[b], points_[c], points_[d], points_[e]))
      return sign;
    return insphere_exact(points_[a], points_[b], points_[c], points_[d], points_[e]);
  }
  bool collinear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return crossloft::collinear(points_[a], points_[b], points_[c]);
  }
  int compare_lex(std::uint32_t a, std::uint32_t b) const {
    return crossloft::compare_lex(points_[a], points_[b]);
  }

 private:
  std::span<const LatticePoint> points_;
};

/// Points of one plane, oriented by its normal; the vector may grow between calls of the triangulation.
/// Ranked in space, so that the triangulation fits that of a cell. Coordinates are those off the dominant
/// axis.
class LatticePredicates2 {
 public:
  /// REQUIRES: all points on the plane.
  LatticePredicates2(const LatticePlane& plane, const std::vector<LatticePoint>& points);

  std::uint32_t size() const { return static_cast<std::uint32_t>(points_->size()); }
  double coordinate(std::uint32_t i, int axis) const { return (*points_)[i][axis == 0 ? first_ : second_]; }
  int orient2d(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    if (const int sign = orient2d_filter(plane_, (*points_)[a], (*points_)[b], (*points_)[c])) return sign;
    return orient2d_exact(plane_, (*points_)[a], (*points_)[b], (*points_)[c]);
  }
  int incircle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    if (const int sign = incircle_filter(plane_, (*points_)[a], (*points_)[b], (*points_)[c], (*points_)[d]))
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
  int first_, second_;
};

static_assert(PointPredicates3<LatticePredicates3>);
static_assert(MetricPredicates2<LatticePredicates2>);

}  // namespace crossloft
