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
        ground_(complex),
        confidence_(complex.mesh.size(), -kCertain) {}

  NaturalResult run(const std::vector<std::uint8_t>& r1) {
    const ConfidenceMeter meter(complex_, ground_, shape_);
    measure(meter, r1, false);
    EnergyWeights weights;
    weights.smooth = options_.smooth_weight;
    NaturalResult result;
    result.kept = cheapest_solid(complex_, shape_, r1, confidence_, weights);
    result.r2 = static_cast<std::uint32_t>(std::count(result.kept.begin(), result.kept.end(), 1));
    NaturalReport& report = result.report;
    report.before = report.after = count_topology(complex_, ground_, result.kept);
    const bool joins = report.before.bodies < report.before.sections;
    if (!joins && is_good(report, result.kept)) return result;
    measure(meter, result.kept, true);
    if (joins) report.joins = find_joins(complex_, ground_, result.kept, confidence_);
    if (joins && is_good(report, result.kept)) return result;
    report.grown = true;
    GrowthResult grown = grow_simply(complex_, ground_, result.kept, confidence_, limits_);
    report.after = refill_cracks(complex_, ground_, result.kept, grown.kept);
    result.kept = std::move(grown.kept);
    report.joins = std::move(grown.joins);
    report.domes = std::move(grown.domes);
    return result;
  }

 private:
  /// The cut does not ask how likely tied tetrahedra are: they are measured where joins or growth do.
  void measure(const ConfidenceMeter& meter, const std::vector<std::uint8_t>& wanted, bool tied) {
    for (std::uint32_t t = 0; t < wanted.size(); ++t)
      if (wanted[t] != 0 && is_tied_to_sections(complex_, t) == tied) confidence_[t] = meter.measure(t);
  }

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
  std::vector<std::int32_t> confidence_;
};

}  // namespace

NaturalResult prune_naturally(const CellComplex& complex, const CellShape& shape,
                              const std::vector<std::uint8_t>& r1, const NaturalOptions& options,
                              std::span<const JoinWish> wishes) {
  return NaturalPruning(complex, shape, options, wishes).run(r1);
}

}  // namespace crossloft
