#pragma once
/// Strategy: GMP's rationals (mpq), doubles and coordinates as they are, every result in lowest terms. Exact.

#include <gmpxx.h>

#include "gmp_integers.h"

namespace crossloft::strategies {

struct GmpRationalArithmetic {
  using Number = Gmp<mpq_class>;
  static constexpr std::string_view kName = "mpq";
  static constexpr Guarantee kGuarantee = Guarantee::exact;
  static constexpr bool kIntegers = false, kHomogeneous = false;

  static bool accepts(double v) { return std::isfinite(v); }
  static bool accepts_weight(double v) { return std::isfinite(v); }
  static Number from_integer(double v) { return {mpq_class(v)}; }
  static Number from_double(double v) { return {mpq_class(v)}; }
  static Number coordinate(const LatticePoint& p, int axis) {
    if (p.is_explicit()) return {mpq_class(p[axis])};
    Number r{mpq_class(to_mpz(numerator(*p.exact, axis)), to_mpz(p.exact->w))};
    r.value.canonicalize();
    return r;
  }
  static Verdict sign(const Number& v) { return mpq_sgn(v.value.get_mpq_t()); }
};

using GmpRationals = NumberStrategy<GmpRationalArithmetic>;
static_assert(Strategy<GmpRationals>);

}  // namespace crossloft::strategies
