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
using small_integers::Points;

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

/// A row of coordinates relative to an origin, as integers over 2^(low - 1075).
template <unsigned Bits>
ExactRow<Bits + 1, 0> aligned_row(int low, const std::array<double, 3>& p,
                                  const std::array<double, 3>& origin) {
  const auto d = [&](std::size_t k) {
    return aligned::align<Bits>(p[k], low) - aligned::align<Bits>(origin[k], low);
  };
  return {d(0), d(1), d(2), FixedInt<0>(1)};
}
template <unsigned Bits>
ExactRow<Bits + 1, 0> aligned_row(int low, const std::array<double, 2>& p,
                                  const std::array<double, 2>& origin) {
  return aligned_row<Bits>(low, {p[0], p[1], 0}, {origin[0], origin[1], 0});
}

/// The sign of the determinant on rows relative to the last point, in the narrowest sufficient width; 0 for
/// NaN or infinity.
template <class Shape, std::size_t N, std::size_t Dimension>
int aligned_sign(const Points<N, Dimension>& points) {
  aligned::Span span;
  for (const auto& p : points)
    for (const double v : p) span.include(v);
  if (!span.finite) return 0;
  return aligned::with_width(span.width(), [&]<unsigned Bits>() {
    const auto evaluate = [&]<std::size_t... I>(std::index_sequence<I...>) {
      return Shape::determinant(aligned_row<Bits>(span.low, points[I], points[N - 1])...).sign();
    };
    return evaluate(std::make_index_sequence<N - 1>());
  });
}

template <class Shape, std::size_t N, std::size_t Dimension>
int sign_after_filter(const Points<N, Dimension>& points) {
  small_integers::Differences<N - 1, Dimension> differences;
  if (small_integers::to_differences(points, differences))
    return small_integers::residue_sign<Shape>(differences);
  return aligned_sign<Shape>(points);
}

std::array<double, 2> coordinates(Vec2 v) { return {v.x, v.y}; }
std::array<double, 3> coordinates(const Vec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

// The origin goes last: for orientations that is an even exchange of rows, b, c (, d) about a.

int orient2d_after_filter(Vec2 a, Vec2 b, Vec2 c) {
  return sign_after_filter<Orient2d>(std::array{coordinates(b), coordinates(c), coordinates(a)});
}

int orient3d_after_filter(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return sign_after_filter<Orient3d>(
      std::array{coordinates(b), coordinates(c), coordinates(d), coordinates(a)});
}

int incircle_after_filter(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return sign_after_filter<InCircle>(
      std::array{coordinates(a), coordinates(b), coordinates(c), coordinates(d)});
}

int insphere_after_filter(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  return sign_after_filter<InSphere>(
      std::array{coordinates(a), coordinates(b), coordinates(c), coordinates(d), coordinates(e)});
}

}  // namespace crossloft
