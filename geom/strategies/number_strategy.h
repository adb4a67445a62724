#pragma once
/// A strategy out of a number type: all predicates are written once (formulas.h, lattice_formulas.h), an
/// arithmetic says how numbers are made and what their sign is.

#include <concepts>

#include "fixed_integers.h"
#include "lattice_formulas.h"
#include "strategy.h"

namespace crossloft::strategies {

/// What NumberStrategy asks of an arithmetic A. A::Number has + - * (by value or reference, no lazy
/// expressions), and
/// - sign(n): -1, 0, +1 or kUnknown;
/// - accepts(coordinate), accepts_weight(weight): the formulas hold for it. What is not accepted, NaN and
///   infinity always, an exact strategy leaves to FixedIntegers and a filter leaves open;
/// - from_integer(v): an integer |v| <= 2^53;
/// - kIntegers: doubles come as from_parts(mantissa, shift), |mantissa| < 2^53 times 2^shift, shift >= 0, in
///   units of the call; otherwise as from_double(v);
/// - kHomogeneous: a rational lattice point comes as from_fixed(numerators and weight), all of one point
///   scaled alike by any positive factor; otherwise each of its coordinates as coordinate(point, axis).
template <class A>
concept Arithmetic = requires(const typename A::Number& n, double v) {
  { A::kName } -> std::convertible_to<std::string_view>;
  { A::kGuarantee } -> std::convertible_to<Guarantee>;
  { A::kIntegers } -> std::convertible_to<bool>;
  { A::kHomogeneous } -> std::convertible_to<bool>;
  { A::sign(n) } -> std::same_as<Verdict>;
  { A::accepts(v) } -> std::same_as<bool>;
  { A::accepts_weight(v) } -> std::same_as<bool>;
  { A::from_integer(v) } -> std::same_as<typename A::Number>;
};

template <class A>
struct DirectLoader {
  auto difference(double to, double from) const { return A::from_double(to) - A::from_double(from); }
  auto weight_difference(double to, double from) const { return difference(to, from); }
};

template <class A>
struct IntegerLoader {
  AlignedUnit unit;

  static auto load(double v, int low) {
    const aligned::Parts p = aligned::parts_of(v);
    const auto m = static_cast<std::int64_t>(p.mantissa);
    return A::from_parts(p.negative ? -m : m, m == 0 ? 0 : p.exponent - low);
  }
  auto difference(double to, double from) const { return load(to, unit.low) - load(from, unit.low); }
  auto weight_difference(double to, double from) const {
    return load(to, unit.weight_low()) - load(from, unit.weight_low());
  }
};

template <Arithmetic A>
class NumberStrategy {
 public:
  static constexpr std::string_view kName = A::kName;
  static constexpr Guarantee kGuarantee = A::kGuarantee;

  NumberStrategy() = default;
  explicit NumberStrategy(const Extent&) {}

  Verdict orient2d(Vec2 a, Vec2 b, Vec2 c) const {
    if (!accepted(a, b, c)) return otherwise([&](const auto& s) { return s.orient2d(a, b, c); });
    return A::sign(strategies::orient2d(loader(a, b, c), a, b, c));
  }
  Verdict orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const {
    if (!accepted(a, b, c, d)) return otherwise([&](const auto& s) { return s.orient3d(a, b, c, d); });
    return A::sign(strategies::orient3d(loader(a, b, c, d), a, b, c, d));
  }
  Verdict incircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) const {
    if (!accepted(a, b, c, d)) return otherwise([&](const auto& s) { return s.incircle(a, b, c, d); });
    return A::sign(strategies::incircle(loader(a, b, c, d), a, b, c, d));
  }
  Verdict insphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) const {
    if (!accepted(a, b, c, d, e)) return otherwise([&](const auto& s) { return s.insphere(a, b, c, d, e); });
    return A::sign(strategies::insphere(loader(a, b, c, d, e), a, b, c, d, e));
  }
  Verdict power_test(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c,
                     const WeightedPoint& d, const WeightedPoint& e) const {
    if (!accepted(a, b, c, d, e))
      return otherwise([&](const auto& s) { return s.power_test(a, b, c, d, e); });
    return A::sign(strategies::insphere(loader(a, b, c, d, e), a, b, c, d, e));
  }

  Verdict orient3d(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                   const LatticePoint& d) const {
    return strategies::orient3d<A>(a, b, c, d);
  }
  Verdict insphere(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d,
                   const LatticePoint& e) const {
    return strategies::insphere<A>(a, b, c, d, e);
  }
  Verdict orient2d(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b,
                   const LatticePoint& c) const {
    return strategies::orient2d<A>(plane, a, b, c);
  }
  Verdict incircle(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b,
                   const LatticePoint& c, const LatticePoint& d) const {
    return strategies::incircle<A>(plane, a, b, c, d);
  }
  Verdict side_of_plane(const LatticePlane& plane, const LatticePoint& p) const {
    return strategies::side_of_plane<A>(plane, p);
  }
  Verdict side_of_meet(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c,
                       const LatticePlane& q) const {
    return strategies::side_of_meet<A>(a, b, c, q);
  }

 private:
  static bool accepts(Vec2 p) { return A::accepts(p.x) && A::accepts(p.y); }
  static bool accepts(const Vec3& p) { return A::accepts(p.x) && A::accepts(p.y) && A::accepts(p.z); }
  static bool accepts(const WeightedPoint& p) { return accepts(p.position) && A::accepts_weight(p.weight); }
  template <class... Points>
  static bool accepted(const Points&... points) {
    return (accepts(points) && ...);
  }

  template <class... Points>
  static auto loader(const Points&... points) {
    if constexpr (A::kIntegers) {
      return IntegerLoader<A>{unit_of(points...)};
    } else {
      return DirectLoader<A>{};
    }
  }

  template <class Question>
  static Verdict otherwise(const Question& question) {
    return kGuarantee == Guarantee::exact ? question(FixedIntegers()) : kUnknown;
  }
};

}  // namespace crossloft::strategies
