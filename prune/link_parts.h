#pragma once
/// What hangs together around a vertex: the parts of its extended link (links.h).

#include <cstdint>
#include <vector>

#include "../geom/disjoint_sets.h"
#include "cell_complex.h"
#include "ground.h"
#include "star.h"

namespace crossloft {

/// Kept tetrahedra and ground triangles at a vertex are in one part of its link if they are connected through
/// triangles with that vertex. Parts of all vertices have different numbers; so have the bodies that they are
/// in.
class LinkParts {
 public:
  /// O(n).
  LinkParts(const CellComplex& complex, const Ground& ground, const std::vector<std::uint8_t>& kept);

  /// REQUIRES: t is kept and v is one of its vertices.
  std::uint32_t of_tet(std::uint32_t t, std::uint32_t v) const { return parts_.root(corner_of(t, v)); }
  /// REQUIRES: v is a vertex of g.
  std::uint32_t of_ground(std::uint32_t g, std::uint32_t v) const {
    return parts_.root(ground_corner_of(g, v));
  }
  /// Connected part of solid and ground.
  std::uint32_t body_of_tet(std::uint32_t t) const { return bodies_.root(t); }
  std::uint32_t body_of_ground(std::uint32_t g) const { return bodies_.root(number_of_ground(g)); }

 private:
  std::uint32_t corner_of(std::uint32_t t, std::uint32_t v) const {
    return 4 * t + slot_of(complex_.mesh.vertices[t], v);
  }
  /// After the tetrahedra.
  std::uint32_t number_of_ground(std::uint32_t g) const {
    return static_cast<std::uint32_t>(complex_.mesh.size()) + g;
  }
  /// By the slot in the tetrahedron above.
  std::uint32_t ground_corner_of(std::uint32_t g, std::uint32_t v) const {
    return 4 * number_of_ground(g) + slot_of(complex_.mesh.vertices[ground_.facet(g).tet], v);
  }
  void join_kept(const std::vector<std::uint8_t>& kept);
  void join_ground(const std::vector<std::uint8_t>& kept);

  const CellComplex& complex_;
  const Ground& ground_;
  DisjointSets parts_, bodies_;
};

}  // namespace crossloft
