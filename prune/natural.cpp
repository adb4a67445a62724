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
                 const CellRequests& requests)
      : complex_(complex),
        shape_(shape),
        options_(options),
        requests_(requests),
        limits_{as_integer(options.join_confidence), as_integer(options.dome_confidence), requests.wishes,
                requests.opened},
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
    if (!is_good(report, result.kept)) grow(confidence, result);
    if (!requests_.joined.empty()) join_alone(r1, confidence, result);
    if (!requests_.questions.empty())
      result.answers =
          SecondLook(complex_, ground_, r1, result.kept, confidence).answer(requests_.questions);
    return result;
  }

 private:
  /// Where a cavity is opened, nothing that is not sure is built: else no more than a slit is left open. What
  /// stands on a section goes too; there are the other side and bridges.
  void drop_unsure(std::span<const std::int32_t> confidence, std::vector<std::uint8_t>& allowed) const {
    const std::int32_t least = as_integer(options_.cavity_confidence);
    for (std::uint32_t t = 0; t < allowed.size(); ++t)
      if (confidence[t] < least) allowed[t] = 0;
  }

  void grow(std::span<const std::int32_t> confidence, NaturalResult& result) const {
    if (!requests_.opened.empty()) drop_unsure(confidence, result.kept);
    GrowthResult grown = grow_simply(complex_, ground_, result.kept, confidence, limits_);
    refill_cracks(complex_, ground_, result.kept, grown.kept);
    result.kept = std::move(grown.kept);
    result.report.grown = true;
    result.report.joins = std::move(grown.joins);
    result.report.domes = std::move(grown.domes);
    result.report.after = count_topology(complex_, ground_, result.kept);
  }

  void join_alone(const std::vector<std::uint8_t>& r1, std::span<const std::int32_t> confidence,
                  NaturalResult& result) const {
    for (const TetName& body : requests_.joined) {
      Join join;
      for (const std::uint32_t t :
           SecondLook(complex_, ground_, r1, result.kept, confidence).way_from(body, join))
        result.kept[t] = 1;
      if (join.done) result.report.joins.push_back(join);
    }
    result.report.after = count_topology(complex_, ground_, result.kept);
  }

  /// Nothing that growth could decide otherwise.
  bool is_good(const NaturalReport& report, const std::vector<std::uint8_t>& kept) const {
    const CellTopology& t = report.before;
    if (t.genus != 0 || t.voids != 0 || !limits_.wishes.empty() || !limits_.open.empty()) return false;
    if (!report.joins.empty() && report.joins.back().confidence < limits_.join) return false;
    return t.outsides <= 1 || !has_dome(complex_, kept);
  }

  const CellComplex& complex_;
  const CellShape& shape_;
  const NaturalOptions& options_;
  const CellRequests& requests_;
  const GrowthLimits limits_;
  const Ground ground_;
};

}  // namespace

NaturalResult prune_naturally(const CellComplex& complex, const CellShape& shape,
                              const std::vector<std::uint8_t>& r1, const NaturalOptions& options,
                              const CellRequests& requests) {
  return NaturalPruning(complex, shape, options, requests).run(r1);
}

}  // namespace crossloft
