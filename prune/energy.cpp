#include "energy.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "confidence.h"
#include "cut_reduction.h"
#include "star.h"

namespace crossloft {
namespace {

/// Integers a squared diagonal of the cell's box: 2^40, or less where many tetrahedra or large weights would
/// come near kUncuttable. With the diagonal as the unit of length a triangle has sides up to 1, so four of
/// them have an area below 2. A tetrahedron is part of the hull, whose volume is size^3, and the box holds no
/// more than 3^(-3/2): its volume over size is at most size^2 <= 1/3, below 1/2 with the rounding of size. So
///     c = units (2 smooth + volume (1 + |offset|) / 2)
/// bounds every price, and 3 n c < kUncuttable is what min_cut.h asks for.
double units_per_area(std::uint32_t n, const EnergyWeights& weights) {
  const double largest = 2 * weights.smooth + weights.volume * (1 + std::fabs(weights.offset)) / 2;
  double units = 0x1p40;
  while (3.0 * n * units * largest >= static_cast<double>(kUncuttable)) units /= 2;
  return units;
}

std::int64_t rounded(double x) { return static_cast<std::int64_t>(std::floor(x + 0.5)); }

/// Newton's iteration from above: only + * /, so equal everywhere.
double cube_root(double x) {
  if (!(x > 0)) return 0;
  double root = std::max(1.0, x);
  for (double next = root;;) {
    next = (2 * root + x / (root * root)) / 3;
    if (!(next < root)) return root;
    root = next;
  }
}

/// Areas and volumes with the diagonal of the cell's box as the unit of length.
class CellMeasures {
 public:
  CellMeasures(const CellComplex& complex, const CellShape& shape)
      : complex_(complex), points_(shape.points) {
    if (points_.empty()) return;
    Vec3 low = points_[0], high = points_[0];
    for (const Vec3& p : points_) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const double diagonal = norm(high - low);
    per_length_ = diagonal > 0 ? 1 / diagonal : 0;
  }

  /// Of a facet. From sorted vertices: equal from both sides.
  double area(std::uint32_t t, unsigned i) const {
    const auto& slots = complex_.mesh.vertices[t];
    const std::uint32_t a = slots[kFacetSlots[i][0]], b = slots[kFacetSlots[i][1]],
                        c = slots[kFacetSlots[i][2]];
    const std::uint32_t low = std::min(std::min(a, b), c), high = std::max(std::max(a, b), c),
                        mid = a ^ b ^ c ^ low ^ high;
    const Vec3 p = points_[low];
    return norm(cross(per_length_ * (points_[mid] - p), per_length_ * (points_[high] - p))) / 2;
  }

  double volume(std::uint32_t t) const {
    const auto v = sorted_vertices(complex_.mesh, t);
    const Vec3 p = points_[v[0]];
    const Vec3 a = per_length_ * (points_[v[1]] - p), b = per_length_ * (points_[v[2]] - p),
               c = per_length_ * (points_[v[3]] - p);
    return std::fabs(dot(cross(a, b), c)) / 6;
  }

 private:
  const CellComplex& complex_;
  const std::vector<Vec3>& points_;
  double per_length_ = 0;
};

std::vector<double> volumes(const CellComplex& complex, const CellMeasures& measures) {
  std::vector<double> volume(complex.mesh.size());
  for (std::uint32_t t = 0; t < complex.mesh.size(); ++t) volume[t] = measures.volume(t);
  return volume;
}

/// Cube root of the sum, added up as integers: the same in any order.
double size_of(const std::vector<double>& volumes) {
  std::int64_t sum = 0;
  for (const double v : volumes) sum += rounded(v * 0x1p60);
  return cube_root(static_cast<double>(sum) * 0x1p-60);
}

/// The cut between tetrahedra of R1 that are not tied. Tied ones are the source: what a facet to them costs
/// is added to the price of dropping the tetrahedron.
class CutBuilder {
 public:
  CutBuilder(const CellComplex& complex, const CellShape& shape, const std::vector<std::uint8_t>& r1,
             const ConfidenceSource& confidence, const EnergyWeights& weights)
      : complex_(complex),
        measures_(complex, shape),
        confidence_(confidence),
        weights_(weights),
        units_(units_per_area(complex.mesh.size(), weights)),
        place_(complex.mesh.size(), kDropped) {
    for (std::uint32_t t = 0; t < r1.size(); ++t) {
      if (r1[t] == 0) continue;
      place_[t] = is_tied_to_sections(complex, t) ? kTied : static_cast<std::uint32_t>(open_.size());
      if (place_[t] != kTied) open_.push_back(t);
    }
  }

  std::vector<std::uint8_t> run(CancelFlag cancel) {
    const std::vector<double> volume = volumes(complex_, measures_);
    const double size = size_of(volume);
    const double per_volume = size > 0 ? weights_.volume * units_ / size : 0;
    neighbours_.assign(open_.size(), {kNone, kNone, kNone, kNone});
    std::vector<std::int64_t> facets(open_.size());
    problem_.capacity.assign(open_.size(), {0, 0, 0, 0});
    for (std::uint32_t k = 0; k < open_.size(); ++k) facets[k] = set_facets(k);
    problem_.neighbours = neighbours_;
    problem_.cancel = cancel;
    // Rounding never turns the order of two prices round.
    const auto price = [&](std::uint32_t k, std::int32_t confidence) {
      const double sureness = static_cast<double>(confidence) / kCertain + weights_.offset;
      return rounded(per_volume * volume[open_[k]] * sureness) + facets[k];
    };
    const std::vector<std::uint8_t> kept_open =
        smallest_cheapest(problem_, [&](std::uint32_t k, unsigned step) {
          const ConfidenceBounds in = bounds(open_[k], step);
          return PriceRange{price(k, in.low), price(k, in.high)};
        });
    std::vector<std::uint8_t> kept(place_.size());
    for (std::uint32_t t = 0; t < kept.size(); ++t)
      kept[t] = place_[t] == kTied || (place_[t] != kDropped && kept_open[place_[t]] != 0) ? 1 : 0;
    return kept;
  }

 private:
  ConfidenceBounds bounds(std::uint32_t t, unsigned step) const {
    if (step == 0) return {};
    if (step == 1) return confidence_.bounds(t);
    const std::int32_t exactly = confidence_.measure(t);
    return {exactly, exactly};
  }

  static constexpr std::uint32_t kDropped = kNone, kTied = kNone - 1;

  /// Capacities towards neighbours; returns the price of facets to tied ones less that of facets where the
  /// solid must end.
  std::int64_t set_facets(std::uint32_t k) {
    const std::uint32_t t = open_[k];
    std::int64_t gain = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t other = complex_.mesh.neighbours[t][i];
      const std::uint32_t place = other == kNone ? kDropped : place_[other];
      if (place == kDropped) {
        gain -= price(t, i);
      } else if (place == kTied) {
        gain += price(t, i);
      } else {
        neighbours_[k][i] = place;
        if (place < k) continue;
        problem_.capacity[k][i] = price(t, i);
        problem_.capacity[place][facet_towards(complex_.mesh, other, t)] = problem_.capacity[k][i];
      }
    }
    return gain;
  }

  std::int64_t price(std::uint32_t t, unsigned i) const {
    return rounded(units_ * weights_.smooth * measures_.area(t, i));
  }

  const CellComplex& complex_;
  const CellMeasures measures_;
  const ConfidenceSource& confidence_;
  const EnergyWeights& weights_;
  const double units_;
  std::vector<std::uint32_t> place_;                      ///< in open_, or one of the two above
  std::vector<std::uint32_t> open_;                       ///< what the cut decides
  std::vector<std::array<std::uint32_t, 4>> neighbours_;  ///< by place
  CutProblem problem_;
};

}  // namespace

bool is_tied_to_sections(const CellComplex& complex, std::uint32_t t) {
  return stands_on_section(complex, t) || has_inner_edge(complex, t);
}

std::vector<std::uint8_t> cheapest_solid(const CellComplex& complex, const CellShape& shape,
                                         const std::vector<std::uint8_t>& r1,
                                         const ConfidenceSource& confidence, const EnergyWeights& weights,
                                         CancelFlag cancel) {
  return CutBuilder(complex, shape, r1, confidence, weights).run(cancel);
}

std::vector<std::uint8_t> cheapest_solid(const CellComplex& complex, const CellShape& shape,
                                         const std::vector<std::uint8_t>& r1,
                                         std::span<const std::int32_t> confidence,
                                         const EnergyWeights& weights) {
  return cheapest_solid(complex, shape, r1,
                        {[&](std::uint32_t t) {
                           return ConfidenceBounds{confidence[t], confidence[t]};
                         },
                         [&](std::uint32_t t) { return confidence[t]; }},
                        weights);
}

}  // namespace crossloft
