#pragma once
/// The bodies of a cell's solid with its sections, and what they stand on.

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "../geom/disjoint_sets.h"
#include "cell_complex.h"
#include "ground.h"
#include "joins.h"

namespace crossloft {

/// A body is named by the smallest one of its ground triangles; one that stands on none, an island, by its
/// smallest tetrahedron, after these.
class Bodies {
 public:
  /// O(n).
  Bodies(const CellComplex& complex, const Ground& ground, const std::vector<std::uint8_t>& kept)
      : complex_(complex),
        ground_(ground),
        kept_(kept),
        sets_(std::size_t{ground.size()} + kept.size()),
        names_(part_names(complex, ground)),
        is_one_part_(ground.size(), 1) {
    for (std::uint32_t g = 0; g < ground.size(); ++g) sets_.join(ground.part(g), g);
    for (std::uint32_t t = 0; t < kept.size(); ++t)
      if (kept[t] != 0) see(t);
  }

  /// The tetrahedron has come to what is kept.
  void see(std::uint32_t t) {
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t n = complex_.mesh.neighbours[t][i];
      if (n != kNone && kept_[n] != 0) join(of_tet(n), of_tet(t));
      if (ground_.is_ground(t, i)) join(of_ground(ground_.at(t, i)), of_tet(t));
    }
  }

  std::uint32_t of_tet(std::uint32_t t) { return sets_.find(ground_.size() + t); }
  std::uint32_t of_ground(std::uint32_t g) { return sets_.find(g); }

  /// The body at a facet of t, kNone if there is none.
  std::uint32_t at(std::uint32_t t, unsigned i) {
    if (ground_.is_ground(t, i)) return of_ground(ground_.at(t, i));
    const std::uint32_t n = complex_.mesh.neighbours[t][i];
    return n != kNone && kept_[n] != 0 ? of_tet(n) : kNone;
  }

  /// A body at t other than `own`, kNone if there is none.
  std::uint32_t other_at(std::uint32_t t, std::uint32_t own) {
    std::uint32_t other = kNone;
    for (unsigned i = 0; i < 4; ++i)
      if (const std::uint32_t b = at(t, i); b != own) other = std::min(other, b);
    return other;
  }

  /// True for an island too.
  bool stands_on_one_part(std::uint32_t body) const {
    return body >= is_one_part_.size() || is_one_part_[body] != 0;
  }

  /// Its smallest section vertex, kNone of an island.
  std::uint32_t name_of(std::uint32_t body) const { return body < names_.size() ? names_[body] : kNone; }

 private:
  void join(std::uint32_t a, std::uint32_t b) {
    if (a == b) return;
    if (a > b) std::swap(a, b);
    sets_.join(a, b);  // a stays the name
    if (b >= names_.size()) return;
    names_[a] = std::min(names_[a], names_[b]);
    is_one_part_[a] = 0;
  }

  const CellComplex& complex_;
  const Ground& ground_;
  const std::vector<std::uint8_t>& kept_;
  DisjointSets sets_;                      ///< ground triangles, then tetrahedra
  std::vector<std::uint32_t> names_;       ///< by ground triangle that names a body
  std::vector<std::uint8_t> is_one_part_;  ///< likewise
};

}  // namespace crossloft
