#pragma once
/// Strategy: Boost's rationals (cpp_rational without lazy expressions), every result in lowest terms. Exact.

#include <boost/multiprecision/rational_adaptor.hpp>
#include "boost_integers.h"

namespace crossloft::strategies {

struct BoostRationalArithmetic {
  using Number = boost::multiprecision::number<
      boost::multiprecision::rational_adaptor<boost::multiprecision::cpp_int_backend<>>,
      boost::multiprecision::et_off>;
  static constexpr std::string_view kName = "cpp_rational";
  static constexpr Guarantee kGuarantee = Guarantee::exact;
  static constexpr bool kIntegers = false, kHomogeneous = false;

  static bool accepts(double v) { return std::isfinite(v); }
  static bool accepts_weight(double v) { return std::isfinite(v); }
  static Number from_integer(double v) { return Number(static_cast<std::int64_t>(v)); }
  static Number from_double(double v) {
    const aligned::Parts p = aligned::parts_of(v);
    if (p.mantissa == 0) return Number(0);
    const auto m = static_cast<std::int64_t>(p.mantissa);
    const int exponent = p.exponent - AlignedUnit::kBias;
    const BoostInteger numerator(p.negative ? -m : m);
    return exponent >= 0 ? Number(BoostInteger(numerator << exponent))
                         : Number(numerator, BoostInteger(BoostInteger(1) << -exponent));
  }
  static Number coordinate(const LatticePoint& p, int axis) {
    if (p.is_explicit()) return from_integer(p[axis]);
    return Number(to_boost(numerator(*p.exact, axis)), to_boost(p.exact->w));
  }
  static Verdict sign(const Number& v) { return v.sign(); }
};

using BoostRationals = NumberStrategy<BoostRationalArithmetic>;
static_assert(Strategy<BoostRationals>);

}  // namespace crossloft::strategies
