#pragma once
/// The sections of a cell by the parts that hang together, and how many planes meet the bodies that they
/// become.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "../geom/disjoint_sets.h"
#include "cell_complex.h"
#include "ground.h"
#include "joins.h"

namespace crossloft {

struct SectionPart {
  std::uint32_t number = 0;             ///< Ground::part
  std::vector<std::uint32_t> vertices;  ///< ascending
  std::vector<std::uint32_t> faces;     ///< of the cell, in which it is; ascending
};

/// By their vertices, so that the order does not depend on the numbers of tetrahedra. O(n log n) for n ground
/// triangles.
std::vector<SectionPart> section_parts(const CellComplex& complex, const Ground& ground);

/// Parts that become bodies. A body is named by the index of one of its parts.
class SeenBodies {
 public:
  explicit SeenBodies(std::span<const SectionPart> parts);

  std::uint32_t body_of(std::uint32_t part) { return sets_.find(part); }
  /// How many planes meet the one of two bodies that fewer meet. REQUIRES, like join(): they are body_of().
  std::size_t planes_at_both(std::uint32_t a, std::uint32_t b) const;
  void join(std::uint32_t a, std::uint32_t b);

 private:
  DisjointSets sets_;
  std::vector<std::vector<std::uint32_t>> faces_;  ///< by body, ascending
};

/// The two bodies of a join in the order of joins. It names one part of each by its smallest vertex, which
/// parts that touch may have in common: then the first that are not one yet, which need not be the right
/// ones. Nothing if there are none.
std::optional<std::array<std::uint32_t, 2>> bodies_of(const Join& join, std::span<const SectionPart> parts,
                                                      SeenBodies& bodies);

}  // namespace crossloft
