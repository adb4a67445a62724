#pragma once
/// The lower hull of collinear sites: the regular triangulation in dimension 1 and 0.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

#include "../geom/ids.h"
#include "point_predicates.h"

namespace crossloft::detail {

/// All sites by position, equal ones by height, then by index.
template <PowerPredicates3 P>
std::vector<std::uint32_t> sites_along_line(const P& p) {
  std::vector<std::uint32_t> order(p.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (const int sign = p.compare_lex(a, b)) return sign < 0;
    if (const int sign = p.compare_height(a, b)) return sign < 0;
    return a < b;
  });
  return order;
}

/// The vertices in lexicographic order; `kept` gets, for each site, its vertex or kNone (Regular3::kept).
/// A site exactly between two others stays: perturbed, the end of higher lexicographic order is raised by far
/// the most. REQUIRES: all positions on one line. O(n log n). Source: Andrew's monotone chain (1979), its
/// lower half.
template <PowerPredicates3 P>
std::vector<std::uint32_t> lower_chain(const P& p, std::vector<std::uint32_t>& kept) {
  std::vector<std::uint32_t> chain;
  kept.assign(p.size(), kNone);
  std::uint32_t lowest = kNone;  // of the sites in this place
  for (const std::uint32_t i : sites_along_line(p)) {
    if (lowest != kNone && p.compare_lex(lowest, i) == 0) {
      if (p.compare_height(lowest, i) == 0) kept[i] = lowest;
      continue;
    }
    for (std::size_t n = chain.size(); n > 1 && p.power_test1d(chain[n - 2], i, chain[n - 1]) < 0; --n) {
      kept[chain[n - 1]] = kNone;
      chain.pop_back();
    }
    chain.push_back(i);
    lowest = kept[i] = i;
  }
  for (std::uint32_t& k : kept)
    if (k != kNone && kept[k] != k) k = kNone;
  return chain;
}

/// Empty if the chain ascends, turns upwards at each vertex and passes below all hidden sites, and all others
/// stand for vertices. O(n log n).
template <PowerPredicates3 P>
std::string verify_chain(const P& p, const std::vector<std::uint32_t>& chain,
                         const std::vector<std::uint32_t>& kept) {
  for (std::size_t k = 1; k < chain.size(); ++k)
    if (p.compare_lex(chain[k - 1], chain[k]) >= 0) return "chain does not ascend";
  for (std::size_t k = 2; k < chain.size(); ++k)
    if (p.power_test1d(chain[k - 2], chain[k], chain[k - 1]) < 0) return "chain is not convex";
  const auto before = [&](std::uint32_t a, std::uint32_t b) { return p.compare_lex(a, b) < 0; };
  for (std::uint32_t i = 0; i < kept.size(); ++i) {
    if (kept[i] != kNone) {
      if (kept[kept[i]] != kept[i]) return "a site stands for a hidden one";
      continue;
    }
    const auto next = std::lower_bound(chain.begin(), chain.end(), i, before);
    if (next == chain.end()) return "hidden site beyond the chain";
    const bool above = p.compare_lex(*next, i) == 0
                           ? p.compare_height(*next, i) < 0
                           : next != chain.begin() && p.power_test1d(next[-1], *next, i) < 0;
    if (!above) return "hidden site is not above the chain";
  }
  return "";
}

}  // namespace crossloft::detail
