#pragma once
/// Strategy: numbers of two doubles, some 106 bits, with a running error bound (geom/double_double.h, where it is
/// derived). A filter; it decides zeros too as long as everything fits into two doubles.

#include <cmath>

#include "../double_double.h"
#include "lattice_pieces.h"
#include "number_range.h"
#include "number_strategy.h"

namespace crossloft::strategies {

struct DoubleDoubleArithmetic {
  using Number = DoubleDouble;
  static constexpr std::string_view kName = "double-double";
  static constexpr Guarantee kGuarantee = Guarantee::filter;
  static constexpr bool kIntegers = false, kHomogeneous = true;

  static bool accepts(double v) { return std::fabs(v) <= range::kLargest; }
  static bool accepts_weight(double v) { return std::fabs(v) <= range::kLargestWeight; }
  static DoubleDouble from_integer(double v) { return v; }
  static DoubleDouble from_double(double v) { return v; }
  template <unsigned Bits>
  static DoubleDouble from_fixed(const FixedInt<Bits>& v) {
    return sum_of_pieces<DoubleDouble>(v);
  }
  static Verdict sign(const DoubleDouble& v) { return v.is_certain() ? v.sign() : kUnknown; }
};

using DoubleDoubleStrategy = NumberStrategy<DoubleDoubleArithmetic>;
static_assert(Strategy<DoubleDoubleStrategy>);

}  // namespace crossloft::strategies
