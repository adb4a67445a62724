#pragma once
/// Hilbert curves in the plane and in space by tables.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace crossloft::detail {

/// The curve through the grid of 2^bits cells an axis, digit by digit from the top: in each sub-cube the curve is
/// turned in one of N 2^N ways, known by the corner it enters at and the axis it leaves along. The table says
/// which place along the curve each of the 2^N halves has, and the way it is turned there. Source: Hamilton,
/// Compact Hilbert indices (2006), the steps of his algorithm 2.
template <std::size_t N>
class HilbertCurve {
 public:
  /// The place of a cell along the curve. REQUIRES: N bits <= 64, coordinates below 2^bits.
  static std::uint64_t position(const std::array<std::uint32_t, N>& cell, unsigned bits) {
    std::uint64_t position = 0;
    unsigned way = 0;
    for (unsigned bit = bits; bit-- > 0;) {
      unsigned corner = 0;
      for (std::size_t k = 0; k < N; ++k) corner |= (cell[k] >> bit & 1u) << k;
      const Step step = kSteps[way << N | corner];
      position = position << N | step.place;
      way = step.way;
    }
    return position;
  }

 private:
  struct Step {
    std::uint8_t place, way;
  };
  static constexpr unsigned kCorners = 1u << N, kMask = kCorners - 1;

  static constexpr unsigned rotated(unsigned corner, unsigned by) {
    return ((corner << by % N) | (corner >> (N - by % N))) & kMask;
  }
  static constexpr unsigned gray(unsigned place) { return place ^ place >> 1; }
  static constexpr unsigned place_of(unsigned gray_code) {
    unsigned place = 0;
    for (; gray_code != 0; gray_code >>= 1) place ^= gray_code;
    return place;
  }
  /// Corner where the curve enters the sub-cube of a place, and the axis along which it passes through.
  static constexpr unsigned entry(unsigned place) { return place == 0 ? 0 : gray((place - 1) & ~1u); }
  static constexpr unsigned direction(unsigned place) {
    if (place == 0) return 0;
    return static_cast<unsigned>(std::countr_one(place % 2 == 0 ? place - 1 : place)) % N;
  }
  static constexpr Step step(unsigned way, unsigned corner) {
    const unsigned enters = way / N, axis = way % N;
    const unsigned place = place_of(rotated(corner ^ enters, 2 * N - axis - 1));
    const unsigned next_enters = enters ^ rotated(entry(place), axis + 1);
    const unsigned next_axis = (axis + direction(place) + 1) % N;
    return {static_cast<std::uint8_t>(place), static_cast<std::uint8_t>(next_enters * N + next_axis)};
  }
  static constexpr auto kSteps = [] {
    std::array<Step, N * kCorners * kCorners> steps{};
    for (unsigned way = 0; way < N * kCorners; ++way)
      for (unsigned corner = 0; corner < kCorners; ++corner) steps[way << N | corner] = step(way, corner);
    return steps;
  }();
};

}  // namespace crossloft::detail
