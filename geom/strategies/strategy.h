#pragma once
/// The concept of a predicate strategy: one way to get the signs of geom's predicates, from plain doubles to
/// rational numbers, made to be compared with the others. The product itself uses the functions of geom/.
///
/// A strategy is a small object made from the Extent of its data. Its members have the meaning and signs of
/// the functions of the same name in predicates.h, weighted_predicates.h, lattice.h and plane_predicates.h,
/// and answer -1, 0, +1 or kUnknown. What an answer is worth is its kGuarantee.
///
/// NaN and infinity: an exact strategy answers 0 as the functions of geom/ do, a filter kUnknown.

#include <concepts>
#include <string_view>

#include "../lattice.h"
#include "../vec2.h"
#include "../weighted_point.h"
#include "extent.h"

namespace crossloft::strategies {

/// -1, 0, +1 or kUnknown.
using Verdict = int;
inline constexpr Verdict kUnknown = 2;

enum class Guarantee {
  none,    ///< any answer may be wrong
  filter,  ///< an answer is true, but may be kUnknown
  exact,   ///< every answer is true and known, for all finite input
};

template <class S>
concept Strategy = std::constructible_from<S, const Extent&> &&
    requires(const S& s, Vec2 v2, Vec3 v3, const WeightedPoint& w, const LatticePoint& p,
             const LatticePlane& plane) {
  { S::kName } -> std::convertible_to<std::string_view>;
  { S::kGuarantee } -> std::convertible_to<Guarantee>;
  { s.orient2d(v2, v2, v2) } -> std::same_as<Verdict>;
  { s.orient3d(v3, v3, v3, v3) } -> std::same_as<Verdict>;
  { s.incircle(v2, v2, v2, v2) } -> std::same_as<Verdict>;
  { s.insphere(v3, v3, v3, v3, v3) } -> std::same_as<Verdict>;
  { s.power_test(w, w, w, w, w) } -> std::same_as<Verdict>;
  { s.orient3d(p, p, p, p) } -> std::same_as<Verdict>;
  { s.insphere(p, p, p, p, p) } -> std::same_as<Verdict>;
  { s.orient2d(plane, p, p, p) } -> std::same_as<Verdict>;
  { s.incircle(plane, p, p, p, p) } -> std::same_as<Verdict>;
  { s.side_of_plane(plane, p) } -> std::same_as<Verdict>;
  { s.side_of_meet(plane, plane, plane, plane) } -> std::same_as<Verdict>;
};

/// For strategies made of others: every predicate becomes a question, a function from any strategy to its
/// verdict, which Derived::ask(question) puts to whom it likes.
template <class Derived>
class Asking {
 public:
  Verdict orient2d(Vec2 a, Vec2 b, Vec2 c) const {
    return put([&](const auto& s) { return s.orient2d(a, b, c); });
  }
  Verdict orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const {
    return put([&](const auto& s) { return s.orient3d(a, b, c, d); });
  }
  Verdict incircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) const {
    return put([&](const auto& s) { return s.incircle(a, b, c, d); });
  }
  Verdict insphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) const {
    return put([&](const auto& s) { return s.insphere(a, b, c, d, e); });
  }
  Verdict power_test(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c,
                     const WeightedPoint& d, const WeightedPoint& e) const {
    return put([&](const auto& s) { return s.power_test(a, b, c, d, e); });
  }
  Verdict orient3d(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
                   const LatticePoint& d) const {
    return put([&](const auto& s) { return s.orient3d(a, b, c, d); });
  }
  Verdict insphere(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d,
                   const LatticePoint& e) const {
    return put([&](const auto& s) { return s.insphere(a, b, c, d, e); });
  }
  Verdict orient2d(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b,
                   const LatticePoint& c) const {
    return put([&](const auto& s) { return s.orient2d(plane, a, b, c); });
  }
  Verdict incircle(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b,
                   const LatticePoint& c, const LatticePoint& d) const {
    return put([&](const auto& s) { return s.incircle(plane, a, b, c, d); });
  }
  Verdict side_of_plane(const LatticePlane& plane, const LatticePoint& p) const {
    return put([&](const auto& s) { return s.side_of_plane(plane, p); });
  }
  Verdict side_of_meet(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c,
                       const LatticePlane& q) const {
    return put([&](const auto& s) { return s.side_of_meet(a, b, c, q); });
  }

 private:
  template <class Question>
  Verdict put(const Question& question) const {
    return static_cast<const Derived&>(*this).ask(question);
  }
};

}  // namespace crossloft::strategies
