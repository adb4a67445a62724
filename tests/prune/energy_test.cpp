// The cheapest solid against all subsets of small cells.
#include "prune/energy.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "brute_solid.h"
#include "cells.h"
#include "prune/confidence.h"

namespace {

using namespace crossloft;
using namespace crossloft::test;

std::size_t count(const Flags& flags) {
  return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), 1));
}

/// The header's formula in plain doubles, in units of length of the shape.
class Energy {
 public:
  explicit Energy(const PlacedCell& cell) : cell_(cell) {
    double sum = 0;
    for (std::uint32_t t = 0; t < cell.complex.mesh.size(); ++t) {
      const auto& v = cell.complex.mesh.vertices[t];
      volume_.push_back(std::fabs(dot(cross(point(v[1]) - point(v[0]), point(v[2]) - point(v[0])),
                                      point(v[3]) - point(v[0]))) /
                        6);
      sum += volume_.back();
    }
    size_ = std::cbrt(sum);
  }

  double area(const Flags& kept) const {
    double sum = 0;
    const TetMesh& mesh = cell_.complex.mesh;
    for (std::uint32_t t = 0; t < kept.size(); ++t)
      for (unsigned i = 0; i < 4; ++i) {
        const std::uint32_t n = mesh.neighbours[t][i];
        const bool ends = n == kNone ? cell_.complex.facets[t][i] != FacetKind::internal : kept[n] == 0;
        if (kept[t] == 0 || !ends) continue;
        const Vec3 a = point(mesh.vertices[t][kFacetSlots[i][0]]),
                   b = point(mesh.vertices[t][kFacetSlots[i][1]]),
                   c = point(mesh.vertices[t][kFacetSlots[i][2]]);
        sum += norm(cross(b - a, c - a)) / 2;
      }
    return sum;
  }

  double of(const Flags& kept, const std::vector<std::int32_t>& confidence,
            const EnergyWeights& weights) const {
    double sum = weights.smooth * area(kept);
    for (std::uint32_t t = 0; t < kept.size(); ++t)
      if (kept[t] != 0)
        sum -= weights.volume * (static_cast<double>(confidence[t]) / kCertain + weights.offset) *
               volume_[t] / size_;
    return sum;
  }

  /// What rounding to integers may change: half a unit a number, the unit being 2^-40 of the squared
  /// diagonal.
  double tolerance() const {
    const double diagonal = 1009 * 1009 * 3;  // no cell is larger
    return diagonal * 0x1p-40 * 20 * static_cast<double>(volume_.size());
  }

 private:
  Vec3 point(std::uint32_t v) const { return cell_.shape.points[v]; }

  const PlacedCell& cell_;
  std::vector<double> volume_;
  double size_ = 0;
};

bool is_tied(const CellComplex& c, std::uint32_t t) {
  const auto& f = c.facets[t];
  const auto& e = c.edges[t];
  return std::find(f.begin(), f.end(), FacetKind::internal) != f.end() ||
         std::find(e.begin(), e.end(), EdgeKind::internal) != e.end();
}

Flags tied(const CellComplex& c, const Flags& r1) {
  Flags flags;
  for (std::uint32_t t = 0; t < r1.size(); ++t) flags.push_back(r1[t] != 0 && is_tied(c, t));
  return flags;
}

std::vector<std::int32_t> random_confidence(std::size_t n, std::mt19937& random) {
  std::vector<std::int32_t> c(n);
  for (std::int32_t& x : c) x = static_cast<std::int32_t>(random() % (2 * kCertain)) - kCertain;
  return c;
}

bool is_subset(const Flags& a, const Flags& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](std::uint8_t x, std::uint8_t y) { return x <= y; });
}

}  // namespace

TEST_CASE("small choices: no subset is cheaper") {
  int compared = 0, some = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const PlacedCell cell = placed_cell(seed);
    // What is free to choose: at most 10 of R1, at random.
    Flags r1 = r1_of(cell.complex);
    std::vector<std::uint32_t> free;
    for (std::uint32_t t = 0; t < r1.size(); ++t)
      if (r1[t] != 0 && !is_tied(cell.complex, t)) free.push_back(t);
    std::shuffle(free.begin(), free.end(), random);
    for (; free.size() > 10; free.pop_back()) r1[free.back()] = 0;
    if (free.size() < 2) continue;
    const Energy energy(cell);
    const auto confidence = random_confidence(r1.size(), random);
    const EnergyWeights weights{1.0, 1.0 + random() % 12, 0.1 * (random() % 8)};
    const Flags found = cheapest_solid(cell.complex, cell.shape, r1, confidence, weights);
    CHECK(is_subset(found, r1));
    CHECK(is_subset(tied(cell.complex, r1), found));
    double best = std::numeric_limits<double>::max(), second = best;
    Flags argmin;
    for (std::uint32_t bits = 0; bits < 1U << free.size(); ++bits) {
      Flags kept = tied(cell.complex, r1);
      for (std::size_t i = 0; i < free.size(); ++i) kept[free[i]] = bits >> i & 1U;
      const double e = energy.of(kept, confidence, weights);
      if (e < best) {
        second = best;
        best = e;
        argmin = kept;
      } else {
        second = std::min(second, e);
      }
    }
    CHECK(energy.of(found, confidence, weights) <= best + energy.tolerance());
    if (second - best > 2 * energy.tolerance()) {
      CHECK(found == argmin);
      ++compared;
    }
    some += count(argmin) > count(tied(cell.complex, r1)) && count(argmin) < count(r1);
  }
  MESSAGE("compared " << compared << ", neither all nor nothing " << some);
  CHECK(compared > 100);
  CHECK(some > 30);
}

TEST_CASE("where nothing has a price or a worth the smallest solid is what stands on the sections") {
  std::size_t more = 0;
  for (std::uint32_t seed = 300; seed < 340; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const PlacedCell cell = placed_cell(seed);
    const Flags r1 = r1_of(cell.complex);
    const auto confidence = random_confidence(r1.size(), random);
    CHECK(cheapest_solid(cell.complex, cell.shape, r1, confidence, {0, 0, 0.5}) == tied(cell.complex, r1));
    more += count(r1) - count(tied(cell.complex, r1));
    // Without price of the surface: exactly what is worth something.
    const Flags worth = cheapest_solid(cell.complex, cell.shape, r1, confidence, {0, 8, 0});
    for (std::uint32_t t = 0; t < r1.size(); ++t)
      CHECK((worth[t] != 0) == (r1[t] != 0 && (is_tied(cell.complex, t) || confidence[t] > 0)));
  }
  CHECK(more > 50);
}

TEST_CASE("a smoother solid has no larger surface, a higher offset no smaller solid") {
  int smaller = 0, larger = 0;
  for (std::uint32_t seed = 400; seed < 500; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const PlacedCell cell = placed_cell(seed);
    const Energy energy(cell);
    const Flags r1 = r1_of(cell.complex);
    const auto confidence = random_confidence(r1.size(), random);
    double last_area = std::numeric_limits<double>::max();
    for (const double smooth : {0.0, 0.5, 1.0, 2.0, 8.0, 1e9}) {
      const Flags kept = cheapest_solid(cell.complex, cell.shape, r1, confidence, {smooth, 8, 0.3});
      // From s A + V <= s A' + V' and t A' + V' <= t A + V: (t - s)(A' - A) <= 0, up to rounding.
      CHECK(energy.area(kept) <= last_area + 8 * energy.tolerance());
      smaller += energy.area(kept) < last_area - 1 && smooth > 0;
      last_area = energy.area(kept);
    }
    Flags last(r1.size(), 0);
    for (const double offset : {-1.0, 0.0, 0.3, 0.6, 1.0}) {
      const Flags kept = cheapest_solid(cell.complex, cell.shape, r1, confidence, {1, 8, offset});
      CHECK(is_subset(last, kept));
      larger += count(kept) > count(last) && offset > -1;
      last = kept;
    }
  }
  CHECK(smaller > 20);
  CHECK(larger > 50);
}

TEST_CASE("the unit of length does not matter, nor the numbers") {
  for (std::uint32_t seed = 500; seed < 540; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const PlacedCell cell = placed_cell(seed);
    const Flags r1 = r1_of(cell.complex);
    const auto confidence = random_confidence(r1.size(), random);
    const Flags kept = cheapest_solid(cell.complex, cell.shape, r1, confidence, {});
    CellShape large = cell.shape;
    for (Vec3& p : large.points) p = 0x1p40 * p;
    for (FacePlane& f : large.faces) f.offset *= 0x1p40;
    CHECK(cheapest_solid(cell.complex, large, r1, confidence, {}) == kept);
    std::vector<std::uint32_t> from;
    const CellComplex other = shuffled(cell.complex, random, from);
    std::vector<std::int32_t> moved;
    for (const std::uint32_t t : from) moved.push_back(confidence[t]);
    const Flags again = cheapest_solid(other, cell.shape, r1_of(other), moved, {});
    for (std::uint32_t t = 0; t < from.size(); ++t) CHECK(again[t] == kept[from[t]]);
  }
}
