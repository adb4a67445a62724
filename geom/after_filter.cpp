// The stages behind the filters on doubles: small integers over a common power of two, then integers of the
// narrowest of four widths that holds the span of the coordinates.

#include <array>

#include "aligned_doubles.h"
#include "double_filters.h"
#include "exact_rows.h"
#include "small_integers.h"

namespace crossloft {
namespace {

using namespace filters;

// What a failed filter leaves of each determinant (small_integers.h): its constant, and again that of the
// evaluation, which is smaller when differences are exact; lifts are at most 2 or 3 squares.

struct Orient2d {
  static constexpr unsigned kDegree = 2;
  static constexpr double kError = 2 * kRoundedOrient2dError;
  static constexpr double kExactError = kRoundedOrient2dError + kOrient2dError;
  static auto determinant(const auto& p, const auto& q) { return orientation_about(p, q); }
};

struct Orient3d {
  static constexpr unsigned kDegree = 3;
  static constexpr double kError = 2 * kRoundedOrient3dError;
  static constexpr double kExactError = kRoundedOrient3dError + kOrient3dError;
  static auto determinant(const auto& p, const auto& q, const auto& r) { return det3(p, q, r); }
};

struct InCircle {
  static constexpr unsigned kDegree = 4;
  static constexpr double kError = 2 * 2 * kRoundedIncircleError;
  static constexpr double kExactError = 2 * (kRoundedIncircleError + kIncircleError);
  static auto determinant(const auto& p, const auto& q, const auto& r) { return in_circle_about(p, q, r); }
};

struct InSphere {
  static constexpr unsigned kDegree = 5;
  static constexpr double kError = 3 * 2 * kRoundedInsphereError;
  static constexpr double kExactError = 3 * (kRoundedInsphereError + kInsphereError);
  static auto determinant(const auto& p, const auto& q, const auto& r, const auto& s) {
    return in_sphere_about(p, q, r, s);
  }
};

/// Coordinates relative to an origin, as integers over 2^(low - 1075).
template <unsigned Bits>
ExactRow<Bits + 1, 0> aligned_row(int low, const Vec3& p, const Vec3& origin) {
  const auto d = [&](double to, double from) {
    return aligned::align<Bits>(to, low) - aligned::align<Bits>(from, low);
  };
  return {d(p.x, origin.x), d(p.y, origin.y), d(p.z, origin.z), FixedInt<0>(1)};
}

/// In the narrowest sufficient width; 0 for NaN or infinity.
template <class Shape, class... Points>
int aligned_sign(const Vec3& origin, const Points&... points) {
  aligned::Span span;
  const auto include = [&](const Vec3& p) { span.include(p.x), span.include(p.y), span.include(p.z); };
  include(origin);
  (include(points), ...);
  if (!span.finite) return 0;
  return aligned::with_width(span.width(), [&]<unsigned Bits>() {
    return Shape::determinant(aligned_row<Bits>(span.low, points, origin)...).sign();
  });
}

/// Out of the way of what is more frequent.
template <class Shape, class... Points>
[[gnu::noinline]] int sign_of_doubles(const Vec3& origin, const Points&... points) {
  small_integers::Differences<sizeof...(Points)> d;
  if (small_integers::scaled_differences(d, origin, points...)) return small_integers::residue_sign<Shape>(d);
  return aligned_sign<Shape>(origin, points...);
}

template <class Shape, class... Points>
int sign_after_filter(const Vec3& origin, const Points&... points) {
  small_integers::Differences<sizeof...(Points)> d;
  if (small_integers::integer_differences(d, origin, points...))
    return small_integers::residue_sign<Shape>(d);
  return sign_of_doubles<Shape>(origin, points...);
}

Vec3 flat(Vec2 p) { return {p.x, p.y, 0}; }

}  // namespace

int orient2d_after_filter(Vec2 a, Vec2 b, Vec2 c) {
  return sign_after_filter<Orient2d>(flat(a), flat(b), flat(c));
}

int orient3d_after_filter(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return sign_after_filter<Orient3d>(a, b, c, d);
}

int incircle_after_filter(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return sign_after_filter<InCircle>(flat(d), flat(a), flat(b), flat(c));
}

int insphere_after_filter(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  return sign_after_filter<InSphere>(e, a, b, c, d);
}

}  // namespace crossloft
