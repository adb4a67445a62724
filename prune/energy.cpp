#include "energy.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "confidence.h"
#include "min_cut.h"
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
    std::array<std::uint32_t, 3> v;
    for (unsigned k = 0; k < 3; ++k) v[k] = complex_.mesh.vertices[t][kFacetSlots[i][k]];
    std::sort(v.begin(), v.end());
    const Vec3 p = points_[v[0]];
    return norm(cross(per_length_ * (points_[v[1]] - p), per_length_ * (points_[v[2]] - p))) / 2;
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

/// Tetrahedra that stand on the sections, and those around the edges within them: without these a section
/// falls apart where the solid is on one side of it here and on the other side there.
bool is_tied(const CellComplex& complex, std::uint32_t t) {
  return stands_on_section(complex, t) || has_inner_edge(complex, t);
}

class CutBuilder {
 public:
  CutBuilder(const CellComplex& complex, const CellShape& shape, const std::vector<std::uint8_t>& r1,
             std::span<const std::int32_t> confidence, const EnergyWeights& weights)
      : complex_(complex),
        measures_(complex, shape),
        r1_(r1),
        confidence_(confidence),
        weights_(weights),
        units_(units_per_area(complex.mesh.size(), weights)) {
    const std::uint32_t n = complex.mesh.size();
    problem_.neighbours = complex.mesh.neighbours;
    problem_.capacity.assign(n, {0, 0, 0, 0});
    problem_.terminal.assign(n, -1);  // what can't be kept
  }

  CutProblem run() {
    const std::vector<double> volume = volumes(complex_, measures_);
    const double size = size_of(volume);
    const double per_volume = size > 0 ? weights_.volume * units_ / size : 0;
    for (std::uint32_t t = 0; t < r1_.size(); ++t) {
      if (r1_[t] == 0) continue;
      const double sureness = static_cast<double>(confidence_[t]) / kCertain + weights_.offset;
      const std::int64_t pull = rounded(per_volume * volume[t] * sureness) - set_facets(t);
      problem_.terminal[t] = is_tied(complex_, t) ? kUncuttable : pull;
    }
    return std::move(problem_);
  }

 private:
  /// Capacities towards neighbours; returns the price of the facets where the solid must end.
  std::int64_t set_facets(std::uint32_t t) {
    std::int64_t ends = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t other = complex_.mesh.neighbours[t][i];
      if (complex_.facets[t][i] == FacetKind::internal) continue;
      if (other == kNone || r1_[other] == 0) {
        ends += price(t, i);
      } else if (other > t) {
        problem_.capacity[t][i] = price(t, i);
        problem_.capacity[other][facet_towards(complex_.mesh, other, t)] = problem_.capacity[t][i];
      }
    }
    return ends;
  }

  std::int64_t price(std::uint32_t t, unsigned i) const {
    return rounded(units_ * weights_.smooth * measures_.area(t, i));
  }

  const CellComplex& complex_;
  const CellMeasures measures_;
  const std::vector<std::uint8_t>& r1_;
  std::span<const std::int32_t> confidence_;
  const EnergyWeights& weights_;
  const double units_;
  CutProblem problem_;
};

}  // namespace

std::vector<std::uint8_t> cheapest_solid(const CellComplex& complex, const CellShape& shape,
                                         const std::vector<std::uint8_t>& r1,
                                         std::span<const std::int32_t> confidence,
                                         const EnergyWeights& weights) {
  return minimum_cut(CutBuilder(complex, shape, r1, confidence, weights).run()).kept;
}

}  // namespace crossloft
