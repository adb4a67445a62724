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

/// Differences to the last of Count + 1 points in units of a power of two, all |d| <= 2^bits.
template <std::size_t Count, std::size_t Dimension>
struct Differences {
  std::array<std::array<std::int64_t, Dimension>, Count> rows;
  int bits;
};

template <std::size_t N, std::size_t Dimension>
using Points = std::array<std::array<double, Dimension>, N>;

inline std::uint64_t bits_of(double v) { return std::bit_cast<std::uint64_t>(v); }

/// Has its highest bit at position b for the least b with -2^b <= v < 2^b; for |v| < 2^62. Shifts of signed
/// words are no vector operation on every machine, these are.
inline std::uint64_t extent(std::int64_t v) {
  const auto u = static_cast<std::uint64_t>(v);
  return u ^ (u << 1);
}
inline int bits_of_extent(std::uint64_t extent) { return static_cast<int>(std::bit_width(extent)) - 1; }

/// Integers -2^51 <= x < 2^51 as they are, by adding 1.5 * 2^52: the last bits of the sum are x, if and only
/// if the sum has the exponent of 2^52 and is exact. No branch and no conversion, so that it vectorises.
template <std::size_t N, std::size_t Dimension>
bool integer_differences(const Points<N, Dimension>& points, Differences<N - 1, Dimension>& d) {
  constexpr double kShifter = 0x1.8p52;
  std::array<std::array<std::uint64_t, Dimension>, N> shifted;
  std::uint64_t inexact = 0, exponents = 0, extents = 1;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t k = 0; k < Dimension; ++k) {
      const double v = points[i][k], sum = v + kShifter;
      shifted[i][k] = bits_of(sum);
      inexact |= bits_of(sum - kShifter) ^ bits_of(v);
      exponents |= shifted[i][k] ^ bits_of(kShifter);
    }
  for (std::size_t i = 0; i + 1 < N; ++i)
    for (std::size_t k = 0; k < Dimension; ++k) {
      d.rows[i][k] = static_cast<std::int64_t>(shifted[i][k] - shifted[N - 1][k]);
      extents |= extent(d.rows[i][k]);
    }
  d.bits = bits_of_extent(extents);
  return (inexact << 1) == 0 && (exponents >> 52) == 0;  // the sign bit alone: a negative zero
}

/// The largest |coordinate|, four at a time; NaN is passed over.
template <std::size_t N, std::size_t Dimension>
double largest_coordinate(const Points<N, Dimension>& points) {
  std::array<double, (N * Dimension + 3) / 4 * 4> all{};
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t k = 0; k < Dimension; ++k) all[i * Dimension + k] = std::fabs(points[i][k]);
  std::array<double, 4> largest{};
  for (std::size_t i = 0; i < all.size(); i += 4)
    for (std::size_t k = 0; k < 4; ++k) largest[k] = largest[k] < all[i + k] ? all[i + k] : largest[k];
  return std::max(std::max(largest[0], largest[1]), std::max(largest[2], largest[3]));
}

/// Coordinates as integers |c| < 2^61, x = c times a power of two; common factors of two are removed from the
/// differences. False if a coordinate is NaN or has bits below that unit, or if the largest is outside
/// 2^-39..2^140: with a unit of 2^-99 or more and differences below 2^142 the filters on doubles
/// (double_filters.h) then were in range, or a column is zero.
template <std::size_t N, std::size_t Dimension>
bool scaled_differences(const Points<N, Dimension>& points, Differences<N - 1, Dimension>& d) {
  const double largest = largest_coordinate(points);
  if (!(largest >= 0x1p-39 && largest <= 0x1p140)) return false;
  const std::uint64_t exponent = bits_of(largest) >> 52;  // biased: largest < 2^(exponent - 1022)
  const double scale = std::bit_cast<double>((2045 + kCoordinateBits - exponent) << 52);
  const double unit = std::bit_cast<double>((exponent + 1 - kCoordinateBits) << 52);
  std::array<std::array<std::int64_t, Dimension>, N> integers;
  std::uint64_t inexact = 0, all = 0, extents = 1;
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t k = 0; k < Dimension; ++k) {
      const double v = points[i][k] * scale;
      integers[i][k] = static_cast<std::int64_t>(v < 0x1p61 ? v : 0x1p61);  // NaN, too, becomes a number
      inexact |= bits_of(static_cast<double>(integers[i][k]) * unit) ^ bits_of(points[i][k]);
    }
  if (inexact << 1 != 0) return false;
  for (std::size_t i = 0; i + 1 < N; ++i)
    for (std::size_t k = 0; k < Dimension; ++k) {
      d.rows[i][k] = integers[i][k] - integers[N - 1][k];
      all |= static_cast<std::uint64_t>(d.rows[i][k]);
      extents |= extent(d.rows[i][k]);
    }
  const int shift = all == 0 ? 0 : std::countr_zero(all);
  for (auto& row : d.rows)
    for (std::int64_t& v : row) v >>= shift;
  d.bits = std::max(0, bits_of_extent(extents) - shift);
  return true;
}

template <std::size_t N, std::size_t Dimension>
bool to_differences(const Points<N, Dimension>& points, Differences<N - 1, Dimension>& d) {
  return integer_differences(points, d) || scaled_differences(points, d);
}

template <unsigned Bits, std::size_t Limbs>
ExactRow<Bits, 0, Limbs> row(const std::array<std::int64_t, 3>& d) {
  using Entry = FixedInt<Bits, Limbs>;
  return {Entry(d[0]), Entry(d[1]), Entry(d[2]), FixedInt<0, Limbs>(1)};
}
template <unsigned Bits, std::size_t Limbs>
ExactRow<Bits, 0, Limbs> row(const std::array<std::int64_t, 2>& d) {
  using Entry = FixedInt<Bits, Limbs>;
  return {Entry(d[0]), Entry(d[1]), Entry(0), FixedInt<0, Limbs>(1)};
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

/// The sign of Shape::determinant(rows) after the failed filter of that shape, in the fewest limbs. A shape
/// names its degree, kDegree, and what the filter has left: kError, and kExactError if differences were exact
/// doubles.
template <class Shape, std::size_t Limbs = 1, std::size_t Count, std::size_t Dimension>
int residue_sign(const Differences<Count, Dimension>& d) {
  constexpr unsigned kDouble = 53;
  constexpr unsigned exact = max_bits(Shape::kExactError, Shape::kDegree, Limbs);
  constexpr unsigned bits =
      exact <= kDouble ? exact : std::max(kDouble, max_bits(Shape::kError, Shape::kDegree, Limbs));
  if constexpr (bits <= kCoordinateBits)
    if (d.bits > static_cast<int>(bits)) return residue_sign<Shape, Limbs + 1>(d);
  const auto evaluate = [&]<std::size_t... I>(std::index_sequence<I...>) {
    return Shape::determinant(row<bits, Limbs>(d.rows[I])...).sign();
  };
  return evaluate(std::make_index_sequence<Count>());
}

}  // namespace crossloft::small_integers
