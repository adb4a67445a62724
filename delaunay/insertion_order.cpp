#include "insertion_order.h"

#include <algorithm>
#include <bit>
#include <cstddef>

namespace crossloft {
namespace {

constexpr unsigned kBits = 16;  ///< of the curve per axis; 3 axes and the round fit into 64 bits
constexpr unsigned kLastRound = 15;

/// The finaliser of splitmix64.
std::uint64_t scramble(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15u;
  x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9u;
  x = (x ^ x >> 27) * 0x94D049BB133111EBu;
  return x ^ x >> 31;
}

/// Round 0 comes last and holds 7/8 of the points.
unsigned round_of(std::size_t index) {
  return std::min(static_cast<unsigned>(std::countr_zero(scramble(index))) / 3, kLastRound);
}

/// Position along the Hilbert curve of a cell of the grid of 2^kBits cells an axis.
template <std::size_t N>
std::uint64_t curve_position(std::array<std::uint32_t, N> x) {
  for (std::uint32_t bit = 1u << (kBits - 1); bit > 1; bit >>= 1) {
    const std::uint32_t low = bit - 1;
    for (std::size_t k = 0; k < N; ++k) {
      // Reflect or swap the lower bits, as the sub-cube's copy of the curve is turned.
      const std::uint32_t swap = (x[k] & bit) ? 0 : (x[0] ^ x[k]) & low;
      x[0] ^= (x[k] & bit) ? low : swap;
      x[k] ^= swap;
    }
  }
  for (std::size_t k = 1; k < N; ++k) x[k] ^= x[k - 1];
  std::uint32_t flip = 0;
  for (std::uint32_t bit = 1u << (kBits - 1); bit > 1; bit >>= 1)
    if (x[N - 1] & bit) flip ^= bit - 1;
  std::uint64_t position = 0;
  for (unsigned b = kBits; b-- > 0;)
    for (std::size_t k = 0; k < N; ++k) position = position << 1 | ((x[k] ^ flip) >> b & 1);
  return position;
}

/// Maps the bounding box to the curve's grid, the same scale on all axes. Halves avoid overflow.
template <std::size_t N>
struct Grid {
  explicit Grid(std::span<const std::array<double, N>> points) {
    std::array<double, N> high{};
    for (std::size_t k = 0; k < N; ++k) low[k] = high[k] = points[0][k] / 2;
    for (const auto& p : points)
      for (std::size_t k = 0; k < N; ++k) {
        low[k] = std::min(low[k], p[k] / 2);
        high[k] = std::max(high[k], p[k] / 2);
      }
    for (std::size_t k = 0; k < N; ++k) extent = std::max(extent, high[k] - low[k]);
  }
  std::array<std::uint32_t, N> cell(const std::array<double, N>& p) const {
    std::array<std::uint32_t, N> c{};
    if (extent > 0)
      for (std::size_t k = 0; k < N; ++k)
        c[k] = static_cast<std::uint32_t>((p[k] / 2 - low[k]) / extent * ((1u << kBits) - 1));
    return c;
  }

  std::array<double, N> low{};
  double extent = 0;
};

template <std::size_t N>
std::vector<std::uint32_t> order(std::span<const std::array<double, N>> points) {
  struct Entry {
    std::uint64_t key;
    std::uint32_t index;
  };
  std::vector<std::uint32_t> result(points.size());
  if (points.empty()) return result;
  const Grid<N> grid(points);
  std::vector<Entry> entries(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const unsigned round = round_of(i);
    std::uint64_t position = curve_position(grid.cell(points[i]));
    if (round % 2) position ^= (std::uint64_t{1} << (N * kBits)) - 1;
    entries[i] = {std::uint64_t{kLastRound - round} << 60 | position, static_cast<std::uint32_t>(i)};
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.key != b.key ? a.key < b.key : a.index < b.index;
  });
  for (std::size_t i = 0; i < entries.size(); ++i) result[i] = entries[i].index;
  return result;
}

}  // namespace

std::vector<std::uint32_t> insertion_order(std::span<const std::array<double, 2>> points) {
  return order(points);
}
std::vector<std::uint32_t> insertion_order(std::span<const std::array<double, 3>> points) {
  return order(points);
}

}  // namespace crossloft
