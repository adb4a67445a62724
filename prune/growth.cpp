#include "growth.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "star.h"

namespace crossloft {
namespace {

class Growth {
 public:
  Growth(const CellComplex& complex, const std::vector<std::uint8_t>& candidates, TwoFacetRule rule,
         std::vector<std::uint8_t>& kept)
      : complex_(complex),
        mesh_(complex.mesh),
        candidates_(candidates),
        rule_(rule),
        kept_(kept),
        listed_(kept.size(), 0) {}

  void run() {
    for (std::uint32_t t = 0; t < mesh_.size(); ++t) list_if_open(t);
    sort_from(0);
    for (std::size_t head = 0; head < list_.size(); ++head) {
      const std::uint32_t t = list_[head];
      listed_[t] = 0;
      if (!may_join(t)) continue;
      kept_[t] = 1;
      list_neighbours(t);
    }
  }

 private:
  /// Not in the list, but should be.
  bool is_open(std::uint32_t t) const {
    return candidates_[t] != 0 && kept_[t] == 0 && listed_[t] == 0 && is_several(facets_in_solid(t));
  }

  static bool is_several(unsigned bits) { return (bits & (bits - 1)) != 0; }

  /// Bit i: the facet opposite slot i is shared with the solid.
  unsigned facets_in_solid(std::uint32_t t) const {
    unsigned bits = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t n = mesh_.neighbours[t][i];
      if (n != kNone && kept_[n] != 0) bits |= 1U << i;
    }
    return bits;
  }

  void list_if_open(std::uint32_t t) {
    if (!is_open(t)) return;
    listed_[t] = 1;
    list_.push_back(t);
  }

  void list_neighbours(std::uint32_t t) {
    const std::size_t first = list_.size();
    for (const std::uint32_t n : mesh_.neighbours[t]) {
      if (n != kNone) list_if_open(n);
    }
    sort_from(first);
  }

  /// Puts the end of the list into canonical order.
  void sort_from(std::size_t first) {
    std::sort(list_.begin() + static_cast<std::ptrdiff_t>(first), list_.end(),
              [&](std::uint32_t a, std::uint32_t b) {
                return sorted_vertices(mesh_, a) < sorted_vertices(mesh_, b);
              });
  }

  /// REQUIRES: two facets in the solid or more; facets are never lost again.
  bool may_join(std::uint32_t t) const {
    const unsigned bits = facets_in_solid(t);
    for (unsigned corner = 4; corner < kCorners; ++corner) {
      const auto& ends = kEdgeSlots[corner - 4];
      // The facets opposite its two ends are the glued ones: neither of them has this edge.
      if (bits != (1U << ends[0] | 1U << ends[1])) continue;
      if (rule_ == TwoFacetRule::literal) return true;
      return !is_grounded(complex_, t, corner) && !is_edge_in_solid(t, corner);
    }
    return true;  // three or four
  }

  /// Turns around the edge both ways from t: all the way, or to the hull on both sides.
  bool is_edge_in_solid(std::uint32_t t, unsigned corner) const {
    for (unsigned i = 0; i < 4; ++i) {
      if (facet_contains(i, corner) && meets_solid(t, corner, i)) return true;
    }
    return false;
  }

  bool meets_solid(std::uint32_t start, unsigned corner, unsigned facet) const {
    for (std::uint32_t t = start;;) {
      const std::uint32_t n = mesh_.neighbours[t][facet];
      if (n == kNone || n == start) return false;
      if (kept_[n] != 0) return true;
      corner = same_corner(mesh_, t, corner, n);
      // An edge has two facets: leave through the other one.
      const unsigned entered = facet_towards(mesh_, n, t);
      const unsigned both = kCornerFacets[corner];
      for (facet = 0; facet == entered || (both >> facet & 1U) == 0;) ++facet;
      t = n;
    }
  }

  const CellComplex& complex_;
  const TetMesh& mesh_;
  const std::vector<std::uint8_t>& candidates_;
  TwoFacetRule rule_;
  std::vector<std::uint8_t>& kept_;
  std::vector<std::uint8_t> listed_;
  std::vector<std::uint32_t> list_;
};

}  // namespace

void grow_over_facets(const CellComplex& complex, const std::vector<std::uint8_t>& candidates,
                      TwoFacetRule rule, std::vector<std::uint8_t>& kept) {
  Growth(complex, candidates, rule, kept).run();
}

}  // namespace crossloft
