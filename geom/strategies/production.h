#pragma once
/// Strategy: the predicates of geom/ as the product uses them. Exact.

#include "../plane_predicates.h"
#include "../predicates.h"
#include "../weighted_predicates.h"
#include "strategy.h"

namespace crossloft::strategies {

class Crossloft {
 public:
  static constexpr std::string_view kName = "crossloft";
  static constexpr Guarantee kGuarantee = Guarantee::exact;

  Crossloft() = default;
  explicit Crossloft(const Extent&) {}

  Verdict orient2d(Vec2 a, Vec2 b, Vec2 c) const { return crossloft::orient2d(a, b, c); }
  Verdict orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const {
    return crossloft::orient3d(a, b, c, d);
  }
  Verdict incircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) const { return crossloft::incircle(a, b, c, d); }
  Verdict insphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) const {
    return crossloft::insphere(a, b, c, d, e);
  }
  Verdict power_test(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c,
                     const WeightedPoint& d, const WeightedPoint& e) const {
    return crossloft::power_test(a, b, c, d, e);
  }
  Verdict orient3d(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                   const LatticePoint& d) const {
    return crossloft::orient3d(a, b, c, d);
  }
  Verdict insphere(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d,
                   const LatticePoint& e) const {
    return crossloft::insphere(a, b, c, d, e);
  }
  Verdict orient2d(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b,
                   const LatticePoint& c) const {
    return crossloft::orient2d(plane, a, b, c);
  }
  Verdict incircle(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b,
                   const LatticePoint& c, const LatticePoint& d) const {
    return crossloft::incircle(plane, a, b, c, d);
  }
  Verdict side_of_plane(const LatticePlane& plane, const LatticePoint& p) const {
    return crossloft::side_of_plane(plane, p);
  }
  Verdict side_of_meet(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c,
                       const LatticePlane& q) const {
    return crossloft::side_of_meet(a, b, c, q);
  }
};

static_assert(Strategy<Crossloft>);

}  // namespace crossloft::strategies
