#pragma once
/// The sections of a cell as part of its solid.
///
/// Behind each internal hull triangle the section has material: think of a prism under it, a *ground
/// triangle*. Ground triangles are glued to the tetrahedra that stand on them, and to each other across the
/// hull edges between two of them, also where these are on different faces.

#include <array>
#include <cstdint>
#include <vector>

#include "cell_complex.h"
#include "star.h"

namespace crossloft {

/// A facet of a tetrahedron.
struct Facet {
  std::uint32_t tet = kNone;
  std::uint8_t facet = 0;

  friend bool operator==(const Facet&, const Facet&) = default;
};

class Ground {
 public:
  /// REQUIRES: each edge of the hull is in two triangles of it, as in R0; the complex stays as it is while
  /// this is used. O(n).
  explicit Ground(const CellComplex& complex);

  std::uint32_t size() const { return static_cast<std::uint32_t>(facets_.size()); }
  /// The hull facet that is ground triangle g.
  const Facet& facet(std::uint32_t g) const { return facets_[g]; }
  /// The ground triangle that is facet i of t, kNone if it is none. They are numbered in the order of
  /// tetrahedra and slots.
  std::uint32_t at(std::uint32_t t, unsigned i) const {
    if (!is_ground(t, i)) return kNone;
    std::uint32_t g = first_[t];
    for (unsigned before = 0; before < i; ++before) g += is_ground(t, before) ? 1U : 0U;
    return g;
  }
  bool is_ground(std::uint32_t t, unsigned i) const { return complex_.facets[t][i] == FacetKind::internal; }
  /// The ground triangle across the side of g that is the edge between its slots kFacetSlots[i][k] and
  /// [(k + 1) % 3], kNone where the section ends.
  std::uint32_t neighbour(std::uint32_t g, unsigned k) const { return neighbours_[g][k]; }
  /// The same by the edge's corner (star.h) in the tetrahedron of g.
  std::uint32_t across(std::uint32_t g, unsigned corner) const {
    return neighbours_[g][side_of(facets_[g].facet, corner)];
  }
  /// Number of the connected part of the sections that g is in: its smallest ground triangle.
  std::uint32_t part(std::uint32_t g) const { return parts_[g]; }
  std::uint32_t part_count() const;

  /// Which side k of facet i the edge is. REQUIRES: the facet contains it.
  static unsigned side_of(unsigned i, unsigned corner);

 private:
  const CellComplex& complex_;
  std::vector<Facet> facets_;
  std::vector<std::uint32_t> first_;  ///< by tetrahedron: its first ground triangle
  std::vector<std::array<std::uint32_t, 3>> neighbours_;
  std::vector<std::uint32_t> parts_;
};

/// Turns around an edge through the solid: crosses facet `from`, the edge its tetrahedron's given corner, and
/// goes on through kept tetrahedra and ground triangles. Returns the facet where the solid ends, seen from
/// its kept tetrahedron, or from the bare one above a ground triangle; no tetrahedron (kNone) where the
/// section ends. If nothing kept is across `from`, that is `from` itself. REQUIRES: the way ends before it
/// comes back to where it started, as it does if a tetrahedron at the edge is not kept.
Facet turn_through_solid(const CellComplex& complex, const Ground& ground,
                         const std::vector<std::uint8_t>& kept, Facet from, unsigned corner);
/// The same; the facet that it goes out of first is `from`.
Facet turn_through_solid(const CellComplex& complex, const Ground& ground,
                         const std::vector<std::uint8_t>& kept, Turn turn);

}  // namespace crossloft
