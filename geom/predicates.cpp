#include "predicates.h"

#include <array>

#include "aligned_doubles.h"
#include "double_filters.h"
#include "exact_rows.h"

namespace crossloft {
namespace {

template <unsigned Bits>
using AlignedRow = ExactRow<Bits + 1, 0>;

template <unsigned Bits>
AlignedRow<Bits> aligned_row(int low, const Vec3& origin, const Vec3& p) {
  const auto d = [&](double to, double from) {
    return aligned::align<Bits>(to, low) - aligned::align<Bits>(from, low);
  };
  return {d(p.x, origin.x), d(p.y, origin.y), d(p.z, origin.z), FixedInt<0>(1)};
}

/// evaluate<Bits>(rows relative to the last point) in the narrowest sufficient width; 0 for NaN or infinity.
template <std::size_t N, class Evaluate>
int sign_of(const std::array<Vec3, N>& points, const Evaluate& evaluate) {
  aligned::Span span;
  for (const Vec3& p : points) span.include(p.x), span.include(p.y), span.include(p.z);
  if (!span.finite) return 0;
  const auto with = [&]<unsigned Bits>() {
    return evaluate([&](std::size_t i) { return aligned_row<Bits>(span.low, points[N - 1], points[i]); });
  };
  return aligned::with_width(span.width(), with);
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
