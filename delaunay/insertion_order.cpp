#include "insertion_order.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>

#include "hilbert_curve.h"
#include "in_parallel.h"
#include "large_pages.h"

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

double coordinate(const std::array<double, 2>& p, std::size_t axis) { return p[axis]; }
double coordinate(const std::array<double, 3>& p, std::size_t axis) { return p[axis]; }
double coordinate(const Vec3& p, std::size_t axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/// Maps the bounding box to the curve's grid, the same scale on all axes. Halves avoid overflow.
template <std::size_t N>
class Grid {
 public:
  template <class Point>
  explicit Grid(std::span<const Point> points) {
    std::array<double, N> high{};
    for (std::size_t k = 0; k < N; ++k) low_[k] = high[k] = coordinate(points[0], k) / 2;
    for (const Point& p : points)
      for (std::size_t k = 0; k < N; ++k) {
        low_[k] = std::min(low_[k], coordinate(p, k) / 2);
        high[k] = std::max(high[k], coordinate(p, k) / 2);
      }
    for (std::size_t k = 0; k < N; ++k) extent_ = std::max(extent_, high[k] - low_[k]);
  }
  template <class Point>
  std::array<std::uint32_t, N> cell(const Point& p) const {
    std::array<std::uint32_t, N> c{};
    if (extent_ > 0)
      for (std::size_t k = 0; k < N; ++k)
        c[k] = static_cast<std::uint32_t>((coordinate(p, k) / 2 - low_[k]) / extent_ * ((1u << kBits) - 1));
    return c;
  }

 private:
  std::array<double, N> low_{};
  double extent_ = 0;
};

struct Entry {
  std::uint64_t key;
  std::uint32_t index;
};

/// Sorts by key, entries of equal keys as they are: least digits first, skipping digits that all share. Each
/// thread moves a slice of the entries to the places that the slices before leave it.
void sort_by_key(std::vector<Entry>& entries, unsigned threads) {
  constexpr unsigned kDigit = 11, kDigits = (64 + kDigit - 1) / kDigit, kValues = 1u << kDigit;
  std::vector<std::array<std::uint32_t, kValues>> places(threads);
  std::vector<Entry> sorted;
  detail::resize_in_large_pages(sorted, entries.size(), threads);
  for (unsigned d = 0; d < kDigits; ++d) {
    const auto digit = [d](const Entry& e) { return e.key >> d * kDigit & (kValues - 1); };
    detail::in_slices(threads, entries.size(), [&](std::size_t begin, std::size_t end, unsigned k) {
      places[k].fill(0);
      for (std::size_t i = begin; i < end; ++i) ++places[k][digit(entries[i])];
    });
    std::uint32_t of_first = 0, before = 0;
    for (const auto& place : places) of_first += place[digit(entries[0])];
    if (of_first == entries.size()) continue;
    for (unsigned value = 0; value < kValues; ++value)
      for (auto& place : places) before += std::exchange(place[value], before);
    detail::in_slices(threads, entries.size(), [&](std::size_t begin, std::size_t end, unsigned k) {
      for (std::size_t i = begin; i < end; ++i) sorted[places[k][digit(entries[i])]++] = entries[i];
    });
    entries.swap(sorted);
  }
}

void sort_entries(std::vector<Entry>& entries, unsigned threads) {
  constexpr std::size_t kFew = 2000;  // below, clearing the counts costs more
  if (entries.size() > kFew) return sort_by_key(entries, threads);
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.key != b.key ? a.key < b.key : a.index < b.index;
  });
}

template <std::size_t N, class Point>
std::vector<std::uint32_t> order(std::span<const Point> points, unsigned threads = 1) {
  std::vector<std::uint32_t> result;
  if (points.empty()) return result;
  const Grid<N> grid(points);
  std::vector<Entry> entries;
  detail::resize_in_large_pages(entries, points.size(), threads);
  detail::in_slices(threads, points.size(), [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) {
      const unsigned round = round_of(i);
      std::uint64_t position = detail::HilbertCurve<N>::position(grid.cell(points[i]), kBits);
      if (round % 2) position ^= (std::uint64_t{1} << (N * kBits)) - 1;
      entries[i] = {std::uint64_t{kLastRound - round} << (N * kBits) | position,
                    static_cast<std::uint32_t>(i)};
    }
  });
  sort_entries(entries, threads);
  detail::resize_in_large_pages(result, points.size());
  for (std::size_t i = 0; i < entries.size(); ++i) result[i] = entries[i].index;
  return result;
}

}  // namespace

std::vector<std::uint32_t> insertion_order(std::span<const std::array<double, 2>> points) {
  return order<2>(points);
}
std::vector<std::uint32_t> insertion_order(std::span<const std::array<double, 3>> points) {
  return order<3>(points);
}
std::vector<std::uint32_t> insertion_order(std::span<const Vec3> points, unsigned threads) {
  return order<3>(points, detail::useful_threads(threads, points.size()));
}

}  // namespace crossloft
