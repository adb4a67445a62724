#pragma once
/// Strategy: Boost's integers (cpp_int without lazy expressions) on aligned doubles and homogeneous
/// coordinates. Exact.

#include "../homogeneous.h"
#include "number_strategy.h"

namespace crossloft::strategies {

using BoostInteger =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;

template <unsigned Bits>
BoostInteger to_boost(const FixedInt<Bits>& v) {
  const FixedInt<Bits> size = v.negative() ? -v : v;
  BoostInteger r;
  import_bits(r, size.limb.begin(), size.limb.end(), 64, false);
  return v.negative() ? BoostInteger(-r) : r;
}

struct BoostIntegerArithmetic {
  using Number = BoostInteger;
  static constexpr std::string_view kName = "cpp_int";
  static constexpr Guarantee kGuarantee = Guarantee::exact;
  static constexpr bool kIntegers = true, kHomogeneous = true;

  static bool accepts(double v) { return std::isfinite(v); }
  static bool accepts_weight(double v) { return std::isfinite(v); }
  static Number from_integer(double v) { return Number(static_cast<std::int64_t>(v)); }
  static Number from_parts(std::int64_t mantissa, int shift) {
    Number r(mantissa);
    r <<= shift;
    return r;
  }
  template <unsigned Bits>
  static Number from_fixed(const FixedInt<Bits>& v) {
    return to_boost(v);
  }
  static Verdict sign(const Number& v) { return v.sign(); }
};

using BoostIntegers = NumberStrategy<BoostIntegerArithmetic>;
static_assert(Strategy<BoostIntegers>);

}  // namespace crossloft::strategies
