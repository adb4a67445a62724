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
        ground_(complex),
        meter_(complex, ground_, shape),
        confidence_(complex.mesh.size(), -kCertain) {}

  NaturalResult run(const std::vector<std::uint8_t>& r1) {
    measure(r1, false);
    EnergyWeights weights;
    weights.smooth = options_.smooth_weight;
    NaturalResult result;
    result.kept = cheapest_solid(complex_, shape_, r1, confidence_, weights);
    result.r2 = static_cast<std::uint32_t>(std::count(result.kept.begin(), result.kept.end(), 1));
    NaturalReport& report = result.report;
    report.before = report.after = count_topology(complex_, ground_, result.kept);
    const bool joins = report.before.bodies < report.before.sections;
    if (joins) {
      measure(r1, true);
      report.joins = find_joins(complex_, ground_, result.kept, confidence_);
    }
    const bool good = is_good(report, result.kept);
    if (!joins && (!good || !requests_.joined.empty() || !requests_.questions.empty())) measure(r1, true);
    if (!good) grow(result);
    if (!requests_.joined.empty()) join_alone(r1, result);
    if (!requests_.questions.empty())
      result.answers =
          SecondLook(complex_, ground_, r1, result.kept, confidence_).answer(requests_.questions);
    return result;
  }

 private:
  /// Where a cavity is opened, nothing that is not sure is built: else no more than a slit is left open. What
  /// stands on a section goes too; there are the other side and bridges.
  void drop_unsure(std::vector<std::uint8_t>& allowed) const {
    const std::int32_t least = as_integer(options_.cavity_confidence);
    for (std::uint32_t t = 0; t < allowed.size(); ++t)
      if (confidence_[t] < least) allowed[t] = 0;
  }

  void grow(NaturalResult& result) const {
    if (!requests_.opened.empty()) drop_unsure(result.kept);
    GrowthResult grown = grow_simply(complex_, ground_, result.kept, confidence_, limits_);
    result.report.after = refill_cracks(complex_, ground_, result.kept, grown.kept);
    result.kept = std::move(grown.kept);
    result.report.grown = true;
    result.report.joins = std::move(grown.joins);
    result.report.domes = std::move(grown.domes);
  }

  void join_alone(const std::vector<std::uint8_t>& r1, NaturalResult& result) const {
    for (const TetName& body : requests_.joined) {
      Join join;
      for (const std::uint32_t t :
           SecondLook(complex_, ground_, r1, result.kept, confidence_).way_from(body, join))
        result.kept[t] = 1;
      if (join.done) result.report.joins.push_back(join);
    }
    result.report.after = count_topology(complex_, ground_, result.kept);
  }

  /// The cut does not ask how likely tied tetrahedra are: they are measured where joins or growth do.
  void measure(const std::vector<std::uint8_t>& wanted, bool tied) {
    for (std::uint32_t t = 0; t < wanted.size(); ++t)
      if (wanted[t] != 0 && is_tied_to_sections(complex_, t) == tied) confidence_[t] = meter_.measure(t);
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
  const ConfidenceMeter meter_;
  std::vector<std::int32_t> confidence_;
};

}  // namespace

NaturalResult prune_naturally(const CellComplex& complex, const CellShape& shape,
                              const std::vector<std::uint8_t>& r1, const NaturalOptions& options,
                              const CellRequests& requests) {
  return NaturalPruning(complex, shape, options, requests).run(r1);
}

}  // namespace crossloft
