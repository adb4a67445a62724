#pragma once
/// The Delaunay triangulation R0 of one cell's section vertices, which can take branching samples later.

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "../delaunay/delaunay3.h"
#include "../delaunay/lattice_predicates.h"
#include "../geom/lattice.h"
#include "../geom/result.h"
#include "face_triangulation.h"

namespace crossloft {

/// A face as its two cells need it: the triangulation and the final number of each of its local vertices.
struct CellFace {
  const FaceTriangulation* triangulation = nullptr;
  std::span<const std::uint32_t> numbers;
  std::uint32_t side = 0;  ///< 0 if the cell is on the negative side of the face's plane, else 1

  /// Whether a kept tetrahedron of the cell stands on an internal triangle. REQUIRES: the cell has been
  /// pruned.
  bool covers(std::size_t triangle) const { return triangulation->covered[side][triangle] != 0; }
  /// The same for the cell on the other side.
  bool covered_behind(std::size_t triangle) const { return triangulation->covered[1 - side][triangle] != 0; }
};

/// The vertices of a cell: their numbers over all cells, points, and faces of the cell that they lie on.
struct CellVertices {
  std::vector<std::uint32_t> numbers;
  std::vector<LatticePoint> points;
  std::vector<std::uint64_t> face_masks;  ///< `words` of each vertex; bit f: on face f of the cell
  std::uint32_t words = 1;
  std::uint32_t first_interior = kNone;  ///< numbers below this are in lexicographic order

  std::uint32_t size() const { return static_cast<std::uint32_t>(numbers.size()); }
  std::uint64_t mask(std::uint32_t v, std::uint32_t word) const {
    return face_masks[std::size_t{v} * words + word];
  }
  bool on_face(std::uint32_t v, std::size_t face) const {
    return (mask(v, static_cast<std::uint32_t>(face / 64)) >> (face % 64) & 1) != 0;
  }
};

/// Predicates over the vertices of a cell that answer what the faces already say: four vertices on one face
/// are coplanar, three on two faces collinear. Sees vertices that are added later, after see_vertices().
class CellPredicates {
 public:
  explicit CellPredicates(const CellVertices& vertices) : v_(&vertices) {}
  /// To be called when vertices have come.
  void see_vertices() { bounds_ = static_bounds(std::span<const LatticePoint>(v_->points)); }

  std::uint32_t size() const { return v_->size(); }
  double coordinate(std::uint32_t i, int axis) const { return v_->points[i][axis]; }
  int orient3d(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    for (std::uint32_t w = 0; w < v_->words; ++w)
      if ((v_->mask(a, w) & v_->mask(b, w) & v_->mask(c, w) & v_->mask(d, w)) != 0) return 0;
    return crossloft::orient3d(bounds_, v_->points[a], v_->points[b], v_->points[c], v_->points[d]);
  }
  int insphere(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d, std::uint32_t e) const {
    return crossloft::insphere(bounds_, v_->points[a], v_->points[b], v_->points[c], v_->points[d],
                               v_->points[e]);
  }
  LiftedRow lifted(std::uint32_t i, std::uint32_t origin) const {
    return lifted_row(v_->points[i], v_->points[origin]);
  }
  LiftedError lifted_error() const { return crossloft::lifted_error(bounds_); }
  bool collinear(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  /// Numbers are in lexicographic order but for points inside the cell.
  int compare_lex(std::uint32_t a, std::uint32_t b) const {
    if (std::max(v_->numbers[a], v_->numbers[b]) >= v_->first_interior)
      return crossloft::compare_lex(v_->points[a], v_->points[b]);
    return v_->numbers[a] < v_->numbers[b] ? -1 : v_->numbers[a] > v_->numbers[b] ? 1 : 0;
  }

 private:
  const CellVertices* v_;
  StaticBounds bounds_;
};

static_assert(PointPredicates3<CellPredicates> && LiftsPoints<CellPredicates>);

/// Vertices keep their local number when more are added; the triangulation depends on the set alone.
class CellTriangulation {
 public:
  /// REQUIRES: always as many faces as given here, in the same order.
  explicit CellTriangulation(std::size_t face_count) : predicates_(vertices_), delaunay_(predicates_) {
    vertices_.words = static_cast<std::uint32_t>((face_count + 63) / 64);
  }
  CellTriangulation(const CellTriangulation&) = delete;
  CellTriangulation& operator=(const CellTriangulation&) = delete;

  /// Inserts those vertices of the faces that are not in yet. `points` by number, which is lexicographic.
  /// Error internal: a self check failed.
  Result<Done> add(std::span<const CellFace> faces, std::span<const LatticePoint> points);
  /// Inserts points inside the cell. `numbers` in step and ascending, beyond those of all faces and of those
  /// that are in. Error as above.
  Result<Done> add_inside(std::span<const LatticePoint> points, std::span<const std::uint32_t> numbers);
  /// The vertices in get other numbers, in the same order: new_number[number]. REQUIRES: all are on faces.
  void renumber(std::span<const std::uint32_t> new_number);

  const CellVertices& vertices() const { return vertices_; }
  std::size_t inside_count() const { return inside_count_; }
  int dimension() const { return delaunay_.dimension(); }
  /// By local numbers: order of insertion; the vertices of the first add() are in order of their numbers.
  TetMesh mesh() const { return delaunay_.tet_mesh(); }
  /// Wall clock of all add() together.
  double seconds() const { return seconds_; }

 private:
  Result<Done> insert_from(std::uint32_t first);

  CellVertices vertices_;
  CellPredicates predicates_;
  Delaunay3<CellPredicates> delaunay_;
  double seconds_ = 0;
  std::size_t inside_count_ = 0;
};

/// True iff some face has an internal triangle; else no tetrahedron of the cell can be kept.
bool has_section(std::span<const CellFace> faces);
/// Number of components of the section in a face: internal triangles that hang together at vertices.
std::uint32_t section_components(const FaceTriangulation& face);
/// True iff some internal triangle is not covered.
bool is_somewhere_bare(std::span<const CellFace> faces);

}  // namespace crossloft
