#pragma once
/// A point or direction with double coordinates, in input units.

#include <algorithm>
#include <cmath>

namespace crossloft {

struct Vec3 {
  double x = 0, y = 0, z = 0;
  friend constexpr auto operator<=>(const Vec3&, const Vec3&) = default;
  friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
};

constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Times 2^-exponent, which brings the largest coordinate to [0.5, 1): products of coordinates neither
/// overflow nor vanish. REQUIRES: finite.
inline Vec3 to_unit_size(Vec3 a, int& exponent) {
  std::frexp(std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)}), &exponent);
  return {std::ldexp(a.x, -exponent), std::ldexp(a.y, -exponent), std::ldexp(a.z, -exponent)};
}

/// norm() of vectors whose squares leave the range of doubles.
inline double scaled_norm(Vec3 a) {
  const double largest = std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)});
  if (largest == 0 || !std::isfinite(largest)) return largest;
  int exponent = 0;
  const Vec3 scaled = to_unit_size(a, exponent);
  return std::ldexp(std::sqrt(dot(scaled, scaled)), exponent);
}

/// Euclidean length, whatever the squares are; sqrt is correctly rounded everywhere, hence deterministic.
inline double norm(Vec3 a) {
  const double square = dot(a, a);  // a summand that underflows is too small to count from 2^-900 on
  return square >= 0x1p-900 && square <= 0x1p1000 ? std::sqrt(square) : scaled_norm(a);
}
inline bool is_finite(Vec3 a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

}  // namespace crossloft
