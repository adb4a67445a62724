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

struct Entry {
  std::uint64_t key;
  std::uint32_t index;
};

/// Maps the bounding box of the points of some entries to the curve's grid, the same scale on all axes.
/// Halves avoid overflow. Unless all are in one place, two of them come into different cells: the ends of the
/// longest axis.
template <std::size_t N>
class Grid {
 public:
  /// REQUIRES: some entries.
  template <class Point>
  Grid(std::span<const Point> points, const std::vector<Entry>& entries) {
    std::array<double, N> high{};
    for (std::size_t k = 0; k < N; ++k) low_[k] = high[k] = coordinate(points[entries[0].index], k) / 2;
    for (const Entry& e : entries)
      for (std::size_t k = 0; k < N; ++k) {
        low_[k] = std::min(low_[k], coordinate(points[e.index], k) / 2);
        high[k] = std::max(high[k], coordinate(points[e.index], k) / 2);
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

/// By round, those of a round along the curve through the box of them all.
template <std::size_t N, class Point>
void sort_along_curve(std::span<const Point> points, std::vector<Entry>& entries, unsigned threads) {
  const Grid<N> grid(points, entries);
  detail::in_slices(threads, entries.size(), [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t i = begin; i < end; ++i) {
      Entry& e = entries[i];
      const unsigned round = round_of(e.index);
      std::uint64_t position = detail::HilbertCurve<N>::position(grid.cell(points[e.index]), kBits);
      if (round % 2) position ^= (std::uint64_t{1} << (N * kBits)) - 1;
      e.key = std::uint64_t{kLastRound - round} << (N * kBits) | position;
    }
  });
  sort_entries(entries, threads);
}

struct Run {
  std::size_t begin, end;
};

/// Adds the runs of many equal keys, points of one round in one cell, among sorted entries. A run of all that
/// were sorted is none: they are in one place.
void note_crowds(const std::vector<Entry>& entries, Run among, std::vector<Run>& crowds) {
  constexpr std::size_t kMany = 8;
  for (std::size_t begin = among.begin, end = begin; begin < among.end; begin = end) {
    while (end < among.end && entries[end].key == entries[begin].key) ++end;
    const std::size_t size = end - begin;
    if (size > kMany && size < among.end - among.begin) crowds.push_back({begin, end});
  }
}

/// One point far away puts all others into one cell, where they would come in the order of their indices, and
/// each search would cross them all. So the points of a crowded cell are sorted again along a curve through
/// their own box, until no cell is crowded; the boxes shrink to a 2^16th, hence a point is sorted some 130
/// times at most.
template <std::size_t N, class Point>
void sort_crowds(std::span<const Point> points, std::vector<Entry>& entries, unsigned threads) {
  std::vector<Run> crowds;
  std::vector<Entry> part;
  note_crowds(entries, {0, entries.size()}, crowds);
  while (!crowds.empty()) {
    const Run run = crowds.back();
    crowds.pop_back();
    const auto at = entries.begin() + static_cast<std::ptrdiff_t>(run.begin);
    part.assign(at, entries.begin() + static_cast<std::ptrdiff_t>(run.end));
    sort_along_curve<N>(points, part, detail::useful_threads(threads, part.size()));
    std::copy(part.begin(), part.end(), at);
    note_crowds(entries, run, crowds);
  }
}

template <std::size_t N, class Point>
std::vector<std::uint32_t> order(std::span<const Point> points, unsigned threads = 1) {
  std::vector<std::uint32_t> result;
  if (points.empty()) return result;
  std::vector<Entry> entries;
  detail::resize_in_large_pages(entries, points.size(), threads);
  for (std::size_t i = 0; i < entries.size(); ++i) entries[i].index = static_cast<std::uint32_t>(i);
  sort_along_curve<N>(points, entries, threads);
  sort_crowds<N>(points, entries, threads);
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
