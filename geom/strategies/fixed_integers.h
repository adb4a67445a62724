#pragma once
/// Strategy: fixed-width integers on the stack, without a filter. Doubles are aligned to their common power
/// of two in the narrowest of four widths, which holds every finite double; lattice points take the exact
/// stage of geom/. Exact.

#include "../lattice_filters.h"
#include "../plane_predicates.h"
#include "aligned_unit.h"
#include "formulas.h"
#include "strategy.h"

namespace crossloft::strategies {

template <unsigned Bits>
struct FixedLoader {
  AlignedUnit unit;

  auto difference(double to, double from) const {
    return aligned::align<Bits>(to, unit.low) - aligned::align<Bits>(from, unit.low);
  }
  auto weight_difference(double to, double from) const {
    return aligned::align<2 * Bits>(to, unit.weight_low()) -
           aligned::align<2 * Bits>(from, unit.weight_low());
  }
};

class FixedIntegers {
 public:
  static constexpr std::string_view kName = "fixed";
  static constexpr Guarantee kGuarantee = Guarantee::exact;

  FixedIntegers() = default;
  explicit FixedIntegers(const Extent&) {}

  Verdict orient2d(Vec2 a, Vec2 b, Vec2 c) const {
    return sign([&](const auto& load) { return strategies::orient2d(load, a, b, c); }, a, b, c);
  }
  Verdict orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const {
    return sign([&](const auto& load) { return strategies::orient3d(load, a, b, c, d); }, a, b, c, d);
  }
  Verdict incircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) const {
    return sign([&](const auto& load) { return strategies::incircle(load, a, b, c, d); }, a, b, c, d);
  }
  Verdict insphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) const {
    return sign([&](const auto& load) { return strategies::insphere(load, a, b, c, d, e); }, a, b, c, d, e);
  }
  Verdict power_test(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c,
                     const WeightedPoint& d, const WeightedPoint& e) const {
    return sign([&](const auto& load) { return strategies::insphere(load, a, b, c, d, e); }, a, b, c, d, e);
  }

  Verdict orient3d(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                   const LatticePoint& d) const {
    return orient3d_exact(a, b, c, d);
  }
  Verdict insphere(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d,
                   const LatticePoint& e) const {
    return insphere_exact(a, b, c, d, e);
  }
  Verdict orient2d(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b,
                   const LatticePoint& c) const {
    return orient2d_exact(plane, a, b, c);
  }
  Verdict incircle(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b,
                   const LatticePoint& c, const LatticePoint& d) const {
    return incircle_exact(plane, a, b, c, d);
  }
  Verdict side_of_plane(const LatticePlane& plane, const LatticePoint& p) const {
    return side_of_plane_exact(plane, p);
  }
  Verdict side_of_meet(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c,
                       const LatticePlane& q) const {
    return side_of_meet_exact(a, b, c, q);
  }

 private:
  template <class Formula, class... Points>
  static Verdict sign(const Formula& formula, const Points&... points) {
    const AlignedUnit unit = unit_of(points...);
    if (!unit.finite) return 0;
    return aligned::with_width(unit.bits,
                               [&]<unsigned Bits>() { return formula(FixedLoader<Bits>{unit}).sign(); });
  }
};

static_assert(Strategy<FixedIntegers>);

}  // namespace crossloft::strategies
