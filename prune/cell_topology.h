#pragma once
/// The topology of a cell's solid with its sections, by counting.
///
/// The surface S of a cell is where its solid, kept tetrahedra and ground (ground.h), ends within the cell:
/// facets between kept and other tetrahedra, and bare ground triangles. Cut apart as gluing does it (wedges
/// of the solid are separate along an edge, umbrellas at a vertex) S is a surface whose boundary is the
/// boundary of the sections. A cell is a ball, so each component of S cuts it in two: solid and outside have
/// together one part more than S has components, and
///     genus(S) = components(S) - (euler(S) + boundary curves(S)) / 2.
/// Genus 0 is always possible. The Euler characteristic of the surface of the whole solid is, but for a
/// constant of the sections, the sum of 2 components(S) - 2 genus(S) - curves(S): it is wrong through a genus
/// that is not 0 or through a wrong number of components.

#include <cstdint>
#include <span>
#include <vector>

#include "cell_complex.h"
#include "ground.h"

namespace crossloft {

struct CellTopology {
  std::uint32_t sections = 0;  ///< connected parts of the ground
  std::uint32_t bodies = 0;    ///< connected parts of solid and ground
  /// Connected parts of the rest; more than 1: a dome or wall closes one off, or a bridge where sections
  /// touch in a point, as the outside is cut at a vertex.
  std::uint32_t outsides = 0;
  std::uint32_t voids = 0;      ///< components of S without boundary: holes or islands within the cell
  std::uint32_t genus = 0;      ///< of S; handles that the cell itself has made
  std::int64_t euler = 0;       ///< of S, cut apart as said
  std::uint32_t curves = 0;     ///< boundary curves of S
  std::uint32_t bare = 0;       ///< ground triangles without a kept tetrahedron
  std::uint32_t bad_links = 0;  ///< vertices whose extended link is neither a disk nor a sphere (links.h)

  friend bool operator==(const CellTopology&, const CellTopology&) = default;
};

/// Connected parts of solid and ground.
struct CellBodies {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> of_ground;  ///< by ground triangle: the smallest one of its body
};

/// O(n).
CellBodies find_bodies(const CellComplex& complex, const Ground& ground,
                       const std::vector<std::uint8_t>& kept);

/// O(n + degrees of edges on S). REQUIRES: kept.size() == complex.mesh.size().
CellTopology count_topology(const CellComplex& complex, const Ground& ground,
                            const std::vector<std::uint8_t>& kept);
/// The same if the bodies are known.
CellTopology count_topology(const CellComplex& complex, const Ground& ground,
                            const std::vector<std::uint8_t>& kept, const CellBodies& bodies);

}  // namespace crossloft
