#include "../../geom/fixed_int.h"

#include <doctest/doctest.h>

#include "../../geom/fixed_division.h"
#include "rational_reference.h"

using namespace crossloft;
using reference::integer;

namespace {

constexpr std::uint64_t kSeed = 20260404;

/// Random, or one of the values at which carries and signs go wrong.
template <unsigned Bits>
FixedInt<Bits> value(std::mt19937_64& engine) {
  FixedInt<Bits> one(1), r;
  const FixedInt<Bits> limit = shift_left(one, static_cast<int>(Bits));
  switch (engine() % 8) {
    case 0:
      return r;
    case 1:
      return one;
    case 2:
      return -one;
    case 3:
      return limit;
    case 4:
      return -limit;
    default:
      break;
  }
  for (limbs::Limb& l : r.limb) l = engine() % 4 == 0 ? ~limbs::Limb{0} : engine();
  r = shift_right(magnitude(r), static_cast<int>(64 * r.kLimbs - Bits));
  return engine() % 2 == 0 ? r : -r;
}

template <unsigned A, unsigned B>
void check_ring(std::mt19937_64& engine) {
  for (int round = 0; round < 300; ++round) {
    const auto a = value<A>(engine);
    const auto b = value<B>(engine);
    const mpz_class x = integer(a), y = integer(b);
    CHECK(integer(a + b) == x + y);
    CHECK(integer(a - b) == x - y);
    CHECK(integer(a * b) == x * y);
    CHECK(integer(-a) == -x);
    CHECK(a.sign() == sgn(x));
    CHECK((a - b).sign() == cmp(x, y) / (cmp(x, y) == 0 ? 1 : std::abs(cmp(x, y))));
    CHECK(to_double(a) == doctest::Approx(x.get_d()));
  }
}

/// The residue modulo 2^(64 limbs) next to 0, which is what a capped number's limbs mean.
mpz_class residue(const mpz_class& v, std::size_t limbs) {
  const mpz_class modulus = mpz_class(1) << (64 * limbs), half = modulus / 2;
  mpz_class r;
  mpz_fdiv_r(r.get_mpz_t(), mpz_class(v + half).get_mpz_t(), modulus.get_mpz_t());
  return r - half;
}

template <unsigned Bits, std::size_t Cap>
mpz_class integer_of(const FixedInt<Bits, Cap>& v) {
  mpz_class r = 0;
  for (std::size_t i = v.kLimbs; i-- > 0;) r = (r << 64) + mpz_class(std::to_string(v.limb[i]));
  return residue(r, v.kLimbs);
}

/// a b c + a b - c with at most Cap limbs.
template <unsigned A, unsigned B, unsigned C, std::size_t Cap>
void check_residues(std::mt19937_64& engine) {
  const auto capped = [](const auto& v) {
    FixedInt<std::decay_t<decltype(v)>::kBits, Cap> r;
    for (std::size_t i = 0; i < r.kLimbs; ++i) r.limb[i] = v.limb[i];
    return r;
  };
  for (int round = 0; round < 300; ++round) {
    const auto a = value<A>(engine);
    const auto b = value<B>(engine);
    const auto c = value<C>(engine);
    const mpz_class x = integer(a), y = integer(b), z = integer(c);
    const auto product = capped(a) * capped(b);
    static_assert(decltype(product)::kLimbs <= Cap);
    CHECK(integer_of(product * capped(c)) == residue(x * y * z, Cap));
    CHECK(integer_of(product * capped(c) + product) == residue(x * y * z + x * y, Cap));
    CHECK(integer_of(-(product * capped(c)) - capped(c)) == residue(-x * y * z - z, Cap));
  }
}

}  // namespace

TEST_CASE("with a cap, residues agree with GMP") {
  std::mt19937_64 engine(kSeed + 2);
  check_residues<52, 52, 52, 1>(engine);
  check_residues<62, 40, 50, 2>(engine);
  check_residues<126, 62, 62, 2>(engine);
  check_residues<62, 126, 62, 3>(engine);
  check_residues<126, 126, 62, 3>(engine);
  check_residues<187, 62, 126, 4>(engine);
  check_residues<126, 187, 62, 5>(engine);
  check_residues<300, 300, 300, 6>(engine);
}

TEST_CASE("sums and products agree with GMP at every number of limbs") {
  MESSAGE("seed " << kSeed);
  std::mt19937_64 engine(kSeed);
  check_ring<0, 0>(engine);
  check_ring<40, 50>(engine);
  check_ring<62, 62>(engine);
  check_ring<63, 51>(engine);
  check_ring<126, 62>(engine);
  check_ring<103, 51>(engine);
  check_ring<126, 126>(engine);
  check_ring<172, 122>(engine);
  check_ring<173, 0>(engine);
  check_ring<521, 348>(engine);
  check_ring<900, 60>(engine);
}

TEST_CASE("division, greatest common divisor and rounding") {
  std::mt19937_64 engine(kSeed + 1);
  using Int = FixedInt<176>;
  for (int round = 0; round < 1000; ++round) {
    const Int n = magnitude(value<176>(engine));
    Int d = magnitude(value<122>(engine).is_zero() ? Int(3) : Int(value<122>(engine)));
    if (d.is_zero()) d = Int(7);
    const mpz_class x = integer(n), y = integer(d);
    const auto [quotient, remainder] = divide(n, d);
    CHECK(integer(quotient) == x / y);
    CHECK(integer(remainder) == x % y);
    CHECK(integer(gcd(n, d)) == gcd(x, y));
    // Nearest: no neighbour is closer.
    const double q = round_quotient(n, d);
    const mpq_class error = abs(mpq_class(mpq_class(q) - mpq_class(x) / mpq_class(y)));
    for (const double other : {std::nextafter(q, 1e300), std::nextafter(q, -1e300)})
      CHECK(error <= abs(mpq_class(mpq_class(other) - mpq_class(x) / mpq_class(y))));
    CHECK(round_quotient(-n, d) == -q);
  }
}

namespace {

/// Divisors of every length, quotients of every length and, with n = m d + r, the last unit of each.
template <unsigned Bits>
void check_division(std::mt19937_64& engine) {
  using Int = FixedInt<Bits>;
  const auto length = [&] { return static_cast<int>(engine() % (Bits / 2 + 1)); };
  for (int round = 0; round < 2000; ++round) {
    const Int d(shift_right(magnitude(value<Bits>(engine)), length()) + Int(1));
    const Int m = shift_right(magnitude(value<Bits>(engine)), bit_length(d));
    const auto check = [&](const Int& n) {
      const auto [quotient, remainder] = divide(n, d);
      CHECK(integer(quotient) == integer(n) / integer(d));
      CHECK(integer(remainder) == integer(n) % integer(d));
      CHECK(integer(gcd(n, d)) == gcd(integer(n), integer(d)));
    };
    const Int multiple(m * d);
    check(multiple);
    check(Int(multiple + Int(1)));
    if (!multiple.is_zero()) check(Int(multiple - Int(1)));
  }
}

}  // namespace

TEST_CASE("division at the borders of a quotient, in one to four limbs") {
  MESSAGE("seed " << kSeed + 2);
  std::mt19937_64 engine(kSeed + 2);
  check_division<60>(engine);
  check_division<122>(engine);
  check_division<176>(engine);
  check_division<240>(engine);
}

TEST_CASE("halves round to even") {
  const FixedInt<100> odd(std::int64_t{(1LL << 53) + 1});
  CHECK(to_double(odd) == 0x1p53);
  CHECK(to_double(odd + FixedInt<100>(2)) == 0x1p53 + 4);
  CHECK(round_quotient(odd, FixedInt<100>(2)) == 0x1p52);
  CHECK(round_quotient(odd, FixedInt<100>(4)) == 0x1p51);
}
