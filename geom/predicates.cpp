#include "predicates.h"

#include <array>
#include <bit>

#include "double_filters.h"
#include "exact_rows.h"

namespace crossloft {
namespace {

/// A finite double as mantissa * 2^(exponent - 1075), the mantissa odd or 0.
struct Parts {
  std::uint64_t mantissa = 0;
  int exponent = 0;
  bool negative = false;
};

constexpr std::uint64_t kExponentMask = 0x7FF;

Parts parts_of(double v) {
  const auto bits = std::bit_cast<std::uint64_t>(v);
  const auto biased = static_cast<int>((bits >> 52) & kExponentMask);
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

template <unsigned Bits>
using AlignedRow = ExactRow<Bits + 1, 0>;

template <unsigned Bits>
AlignedRow<Bits> aligned_row(int low, const Vec3& origin, const Vec3& p) {
  const auto d = [&](double to, double from) { return align<Bits>(to, low) - align<Bits>(from, low); };
  return {d(p.x, origin.x), d(p.y, origin.y), d(p.z, origin.z), FixedInt<0>(1)};
}

// The widths: differences in one, two and four limbs, and all finite doubles, which are multiples of 2^-1074
// below 2^1024.
constexpr unsigned kNarrow = 61, kDouble = 124, kQuad = 252, kEverything = 2098;
static_assert(FixedInt<kNarrow + 1>::kLimbs == 1 && FixedInt<kDouble + 1>::kLimbs == 2 &&
              FixedInt<kQuad + 1>::kLimbs == 4);
static_assert(kEverything == 1024 + 1074);

/// evaluate<Bits>(rows relative to the last point) in the narrowest sufficient width; 0 for NaN or infinity.
template <std::size_t N, class Evaluate>
int sign_of(const std::array<Vec3, N>& points, const Evaluate& evaluate) {
  Span span;
  for (const Vec3& p : points) span.include(p.x), span.include(p.y), span.include(p.z);
  if (!span.finite) return 0;
  const auto with = [&]<unsigned Bits>() {
    return evaluate([&](std::size_t i) { return aligned_row<Bits>(span.low, points[N - 1], points[i]); });
  };
  if (span.width() <= static_cast<int>(kNarrow)) return with.template operator()<kNarrow>();
  if (span.width() <= static_cast<int>(kDouble)) return with.template operator()<kDouble>();
  if (span.width() <= static_cast<int>(kQuad)) return with.template operator()<kQuad>();
  return with.template operator()<kEverything>();
}

Vec3 flat(Vec2 p) { return {p.x, p.y, 0}; }

}  // namespace

int orient2d(Vec2 a, Vec2 b, Vec2 c) {
  if (const int sign = orient2d_filter(a, b, c)) return sign;
  // b, c about a; the order of the array puts the origin last.
  return sign_of(std::array{flat(b), flat(c), flat(a)},
                 [](const auto& row) { return orientation_about(row(0), row(1)).sign(); });
}

int orient3d(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  if (const int sign = orient3d_filter(a, b, c, d)) return sign;
  return sign_of(std::array{b, c, d, a}, [](const auto& row) { return det3(row(0), row(1), row(2)).sign(); });
}

int incircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (const int sign = incircle_filter(a, b, c, d)) return sign;
  return sign_of(std::array{flat(a), flat(b), flat(c), flat(d)},
                 [](const auto& row) { return in_circle_about(row(0), row(1), row(2)).sign(); });
}

int insphere(Vec3 a, Vec3 b, Vec3 c, Vec3 d, Vec3 e) {
  if (const int sign = insphere_filter(a, b, c, d, e)) return sign;
  return sign_of(std::array{a, b, c, d, e},
                 [](const auto& row) { return in_sphere_about(row(0), row(1), row(2), row(3)).sign(); });
}

}  // namespace crossloft
