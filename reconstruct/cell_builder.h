#pragma once
/// One cell of the arrangement: Delaunay triangulation of its section vertices with its grounded simplices
/// classified.

#include <array>
#include <compare>
#include <span>
#include <vector>

#include "../prune/cell_complex.h"
#include "cell_triangulation.h"

namespace crossloft {

/// Where an internal grounded triangle of a cell comes from.
struct GroundTriangle {
  std::uint32_t face = 0;      ///< index in the cell's faces
  std::uint32_t triangle = 0;  ///< of that face's triangulation
};

struct BuiltCell {
  std::vector<std::uint32_t> vertices;  ///< final numbers, ascending; local number = position
  std::vector<LatticePoint> points;     ///< in step
  CellComplex complex;
  /// The triangles under the internal facets, in the order of tetrahedra and slots: by number in
  /// prune/ground.h.
  std::vector<GroundTriangle> ground;
};

/// A tetrahedron by its vertices, ascending, with the kinds of the facets opposite to them and of the edges
/// between them (kEdgeSlots).
struct TetKinds {
  TetName name{};
  std::array<FacetKind, 4> facets{};
  std::array<EdgeKind, 6> edges{};
  friend auto operator<=>(const TetKinds&, const TetKinds&) = default;
};

/// All of them, ascending: equal for equal cells, however they were made. O(n log n).
std::vector<TetKinds> kinds_of(const CellComplex& complex);

/// Classifies R0. Local numbers of the result are in the order of the final ones. Without tetrahedra the
/// complex is empty. Error internal if a face triangle is not a hull facet or a hull facet on a face not one
/// of its triangles.
Result<BuiltCell> build_cell(std::span<const CellFace> faces, const CellTriangulation& triangulation,
                             const LineEdges& line_edges, std::span<const std::uint32_t> graph_vertex_of);

}  // namespace crossloft
