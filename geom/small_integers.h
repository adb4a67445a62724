#pragma once
/// The second stage of the predicates: coordinates that are integers of at most 61 bits over a common power
/// of two, and determinants of their differences in as few limbs as the failed filter allows. For geom's
/// sources only.
///
/// A filter that cannot tell has still measured: with det its estimate, |det| <= e size and |det - D| <= e'
/// size for the true D, so |D| <= (e + e') size, some 2^-43 of what the terms of an in-sphere may reach. That
/// many leading bits are known to be zero, and D is computed modulo 2^64, 2^128, ... only
/// (FixedInt<Bits, Cap>): residues with an approximation decide, after Broennimann, Emiris, Pan and Pion,
/// Sign determination in residue number systems, 1999, with a power of two as the modulus. `max_bits` turns
/// the constants into the widths of the differences for which a number of limbs suffices.

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "difference_filters.h"
#include "exact_rows.h"

namespace crossloft::small_integers {

/// The most bits of coordinates: their differences then fit FixedInt<62>, one limb.
inline constexpr int kCoordinateBits = 61;

struct IntegerRow {
  std::int64_t x, y, z;
};

/// Differences to the last of Count + 1 points in units of a power of two, all |d| <= 2^bits.
template <std::size_t Count>
struct Differences {
  std::array<IntegerRow, Count> rows;
  int bits;
};

inline std::uint64_t bits_of(double v) { return std::bit_cast<std::uint64_t>(v); }

/// The width of words v with |v| < 2^62, by their exclusive or with their doubles: its highest bit is at
/// position b for the least b with -2^b <= v < 2^b.
struct Extent {
  std::uint64_t all = 1;

  static std::uint64_t of(std::int64_t v) {
    const auto u = static_cast<std::uint64_t>(v);
    return u ^ (u << 1);
  }
  void include(const IntegerRow& r) { all |= of(r.x) | of(r.y) | of(r.z); }
  int bits() const { return static_cast<int>(std::bit_width(all)) - 1; }
};

/// Integers -2^51 <= x < 2^51 by adding 1.5 * 2^52: the last bits of the sum are x if and only if the sum has
/// the exponent of 2^52 and is exact. No branch and no conversion, so that it vectorises.
class IntegerReader {
 public:
  /// Rows whose differences are those of the points.
  IntegerRow read(const Vec3& p) { return {read(p.x), read(p.y), read(p.z)}; }
  /// All that was read was in range. The sign bit alone is a negative zero.
  bool exact() const { return (inexact_ << 1) == 0 && (exponents_ >> 52) == 0; }

 private:
  std::int64_t read(double v) {
    constexpr double kShifter = 0x1.8p52;
    const double sum = v + kShifter;
    inexact_ |= bits_of(sum - kShifter) ^ bits_of(v);
    exponents_ |= bits_of(sum) ^ bits_of(kShifter);
    return static_cast<std::int64_t>(bits_of(sum));
  }
  std::uint64_t inexact_ = 0, exponents_ = 0;
};

inline IntegerRow operator-(const IntegerRow& a, const IntegerRow& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline IntegerRow operator>>(const IntegerRow& a, int shift) {
  return {a.x >> shift, a.y >> shift, a.z >> shift};
}

/// Differences of points with integer coordinates, -2^51 <= x < 2^51; false if they are not.
template <class... Points>
bool integer_differences(Differences<sizeof...(Points)>& d, const Vec3& origin, const Points&... points) {
  IntegerReader reader;
  const IntegerRow from = reader.read(origin);
  d.rows = {(reader.read(points) - from)...};
  if (!reader.exact()) return false;
  Extent extent;
  for (const IntegerRow& row : d.rows) extent.include(row);
  d.bits = extent.bits();
  return true;
}

inline double largest_coordinate(const Vec3& p) { return filters::largest(p.x, p.y, p.z); }

/// Integers |c| < 2^61 with x = c times a power of two, given the largest coordinate.
class ScaledReader {
 public:
  explicit ScaledReader(double largest) {
    const std::uint64_t exponent = bits_of(largest) >> 52;  // biased: largest < 2^(exponent - 1022)
    scale_ = std::bit_cast<double>((2045 + kCoordinateBits - exponent) << 52);
    unit_ = std::bit_cast<double>((exponent + 1 - kCoordinateBits) << 52);
  }
  IntegerRow read(const Vec3& p) { return {read(p.x), read(p.y), read(p.z)}; }
  /// All that was read were multiples of the unit; the sign bit alone is a negative zero.
  bool exact() const { return (inexact_ << 1) == 0; }

 private:
  std::int64_t read(double v) {
    const double scaled = v * scale_;
    const auto c = static_cast<std::int64_t>(scaled < 0x1p61 ? scaled : 0x1p61);  // NaN becomes a number
    inexact_ |= bits_of(static_cast<double>(c) * unit_) ^ bits_of(v);
    return c;
  }
  double scale_, unit_;
  std::uint64_t inexact_ = 0;
};

/// Differences of coordinates that are integers of 61 bits over a common power of two, common factors of two
/// removed. False if a coordinate is NaN or has bits below that unit, or if the largest is outside
/// 2^-39..2^140: with a unit of 2^-99 or more and differences below 2^142 the filters on doubles
/// (double_filters.h) then were in range, or a column is zero.
template <class... Points>
bool scaled_differences(Differences<sizeof...(Points)>& d, const Vec3& origin, const Points&... points) {
  double largest = largest_coordinate(origin);  // maxima pass over NaN
  ((largest = std::max(largest_coordinate(points), largest)), ...);
  if (!(largest >= 0x1p-39 && largest <= 0x1p140)) return false;
  ScaledReader reader(largest);
  const IntegerRow from = reader.read(origin);
  d.rows = {(reader.read(points) - from)...};
  if (!reader.exact()) return false;
  std::int64_t all = 0;
  Extent extent;
  for (const IntegerRow& row : d.rows) all |= row.x | row.y | row.z, extent.include(row);
  const int shift = all == 0 ? 0 : std::countr_zero(static_cast<std::uint64_t>(all));
  for (IntegerRow& row : d.rows) row = row >> shift;
  d.bits = std::max(0, extent.bits() - shift);
  return true;
}

template <unsigned Bits, std::size_t Limbs>
ExactRow<Bits, 0, Limbs> exact_row(const IntegerRow& d) {
  using Entry = FixedInt<Bits, Limbs>;
  return {Entry(d.x), Entry(d.y), Entry(d.z), FixedInt<0, Limbs>(1)};
}

/// The largest b with error 2^(degree b) < 2^(64 limbs - 1), for `error` the part of the product of the
/// column maxima and of the largest lift, in units of the longest difference, that a failed filter leaves.
constexpr unsigned max_bits(double error, unsigned degree, std::size_t limbs) {
  double room = 0x1p63 / (error * filters::kRoom);
  for (std::size_t i = 1; i < limbs; ++i) room *= 0x1p64;
  unsigned bits = 0;
  for (double next = room; bits < kCoordinateBits + 1; ++bits) {
    for (unsigned i = 0; i < degree; ++i) next *= 0.5;
    if (!(next > 1)) break;
  }
  return bits;
}

/// What a failed filter of `Shape` leaves allows differences of so many bits in `Limbs` limbs. A shape names
/// its degree, kDegree, and that error: kError, and kExactError if differences were exact doubles.
template <class Shape>
constexpr unsigned residue_bits(std::size_t limbs) {
  constexpr unsigned kDouble = 53;
  const unsigned exact = max_bits(Shape::kExactError, Shape::kDegree, limbs);
  return exact <= kDouble ? exact : std::max(kDouble, max_bits(Shape::kError, Shape::kDegree, limbs));
}

/// The sign of Shape::determinant(rows) after the failed filter of that shape, in the fewest limbs.
template <class Shape, std::size_t Limbs = 1, std::size_t Count>
int residue_sign(const Differences<Count>& d) {
  constexpr unsigned bits = residue_bits<Shape>(Limbs);
  if constexpr (bits <= kCoordinateBits)
    if (d.bits > static_cast<int>(bits)) return residue_sign<Shape, Limbs + 1>(d);
  const auto evaluate = [&]<std::size_t... I>(std::index_sequence<I...>) {
    return Shape::determinant(exact_row<bits, Limbs>(d.rows[I])...).sign();
  };
  return evaluate(std::make_index_sequence<Count>());
}

}  // namespace crossloft::small_integers
