#pragma once
/// Finite doubles as integers: multiples of a common power of two, in the narrowest of four widths. For
/// geom's sources only.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "fixed_int.h"

namespace crossloft::aligned {

/// A finite double as mantissa * 2^(exponent - 1075), the mantissa odd or 0.
struct Parts {
  std::uint64_t mantissa = 0;
  int exponent = 0;
  bool negative = false;
};

inline Parts parts_of(double v) {
  const auto bits = std::bit_cast<std::uint64_t>(v);
  const auto biased = static_cast<int>((bits >> 52) & 0x7FF);
  std::uint64_t m = bits & ((std::uint64_t{1} << 52) - 1);
  if (biased != 0) m |= std::uint64_t{1} << 52;
  if (m == 0) return {};
  const int zeros = std::countr_zero(m);
  return {m >> zeros, std::max(biased, 1) + zeros, (bits >> 63) != 0};
}

/// The bits that a set of doubles spans together: every one is an integer below 2^(high - low) times the same
/// power of two.
struct Span {
  int low = 4096, high = 0;
  bool finite = true;

  void include(double v) {
    if (!std::isfinite(v)) finite = false;
    const Parts p = parts_of(v);
    if (p.mantissa == 0) return;
    low = std::min(low, p.exponent);
    high = std::max(high, p.exponent + static_cast<int>(std::bit_width(p.mantissa)));
  }
  int width() const { return high - low; }
};

/// v over 2^(low - 1075). REQUIRES: v within a span of that low end and at most Bits.
template <unsigned Bits>
FixedInt<Bits> align(double v, int low) {
  FixedInt<Bits> r;
  const Parts p = parts_of(v);
  if (p.mantissa == 0) return r;
  const int shift = p.exponent - low;
  const auto at = static_cast<std::size_t>(shift / 64);
  r.limb[at] = p.mantissa << (shift % 64);
  if (shift % 64 != 0 && at + 1 < r.kLimbs) r.limb[at + 1] = p.mantissa >> (64 - shift % 64);
  return p.negative ? -r : r;
}

// The widths: differences in one, two and four limbs, and all finite doubles, which are multiples of 2^-1074
// below 2^1024.
inline constexpr unsigned kNarrow = 61, kDouble = 124, kQuad = 252, kEverything = 2098;
static_assert(FixedInt<kNarrow + 1>::kLimbs == 1 && FixedInt<kDouble + 1>::kLimbs == 2 &&
              FixedInt<kQuad + 1>::kLimbs == 4);
static_assert(kEverything == 1024 + 1074);

/// f.operator()<Bits>() with the narrowest width of at least `bits`. REQUIRES: bits <= kEverything.
template <class F>
int with_width(int bits, const F& f) {
  if (bits <= static_cast<int>(kNarrow)) return f.template operator()<kNarrow>();
  if (bits <= static_cast<int>(kDouble)) return f.template operator()<kDouble>();
  if (bits <= static_cast<int>(kQuad)) return f.template operator()<kQuad>();
  return f.template operator()<kEverything>();
}

}  // namespace crossloft::aligned
