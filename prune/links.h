#pragma once
/// Census of vertex neighbourhoods after pruning (Definition 2): is each vertex a manifold point of the
/// cell's solid?
///
/// The extended link of v is the link of v in the kept tetrahedra, plus a virtual triangle for each internal
/// grounded triangle of the cell at v: the section has material on its other side. Virtual triangles are
/// joined to each other around v along grounded edges, and to the kept tetrahedron that they are a facet of.
/// v has a ball or half-ball as neighbourhood iff its extended link is a sphere or a disk. Solidity only
/// makes the link connected to the section; the usual failure is an annulus.

#include <cstdint>
#include <span>
#include <vector>

#include "cell_complex.h"

namespace crossloft {

/// Numbers of vertices by their extended link.
struct LinkCensus {
  std::uint32_t bare = 0;  ///< no kept tetrahedron at the vertex
  std::uint32_t disks = 0;
  std::uint32_t spheres = 0;
  std::uint32_t disconnected = 0;  ///< several components
  std::uint32_t pinched = 0;       ///< connected, but touching itself at a vertex: a singular edge ends here
  std::uint32_t annular = 0;       ///< connected, not pinched, with two or more boundary circles

  std::uint32_t bad_links() const { return disconnected + pinched + annular; }
};

/// Of the vertices v with wanted[v] != 0, once each. O(n), and n log n for the stars of these.
/// REQUIRES: kept.size() == complex.mesh.size().
LinkCensus census_links(const CellComplex& complex, std::span<const std::uint8_t> kept,
                        const std::vector<std::uint8_t>& wanted);

}  // namespace crossloft
