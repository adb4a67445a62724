#include "natural.h"

#include <algorithm>
#include <cmath>

#include "confidence.h"
#include "cracks.h"
#include "energy.h"
#include "outside.h"

namespace crossloft {
namespace {

std::int32_t as_integer(double confidence) {
  return static_cast<std::int32_t>(std::floor(confidence * kCertain + 0.5));
}

/// One cell on its way.
class NaturalPruning {
 public:
  NaturalPruning(const CellComplex& complex, const CellShape& shape, const NaturalOptions& options,
                 std::span<const JoinWish> wishes)
      : complex_(complex),
        shape_(shape),
        options_(options),
        limits_{as_integer(options.join_confidence), as_integer(options.dome_confidence), wishes},
        ground_(complex) {}

  NaturalResult run(const std::vector<std::uint8_t>& r1) {
    const std::vector<std::int32_t> confidence = confidences(complex_, shape_, r1);
    EnergyWeights weights;
    weights.smooth = options_.smooth_weight;
    NaturalResult result;
    result.kept = cheapest_solid(complex_, shape_, r1, confidence, weights);
    result.r2 = static_cast<std::uint32_t>(std::count(result.kept.begin(), result.kept.end(), 1));
    NaturalReport& report = result.report;
    report.before = report.after = count_topology(complex_, ground_, result.kept);
    if (report.before.bodies < report.before.sections)
      report.joins = find_joins(complex_, ground_, result.kept, confidence);
    if (is_good(report, result.kept)) return result;
    report.grown = true;
    GrowthResult grown = grow_simply(complex_, ground_, result.kept, confidence, limits_);
    report.after = refill_cracks(complex_, ground_, result.kept, grown.kept);
    result.kept = std::move(grown.kept);
    report.joins = std::move(grown.joins);
    report.domes = std::move(grown.domes);
    return result;
  }

 private:
  /// Nothing that growth could decide otherwise.
  bool is_good(const NaturalReport& report, const std::vector<std::uint8_t>& kept) const {
    const CellTopology& t = report.before;
    if (t.genus != 0 || t.voids != 0 || !limits_.wishes.empty()) return false;
    if (!report.joins.empty() && report.joins.back().confidence < limits_.join) return false;
    return t.outsides <= 1 || !has_dome(complex_, kept);
  }

  const CellComplex& complex_;
  const CellShape& shape_;
  const NaturalOptions& options_;
  const GrowthLimits limits_;
  const Ground ground_;
};

}  // namespace

NaturalResult prune_naturally(const CellComplex& complex, const CellShape& shape,
                              const std::vector<std::uint8_t>& r1, const NaturalOptions& options,
                              std::span<const JoinWish> wishes) {
  return NaturalPruning(complex, shape, options, wishes).run(r1);
}

}  // namespace crossloft
