#include "prune.h"

#include <algorithm>

#include "growth.h"
#include "solidity.h"
#include "star.h"

namespace crossloft {
namespace {

std::uint32_t count(const std::vector<std::uint8_t>& flags) {
  return static_cast<std::uint32_t>(std::count(flags.begin(), flags.end(), std::uint8_t{1}));
}

/// T_vf or T_ee for general tags: two faces of the cell cover the four vertices, that is, a grounded triangle
/// and any vertex, or two opposite grounded edges. (Four vertices on one face would be flat.)
bool is_two_plane(const CellComplex& complex, std::uint32_t t) {
  const auto& edges = complex.edges[t];
  for (unsigned e = 0; e < 3; ++e) {
    if (edges[e] != EdgeKind::free && edges[5 - e] != EdgeKind::free) return true;
  }
  return std::any_of(complex.facets[t].begin(), complex.facets[t].end(),
                     [](FacetKind kind) { return kind != FacetKind::free; });
}

/// Takes the tetrahedra of R1 over more than two planes, T_evv and T_vvvv, out of `kept`.
std::vector<std::uint8_t> take_candidates(const CellComplex& complex, std::vector<std::uint8_t>& kept) {
  std::vector<std::uint8_t> candidates(kept.size(), 0);
  for (std::uint32_t t = 0; t < complex.mesh.size(); ++t) {
    if (kept[t] != 0 && !is_two_plane(complex, t)) std::swap(kept[t], candidates[t]);
  }
  return candidates;
}

}  // namespace

const char* name_of(PruneMode mode) {
  switch (mode) {
    case PruneMode::natural:
      return "natural";
    case PruneMode::joint:
      return "joint";
    case PruneMode::paper:
      return "paper";
    case PruneMode::paper_literal:
      return "paper-literal";
  }
  return "";
}

std::vector<std::uint8_t> without_external(const CellComplex& complex) {
  std::vector<std::uint8_t> r1(complex.mesh.size());
  for (std::uint32_t t = 0; t < complex.mesh.size(); ++t) r1[t] = is_external(complex, t) ? 0 : 1;
  return r1;
}

PruneResult prune(const CellComplex& complex, const CellShape& shape, const PruneOptions& options,
                  const CellRequests& requests) {
  return prune(complex, Ground(complex), shape, options, requests);
}

PruneResult prune(const CellComplex& complex, const Ground& ground, const CellShape& shape,
                  const PruneOptions& options, const CellRequests& requests) {
  if (options.mode != PruneMode::natural) {
    PruneResult result = prune(complex, options.mode);
    result.natural.before = result.natural.after = count_topology(complex, ground, result.kept);
    return result;
  }
  PruneResult result;
  result.r0 = complex.mesh.size();
  const std::vector<std::uint8_t> r1 = without_external(complex);
  result.r1 = count(r1);
  NaturalResult natural = prune_naturally(complex, ground, shape, r1, options.natural, requests);
  result.kept = std::move(natural.kept);
  result.r2 = natural.r2;
  result.r3 = count(result.kept);
  result.natural = std::move(natural.report);
  return result;
}

PruneResult prune(const CellComplex& complex, PruneMode mode) {
  PruneResult result;
  result.r0 = complex.mesh.size();
  result.kept = without_external(complex);
  result.r1 = count(result.kept);
  if (mode == PruneMode::joint) {
    keep_largest_solid_subset(complex, result.kept);
    result.r2 = result.r3 = count(result.kept);
    return result;
  }
  const std::vector<std::uint8_t> candidates = take_candidates(complex, result.kept);
  keep_largest_solid_subset(complex, result.kept);
  result.r2 = count(result.kept);
  const auto rule = mode == PruneMode::paper ? TwoFacetRule::corrected : TwoFacetRule::literal;
  grow_over_facets(complex, candidates, rule, result.kept);
  result.r3 = count(result.kept);
  return result;
}

}  // namespace crossloft
