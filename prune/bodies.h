#pragma once
/// The bodies of a cell's solid with its sections, and what they stand on.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "../geom/disjoint_sets.h"
#include "cell_complex.h"
#include "ground.h"
#include "joins.h"

namespace crossloft {

/// A body is named by the smallest one of its ground triangles.
class Bodies {
 public:
  Bodies(const CellComplex& complex, const Ground& ground, const std::vector<std::uint8_t>& kept)
      : complex_(complex), ground_(ground), kept_(kept), sets_(std::size_t{ground.size()} + kept.size()) {
    for (std::uint32_t g = 0; g < ground.size(); ++g) {
      sets_.join(ground.part(g), g);
      if (const std::uint32_t t = ground.facet(g).tet; kept[t] != 0) sets_.join(g, ground.size() + t);
    }
    for (std::uint32_t t = 0; t < kept.size(); ++t)
      for (const std::uint32_t n : complex.mesh.neighbours[t])
        if (kept[t] != 0 && n < t && kept[n] != 0) sets_.join(ground.size() + n, ground.size() + t);
  }

  std::uint32_t of_tet(std::uint32_t t) { return sets_.find(ground_.size() + t); }
  std::uint32_t of_ground(std::uint32_t g) { return sets_.find(g); }

  /// The body at a facet of t, kNone if there is none.
  std::uint32_t at(std::uint32_t t, unsigned i) {
    if (ground_.is_ground(t, i)) return of_ground(ground_.at(t, i));
    const std::uint32_t n = complex_.mesh.neighbours[t][i];
    return n != kNone && kept_[n] != 0 ? of_tet(n) : kNone;
  }

  bool touches(std::uint32_t t, std::uint32_t body) {
    return at(t, 0) == body || at(t, 1) == body || at(t, 2) == body || at(t, 3) == body;
  }

  /// A body at t other than `own`, kNone if there is none.
  std::uint32_t other_at(std::uint32_t t, std::uint32_t own) {
    std::uint32_t other = kNone;
    for (unsigned i = 0; i < 4; ++i)
      if (const std::uint32_t b = at(t, i); b != own) other = std::min(other, b);
    return other;
  }

  bool stands_on_one_part(std::uint32_t body) {
    std::uint32_t part = kNone;
    for (std::uint32_t g = 0; g < ground_.size(); ++g) {
      if (of_ground(g) != body) continue;
      if (part != kNone && part != ground_.part(g)) return false;
      part = ground_.part(g);
    }
    return true;
  }

  /// Its smallest section vertex.
  std::uint32_t name_of(std::uint32_t body) {
    const std::vector<std::uint32_t> names = part_names(complex_, ground_);
    std::uint32_t name = kNone;
    for (std::uint32_t g = 0; g < ground_.size(); ++g)
      if (of_ground(g) == body) name = std::min(name, names[ground_.part(g)]);
    return name;
  }

 private:
  const CellComplex& complex_;
  const Ground& ground_;
  const std::vector<std::uint8_t>& kept_;
  DisjointSets sets_;  ///< ground triangles, then tetrahedra
};

}  // namespace crossloft
