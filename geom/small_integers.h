#pragma once
/// The second stage of the predicates: differences of coordinates as integers of one limb, and determinants
/// of them in as few limbs as the failed filter allows. For geom's sources only.
///
/// A filter that cannot tell has still measured: its estimate is within `bound` of 0 and within `bound` of
/// the true determinant, which therefore is at most 2 bound, some 2^-43 of what the terms of an in-sphere may
/// reach. That many leading bits are known to be zero, and the determinant is computed modulo 2^64, 2^128,
/// ... only (FixedInt<Bits, Cap>): residues with an approximation decide, after H. Broennimann, I. Emiris, V.
/// Pan and S. Pion, Sign determination in residue number systems, 1999, with a power of two as the modulus.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "difference_filters.h"
#include "exact_rows.h"

namespace crossloft::small_integers {

// The determinants: their degree, and the formula on integer rows relative to a point.

struct Orient2d {
  static constexpr unsigned kDegree = 2;
  static auto determinant(const auto& p, const auto& q) { return orientation_about(p, q); }
};
struct Orient3d {
  static constexpr unsigned kDegree = 3;
  static auto determinant(const auto& p, const auto& q, const auto& r) { return det3(p, q, r); }
};
struct InCircle {
  static constexpr unsigned kDegree = 4;
  static auto determinant(const auto& p, const auto& q, const auto& r) { return in_circle_about(p, q, r); }
};
struct InSphere {
  static constexpr unsigned kDegree = 5;
  static auto determinant(const auto& p, const auto& q, const auto& r, const auto& s) {
    return in_sphere_about(p, q, r, s);
  }
};

struct IntegerRow {
  std::int64_t x, y, z;
};

template <unsigned Bits, std::size_t Cap>
ExactRow<Bits, 0, Cap> exact_row(const IntegerRow& d) {
  using Entry = FixedInt<Bits, Cap>;
  return {Entry(d.x), Entry(d.y), Entry(d.z), FixedInt<0, Cap>(1)};
}

constexpr double power(double base, unsigned exponent) {
  double r = 1;
  for (unsigned i = 0; i < exponent; ++i) r *= base;
  return r;
}

/// The sign of Shape::determinant(rows), of which |value| <= limit is known, in the fewest limbs that hold
/// `limit`. REQUIRES: |entries| <= 2^Bits. The limit's own rounding is far below the room left to 2^63.
template <class Shape, unsigned Bits, std::size_t Limbs = 1, class... Rows>
int residue_sign(double limit, const Rows&... rows) {
  using Full = decltype(Shape::determinant(exact_row<Bits, kNoCap>(rows)...));
  if constexpr (Limbs < Full::kLimbs)
    if (!(limit <= 0x1.fp62 * power(0x1p64, Limbs - 1)))
      return residue_sign<Shape, Bits, Limbs + 1>(limit, rows...);
  return Shape::determinant(exact_row<Bits, Limbs>(rows)...).sign();
}

/// Differences below this are exact in doubles between integers, and fit a limb with room.
inline constexpr unsigned kDifferenceBits = 52;
inline constexpr double kLargestDifference = 0x1p52;

/// Of differences that are integers |d| <= 2^52 over 1 / scale, a power of two.
template <class Shape, class... Rows>
int difference_sign(double bound, double scale, const Rows&... rows) {
  const auto integers = [scale](const Vec3& d) -> IntegerRow {
    return {static_cast<std::int64_t>(d.x * scale), static_cast<std::int64_t>(d.y * scale),
            static_cast<std::int64_t>(d.z * scale)};
  };
  return residue_sign<Shape, kDifferenceBits>(2 * bound * power(scale, Shape::kDegree), integers(rows)...);
}

/// The same of integers as they are; inlined, which saves the scaling.
template <class Shape, class... Rows>
[[gnu::always_inline]] inline int integer_sign(double bound, const Rows&... rows) {
  const auto integers = [](const Vec3& d) -> IntegerRow {
    return {static_cast<std::int64_t>(d.x), static_cast<std::int64_t>(d.y), static_cast<std::int64_t>(d.z)};
  };
  return residue_sign<Shape, kDifferenceBits>(2 * bound, integers(rows)...);
}

/// Adds up the distances of coordinates to integers: 0 for integers, NaN for NaN and infinity. A size below
/// 2^52 and kShifter add up to 2^52..2^53, where doubles are the integers. Beyond, all doubles are integers
/// and the sum may round, which finds some distance or none.
inline double distance_to_integer(double v) {
  constexpr double kShifter = 0x1p52;
  const double size = std::fabs(v);
  return std::fabs((size + kShifter) - kShifter - size);
}
inline double distance_to_integers(const Vec3& p) {
  return distance_to_integer(p.x) + distance_to_integer(p.y) + distance_to_integer(p.z);
}

/// The most bits of scaled coordinates: their differences then fit FixedInt<62>, one limb.
inline constexpr int kCoordinateBits = 61;

/// Integers |c| < 2^61 with x = c times a power of two, given the largest coordinate.
class ScaledReader {
 public:
  explicit ScaledReader(double largest) {
    const std::uint64_t exponent = std::bit_cast<std::uint64_t>(largest) >> 52;  // largest < 2^(it - 1022)
    scale_ = std::bit_cast<double>((2045 + kCoordinateBits - exponent) << 52);
    unit_ = std::bit_cast<double>((exponent + 1 - kCoordinateBits) << 52);
  }
  /// Whether a reader can be made, and the fifth power of its scale: no less than the filters' own range
  /// admits, as long as the coordinates are not far larger than their differences.
  static bool in_range(double largest) { return largest >= 0x1p-101 && largest <= 0x1p200; }

  /// REQUIRES: no coordinate larger than was said.
  [[gnu::always_inline]] IntegerRow read(const Vec3& p) {
    const auto integer = [this](double v) { return static_cast<std::int64_t>(v * scale_); };
    const IntegerRow c{integer(p.x), integer(p.y), integer(p.z)};
    const auto distance = [this](std::int64_t i, double v) {
      return std::fabs(static_cast<double>(i) * unit_ - v);
    };
    distance_ += distance(c.x, p.x) + distance(c.y, p.y) + distance(c.z, p.z);
    return c;
  }
  /// All that was read were multiples of the unit.
  bool exact() const { return distance_ == 0; }
  double scale() const { return scale_; }

 private:
  double scale_, unit_;
  double distance_ = 0;  ///< between the numbers read and the multiples of the unit
};

inline IntegerRow operator-(const IntegerRow& a, const IntegerRow& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline IntegerRow operator>>(const IntegerRow& a, int shift) {
  return {a.x >> shift, a.y >> shift, a.z >> shift};
}
inline std::uint64_t all_bits(const IntegerRow& d) { return static_cast<std::uint64_t>(d.x | d.y | d.z); }

/// Sign of the determinant of points relative to an origin into `sign`, if all coordinates are integers of 61
/// bits over a common power of two. REQUIRES: coordinates finite; |determinant| <= 2 bound, in their units.
template <class Shape, class... Points>
bool scaled_sign(double bound, int& sign, const Vec3& origin, const Points&... points) {
  double largest = filters::largest(origin.x, origin.y, origin.z);
  ((largest = std::max(filters::largest(points.x, points.y, points.z), largest)), ...);
  if (!ScaledReader::in_range(largest)) return false;
  ScaledReader reader(largest);
  const IntegerRow from = reader.read(origin);
  const auto evaluate = [&](const auto&... rows) {
    if (!reader.exact()) return false;
    const int shift = std::min(std::countr_zero((all_bits(rows) | ...)), kCoordinateBits);
    // Zeros at the end of all differences divide the determinant.
    const double scale =
        reader.scale() * std::bit_cast<double>(static_cast<std::uint64_t>(1023 - shift) << 52);
    const double limit = 2 * bound * power(scale, Shape::kDegree);
    sign = residue_sign<Shape, kCoordinateBits + 1>(limit, (rows >> shift)...);
    return true;
  };
  return evaluate((reader.read(points) - from)...);
}

}  // namespace crossloft::small_integers
