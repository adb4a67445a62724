#pragma once
/// Strategy: GMP's integers (mpz) on aligned doubles and homogeneous coordinates. Exact.

#include <gmpxx.h>

#include "gmp_number.h"
#include "number_strategy.h"

namespace crossloft::strategies {

/// The limbs as they are, the sign apart.
template <unsigned Bits>
mpz_class to_mpz(const FixedInt<Bits>& v) {
  const FixedInt<Bits> size = v.negative() ? -v : v;
  mpz_class r;
  mpz_import(r.get_mpz_t(), size.kLimbs, -1, sizeof(limbs::Limb), 0, 0, size.limb.data());
  if (v.negative()) mpz_neg(r.get_mpz_t(), r.get_mpz_t());
  return r;
}

struct GmpIntegerArithmetic {
  using Number = Gmp<mpz_class>;
  static constexpr std::string_view kName = "mpz";
  static constexpr Guarantee kGuarantee = Guarantee::exact;
  static constexpr bool kIntegers = true, kHomogeneous = true;

  static bool accepts(double v) { return std::isfinite(v); }
  static bool accepts_weight(double v) { return std::isfinite(v); }
  static Number from_integer(double v) { return {mpz_class(v)}; }
  static Number from_parts(std::int64_t mantissa, int shift) {
    Number r{mpz_class(static_cast<double>(mantissa))};
    if (shift > 0) mpz_mul_2exp(r.value.get_mpz_t(), r.value.get_mpz_t(), static_cast<mp_bitcnt_t>(shift));
    return r;
  }
  template <unsigned Bits>
  static Number from_fixed(const FixedInt<Bits>& v) {
    return {to_mpz(v)};
  }
  static Verdict sign(const Number& v) { return mpz_sgn(v.value.get_mpz_t()); }
};

using GmpIntegers = NumberStrategy<GmpIntegerArithmetic>;
static_assert(Strategy<GmpIntegers>);

}  // namespace crossloft::strategies
