#pragma once
/// One cell of the arrangement: Delaunay triangulation of its section vertices with its grounded simplices classified.

#include <span>
#include <vector>

#include "../delaunay/point_predicates.h"
#include "../geom/lattice.h"
#include "../prune/cell_complex.h"
#include "face_triangulation.h"

namespace crossloft {

/// A face as its two cells need it: the triangulation and the final number of each of its local vertices.
struct CellFace {
  const FaceTriangulation* triangulation = nullptr;
  std::span<const std::uint32_t> numbers;
};

/// Predicates over the vertices of a cell that answer what the faces already say: four vertices on one face are
/// coplanar, three on two faces collinear.
class CellPredicates {
 public:
  CellPredicates(std::span<const LatticePoint> points, std::span<const std::uint64_t> face_masks, std::uint32_t words)
      : points_(points), masks_(face_masks), words_(words) {}

  std::uint32_t size() const { return static_cast<std::uint32_t>(points_.size()); }
  double coordinate(std::uint32_t i, int axis) const { return points_[i][axis]; }
  int orient3d(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    for (std::uint32_t w = 0; w < words_; ++w)
      if ((mask(a, w) & mask(b, w) & mask(c, w) & mask(d, w)) != 0) return 0;
    return crossloft::orient3d(points_[a], points_[b], points_[c], points_[d]);
  }
  int insphere(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t e) const {
    return crossloft::insphere(points_[a], points_[b], points_[c], points_[d], points_[e]);
  }
  bool collinear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  int compare_lex(std::uint32_t a, std::uint32_t b) const {
    return a < b ? -1 : a > b ? 1 : 0;  // vertices are numbered in lexicographic order
  }

 private:
  std::uint64_t mask(std::uint32_t v, std::uint32_t w) const { return masks_[std::size_t{v} * words_ + w]; }
  std::span<const LatticePoint> points_;
  std::span<const std::uint64_t> masks_;
  std::uint32_t words_;
};

static_assert(PointPredicates3<CellPredicates>);

/// Where an internal grounded triangle of a cell comes from.
struct GroundTriangle {
  std::uint32_t face = 0;      ///< index in the cell's faces
  std::uint32_t triangle = 0;  ///< of that face's triangulation
};

struct BuiltCell {
  std::vector<std::uint32_t> vertices;  ///< final numbers, ascending; local number = position
  CellComplex complex;
  /// [t][i]: the internal triangle under facet i of tetrahedron t, face kNone where there is none.
  std::vector<std::array<GroundTriangle, 4>> ground;
  double delaunay_seconds = 0;
};

/// Builds R0 of a cell. `points` by final vertex number, which is lexicographic. Without tetrahedra (no internal triangle, or
/// all vertices on one plane) the complex is empty.
/// Error internal if a face triangle is not a hull facet or a hull facet on a face not one of its triangles.
Result<BuiltCell> build_cell(std::span<const CellFace> faces, std::span<const LatticePoint> points,
                             const LineEdges& line_edges, std::span<const std::uint32_t> graph_vertex_of);

}  // namespace crossloft
