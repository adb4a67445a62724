#pragma once
/// Integers of a fixed width on the stack whose widths are worked out by the types: FixedInt<A> * FixedInt<B>
/// is a FixedInt<A + B>, a sum or difference a FixedInt<max(A, B) + 1>. An expression that compiles cannot
/// overflow, so a determinant's type is the proof of its width; the predicates assert the documented ones.
///
/// FixedInt<Bits> holds |v| <= 2^Bits, the bound included (coordinates are |x| <= 2^50, normals <= 2^40; an
/// inclusive bound is closed under products). Two's complement in 64-bit limbs, least significant first.
///
/// FixedInt<Bits, Cap> never has more than Cap limbs: past that, it is the residue modulo 2^(64 Cap) of the
/// number its type speaks of. Sums and products of residues are right modulo the same, so a determinant known
/// to be smaller than 2^(64 Cap - 1) comes out exact, however large its terms (small_integers.h).

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace crossloft {

namespace limbs {

using Limb = std::uint64_t;

/// Low limb of a b + c + d, the high one into `high`; the sum always fits in two limbs.
inline Limb multiply_add(Limb a, Limb b, Limb c, Limb d, Limb& high) {
#if defined(__SIZEOF_INT128__)
  __extension__ using Double = unsigned __int128;
  const Double t = static_cast<Double>(a) * b + c + d;
  high = static_cast<Limb>(t >> 64);
  return static_cast<Limb>(t);
#else
  const Limb mask = 0xFFFFFFFFu, al = a & mask, ah = a >> 32, bl = b & mask, bh = b >> 32;
  const Limb ll = al * bl, lh = al * bh, hl = ah * bl, mid = (ll >> 32) + (lh & mask) + (hl & mask);
  Limb low = (mid << 32) | (ll & mask);
  high = ah * bh + (lh >> 32) + (hl >> 32) + (mid >> 32);
  low += c, high += low < c;
  low += d, high += low < d;
  return low;
#endif
}

/// a + b + carry, the carry out into `carry` (0 or 1).
inline Limb add(Limb a, Limb b, Limb& carry) {
  const Limb s = a + b, t = s + carry;
  carry = static_cast<Limb>(s < a) | static_cast<Limb>(t < s);
  return t;
}

/// The lower `nr` limbs of the product of two two's complement numbers into `r`; nr <= na + nb, no overlap.
void multiply(Limb* r, std::size_t nr, const Limb* a, std::size_t na, const Limb* b, std::size_t nb);

}  // namespace limbs

inline constexpr std::size_t kNoCap = static_cast<std::size_t>(-1);

template <unsigned Bits, std::size_t Cap = kNoCap>
struct FixedInt {
  static constexpr unsigned kBits = Bits;
  /// One bit for the sign and one because the bound is inclusive.
  static constexpr std::size_t kLimbs = std::min<std::size_t>((Bits + 2 + 63) / 64, Cap);

  std::array<limbs::Limb, kLimbs> limb{};

  FixedInt() = default;
  /// REQUIRES: |v| <= 2^Bits.
  explicit FixedInt(std::int64_t v) {
    limb[0] = static_cast<limbs::Limb>(v);
    for (std::size_t i = 1; i < kLimbs; ++i) limb[i] = v < 0 ? ~limbs::Limb{0} : 0;
  }
  /// From another width. REQUIRES: the value fits, which a wider target ensures.
  template <unsigned From>
  explicit FixedInt(const FixedInt<From, Cap>& v) {
    for (std::size_t i = 0; i < kLimbs; ++i) limb[i] = v.extended(i);
  }

  bool negative() const { return static_cast<std::int64_t>(limb[kLimbs - 1]) < 0; }
  bool is_zero() const {
    limbs::Limb all = 0;
    for (const limbs::Limb l : limb) all |= l;
    return all == 0;
  }
  int sign() const { return negative() ? -1 : is_zero() ? 0 : 1; }
  /// Limb i of the number written with any number of limbs.
  limbs::Limb extended(std::size_t i) const {
    return i < kLimbs ? limb[i] : negative() ? ~limbs::Limb{0} : 0;
  }
  /// REQUIRES: |value| < 2^63.
  std::int64_t to_int64() const { return static_cast<std::int64_t>(limb[0]); }

  friend bool operator==(const FixedInt&, const FixedInt&) = default;
};

#if defined(__SIZEOF_INT128__)
/// Up to two limbs the compiler's own integer is the shortest code; unsigned, since residues wrap around.
namespace limbs {
__extension__ using Native = __int128;
__extension__ using UnsignedNative = unsigned __int128;
template <unsigned Bits, std::size_t Cap>
UnsignedNative to_native(const FixedInt<Bits, Cap>& v) {
  if constexpr (FixedInt<Bits, Cap>::kLimbs == 1) {
    return static_cast<UnsignedNative>(static_cast<Native>(static_cast<std::int64_t>(v.limb[0])));
  } else {
    return static_cast<UnsignedNative>(v.limb[1]) << 64 | v.limb[0];
  }
}
template <class To>
To from_native(UnsignedNative v) {
  To r;
  r.limb[0] = static_cast<Limb>(v);
  if constexpr (To::kLimbs == 2) r.limb[1] = static_cast<Limb>(v >> 64);
  return r;
}
/// One machine multiplication if both factors have one limb.
template <unsigned A, unsigned B, std::size_t Cap>
UnsignedNative native_product(const FixedInt<A, Cap>& a, const FixedInt<B, Cap>& b) {
  if constexpr (FixedInt<A, Cap>::kLimbs == 1 && FixedInt<B, Cap>::kLimbs == 1) {
    return static_cast<UnsignedNative>(static_cast<Native>(static_cast<std::int64_t>(a.limb[0])) *
                                       static_cast<std::int64_t>(b.limb[0]));
  } else {
    return to_native(a) * to_native(b);
  }
}
/// a b for one limb and two: with b = 2^64 h + l, h signed and l not, a h by one signed multiplication and
/// a l by an unsigned one, in which a negative a was too large by 2^64.
template <class Product, class A, class B>
Product one_by_two(const A& a, const B& b) {
  const auto factor = static_cast<std::int64_t>(a.limb[0]);
  const UnsignedNative low = static_cast<UnsignedNative>(a.limb[0]) * b.limb[0];
  UnsignedNative high =
      static_cast<UnsignedNative>(static_cast<Native>(factor) * static_cast<std::int64_t>(b.limb[1]));
  high += static_cast<Limb>(low >> 64);
  high -= factor < 0 ? b.limb[0] : 0;
  Product r;
  r.limb = {static_cast<Limb>(low), static_cast<Limb>(high), static_cast<Limb>(high >> 64)};
  return r;
}
}  // namespace limbs
#endif

template <unsigned A, unsigned B, std::size_t Cap>
auto operator+(const FixedInt<A, Cap>& a, const FixedInt<B, Cap>& b) {
  using Sum = FixedInt<std::max(A, B) + 1, Cap>;
  Sum r;
  if constexpr (Sum::kLimbs == 1) {
    r.limb[0] = a.limb[0] + b.limb[0];
    return r;
  }
#if defined(__SIZEOF_INT128__)
  if constexpr (Sum::kLimbs == 2) return limbs::from_native<Sum>(limbs::to_native(a) + limbs::to_native(b));
#endif
  limbs::Limb carry = 0;
  for (std::size_t i = 0; i < r.kLimbs; ++i) r.limb[i] = limbs::add(a.extended(i), b.extended(i), carry);
  return r;
}

template <unsigned A, unsigned B, std::size_t Cap>
auto operator-(const FixedInt<A, Cap>& a, const FixedInt<B, Cap>& b) {
  using Difference = FixedInt<std::max(A, B) + 1, Cap>;
  Difference r;
  if constexpr (Difference::kLimbs == 1) {
    r.limb[0] = a.limb[0] - b.limb[0];
    return r;
  }
#if defined(__SIZEOF_INT128__)
  if constexpr (Difference::kLimbs == 2)
    return limbs::from_native<Difference>(limbs::to_native(a) - limbs::to_native(b));
#endif
  limbs::Limb carry = 1;
  for (std::size_t i = 0; i < r.kLimbs; ++i) r.limb[i] = limbs::add(a.extended(i), ~b.extended(i), carry);
  return r;
}

template <unsigned A, std::size_t Cap>
FixedInt<A, Cap> operator-(const FixedInt<A, Cap>& a) {
  return FixedInt<A, Cap>(FixedInt<0, Cap>() - a);
}

namespace limbs {
/// The schoolbook product for few limbs, written out by the compiler.
template <class Product, class A, class B>
[[gnu::always_inline]] inline Product short_product(const A& a, const B& b) {
  Product r;
  constexpr std::size_t kA = A::kLimbs, kB = B::kLimbs, kR = Product::kLimbs;
  // Unsigned product; then a two's complement factor was too large by 2^(64 n) if it is negative.
  for (std::size_t i = 0; i < kA; ++i) {
    Limb high = 0;
    for (std::size_t j = 0; j < kB && i + j < kR; ++j)
      r.limb[i + j] = multiply_add(a.limb[i], b.limb[j], r.limb[i + j], high, high);
    if (i + kB < kR) r.limb[i + kB] = high;
  }
  const Limb mask_a = a.negative() ? ~Limb{0} : 0, mask_b = b.negative() ? ~Limb{0} : 0;
  Limb carry_a = 1, carry_b = 1;
  for (std::size_t i = kA; i < kR; ++i) r.limb[i] = add(r.limb[i], ~(b.extended(i - kA) & mask_a), carry_a);
  for (std::size_t i = kB; i < kR; ++i) r.limb[i] = add(r.limb[i], ~(a.extended(i - kB) & mask_b), carry_b);
  return r;
}
}  // namespace limbs

template <unsigned A, unsigned B, std::size_t Cap>
auto operator*(const FixedInt<A, Cap>& a, const FixedInt<B, Cap>& b) {
  using Product = FixedInt<A + B, Cap>;
  constexpr std::size_t kA = FixedInt<A, Cap>::kLimbs, kB = FixedInt<B, Cap>::kLimbs;
  Product r;
  if constexpr (Product::kLimbs == 1) {
    r.limb[0] = a.limb[0] * b.limb[0];
    return r;
  }
#if defined(__SIZEOF_INT128__)
  if constexpr (Product::kLimbs == 2) return limbs::from_native<Product>(limbs::native_product(a, b));
#endif
#if defined(__SIZEOF_INT128__)
  if constexpr (Product::kLimbs == 3 && kA == 1 && kB == 2) return limbs::one_by_two<Product>(a, b);
  if constexpr (Product::kLimbs == 3 && kA == 2 && kB == 1) return limbs::one_by_two<Product>(b, a);
#endif
  if constexpr (kA * kB > 6) {
    limbs::multiply(r.limb.data(), r.kLimbs, a.limb.data(), kA, b.limb.data(), kB);
    return r;
  } else {
    return limbs::short_product<Product>(a, b);
  }
}

}  // namespace crossloft
