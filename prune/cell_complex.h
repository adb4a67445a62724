#pragma once
/// R0 of one cell with its grounded simplices classified: the only input of pruning (paper, section 3).

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "../delaunay/tet_mesh.h"

namespace crossloft {

/// A facet of a tetrahedron against the sections; grounded = its vertices share a face of the cell.
enum class FacetKind : std::uint8_t { free, internal, external };
/// An edge of a tetrahedron against the sections; contour and internal edges are both inside the closed
/// section.
enum class EdgeKind : std::uint8_t { free, contour, internal, external };

/// A triangle by its vertices, ascending.
using Triangle = std::array<std::uint32_t, 3>;
/// A tetrahedron in the same way: names that do not depend on its number.
using TetName = std::array<std::uint32_t, 4>;

struct CellComplex {
  TetMesh mesh;
  std::uint32_t vertex_count = 0;
  /// Faces of the cell through each vertex: `words` 64-bit words a vertex, bit f = face f of the cell.
  std::uint32_t words = 1;
  std::vector<std::uint64_t> face_masks;
  std::vector<std::array<FacetKind, 4>> facets;  ///< [t][i]: facet opposite vertex slot i
  std::vector<std::array<EdgeKind, 6>> edges;    ///< [t][e]: edge kEdgeSlots[e]

  std::span<const std::uint64_t> faces_of(std::uint32_t v) const {
    return {face_masks.data() + std::size_t{v} * words, words};
  }

  /// No face of the cell passes through it.
  bool is_interior(std::uint32_t v) const {
    std::uint64_t on = 0;
    for (const std::uint64_t word : faces_of(v)) on |= word;
    return on == 0;
  }
  bool has_interior_vertices() const {
    for (std::uint32_t v = 0; v < vertex_count; ++v)
      if (is_interior(v)) return true;
    return false;
  }

  /// The lowest face that three vertices share, kNone if there is none. Of a triangle it is the only one.
  std::uint32_t common_face(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    for (std::uint32_t w = 0; w < words; ++w) {
      const std::uint64_t common = faces_of(a)[w] & faces_of(b)[w] & faces_of(c)[w];
      if (common != 0) return 64 * w + static_cast<std::uint32_t>(std::countr_zero(common));
    }
    return kNone;
  }
};

}  // namespace crossloft
