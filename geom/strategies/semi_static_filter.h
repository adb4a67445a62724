#pragma once
/// Strategy: the filters of geom/, whose bounds follow the largest differences of each call
/// (double_filters.h, weighted_filters.h, lattice_filters.h). A filter.

#include "../double_filters.h"
#include "../lattice_filters.h"
#include "../plane_predicates.h"
#include "../weighted_filters.h"
#include "strategy.h"

namespace crossloft::strategies {

class SemiStaticFilter {
 public:
  static constexpr std::string_view kName = "semi-static";
  static constexpr Guarantee kGuarantee = Guarantee::filter;

  SemiStaticFilter() = default;
  explicit SemiStaticFilter(const Extent&) {}

  Verdict orient2d(Vec2 a, Vec2 b, Vec2 c) const { return verdict(orient2d_filter(a, b, c)); }
  Verdict orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const {
    return verdict(orient3d_filter(a, b, c, d));
  }
  Verdict incircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) const { return verdict(incircle_filter(a, b, c, d)); }
  Verdict insphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) const {
    return verdict(insphere_filter(a, b, c, d, e));
  }
  Verdict power_test(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c,
                     const WeightedPoint& d, const WeightedPoint& e) const {
    return verdict(power_test_filter(a, b, c, d, e));
  }
  Verdict orient3d(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                   const LatticePoint& d) const {
    return verdict(orient3d_filter(a, b, c, d));
  }
  Verdict insphere(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d,
                   const LatticePoint& e) const {
    return verdict(insphere_filter(a, b, c, d, e));
  }
  Verdict orient2d(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b,
                   const LatticePoint& c) const {
    return verdict(orient2d_filter(plane, a, b, c));
  }
  Verdict incircle(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b,
                   const LatticePoint& c, const LatticePoint& d) const {
    return verdict(incircle_filter(plane, a, b, c, d));
  }
  Verdict side_of_plane(const LatticePlane& plane, const LatticePoint& p) const {
    return verdict(side_of_plane_filter(plane, p));
  }
  Verdict side_of_meet(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c,
                       const LatticePlane& q) const {
    return verdict(side_of_meet_filter(a, b, c, q));
  }

 private:
  /// A filter's 0 means that it can't tell.
  static Verdict verdict(int sign) { return sign == 0 ? kUnknown : sign; }
};

static_assert(Strategy<SemiStaticFilter>);

}  // namespace crossloft::strategies
