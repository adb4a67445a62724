#pragma once
/// The arrangement of planes inside an axis box: vertices, edges, faces and cells with all incidences.
///
/// Exact and dual: a vertex is known by its planes, a cell by its sign vector. Nothing is in general
/// position: parallel planes, pencils, many planes through one point and planes that miss the box are legal.
/// All elements are convex; no vertex lies inside an edge, and three consecutive vertices of a face are never
/// collinear.
///
/// Planes are numbered 0..k-1 as given, then the six of the box: k + 2 axis is { x_axis = lower }, k + 2 axis
/// + 1 is { x_axis = upper }, both with the normal +e_axis. Sign vectors run over the k given planes only.
///
/// Numbering is canonical: vertices by exact coordinates (compare_lex), edges by their ends, faces by their
/// three lowest vertices, cells by their two lowest faces (two cells share at most one). It depends on the
/// set of planes, not on their order or orientation. All lists are sorted ascending unless said otherwise.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "../geom/context.h"
#include "../geom/ids.h"
#include "../geom/lattice.h"
#include "../geom/result.h"
#include "sign_vector.h"

namespace crossloft {

using ArrVertexId = Id<struct ArrVertexTag>;  ///< a vertex of the arrangement
using ArrEdgeId = Id<struct ArrEdgeTag>;      ///< an edge of the arrangement

/// { lower <= x <= upper } per axis, in lattice units; lower < upper and |bounds| <= 2^49.
struct LatticeBox {
  LatticeVector lower{}, upper{};
};
/// { |x_axis| <= bound }.
LatticeBox centred_box(std::int64_t bound);

/// The element of an arrangement that contains a point. dimension 0: vertex, 1: edge, 2: face, 3: cell;
/// index kNone (dimension 3) where there is none: outside the box or on its boundary.
struct Location {
  std::uint8_t dimension = 3;
  std::uint32_t index = kNone;

  bool found() const { return index != kNone; }
  friend bool operator==(const Location&, const Location&) = default;
};

/// Lists of `Item`, one per `Key`, in two flat arrays.
template <class Key, class Item>
struct Incidence {
  std::vector<std::uint32_t> begin;  ///< of each list in items; one more entry at the end
  std::vector<Item> items;

  std::span<const Item> of(Key key) const {
    return {items.data() + begin[key.value], begin[key.value + 1] - begin[key.value]};
  }
};

class Arrangement {
 public:
  /// k, the planes given; the ids k..k+5 are the box.
  std::uint32_t plane_count() const { return plane_count_; }
  const LatticePlane& plane(PlaneId p) const { return planes_[p.value]; }
  bool is_box(PlaneId p) const { return p.value >= plane_count_; }
  const LatticeBox& box() const { return box_; }

  std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(points_.size()); }
  std::uint32_t edge_count() const { return static_cast<std::uint32_t>(ends_.size()); }
  std::uint32_t face_count() const { return static_cast<std::uint32_t>(face_planes_.size()); }
  std::uint32_t cell_count() const { return static_cast<std::uint32_t>(cell_faces_.begin.size()) - 1; }

  /// Exact coordinates; owned by the store given to build_arrangement.
  const LatticePoint& point(ArrVertexId v) const { return points_[v.value]; }

  /// The lower end first.
  std::array<ArrVertexId, 2> ends(ArrEdgeId e) const { return ends_[e.value]; }
  /// Two planes whose intersection is the edge's line, lowest ids first; there may be more (see signs).
  std::array<PlaneId, 2> planes_of(ArrEdgeId e) const { return edge_planes_[e.value]; }

  /// The plane of the face; for a face of the box the box plane, even where a given plane coincides with it.
  PlaneId plane_of(FaceId f) const { return face_planes_[f.value]; }
  /// The boundary, counter-clockwise seen from the side the plane's normal points to, lowest vertex first.
  std::span<const ArrVertexId> vertices_of(FaceId f) const { return face_vertices_.of(f); }
  /// In step with vertices_of: edge i joins vertex i to vertex i + 1.
  std::span<const ArrEdgeId> edges_of(FaceId f) const { return face_edges_.of(f); }
  /// The cells on the negative and on the positive side of plane_of(f); invalid outside the box.
  std::array<CellId, 2> cells_of(FaceId f) const { return face_cells_[f.value]; }

  std::span<const FaceId> faces_of(CellId c) const { return cell_faces_.of(c); }
  std::span<const ArrEdgeId> edges_of(CellId c) const { return cell_edges_.of(c); }
  std::span<const ArrVertexId> vertices_of(CellId c) const { return cell_vertices_.of(c); }

  std::span<const ArrEdgeId> edges_around(ArrVertexId v) const { return vertex_edges_.of(v); }
  std::span<const FaceId> faces_around(ArrVertexId v) const { return vertex_faces_.of(v); }
  std::span<const CellId> cells_around(ArrVertexId v) const { return vertex_cells_.of(v); }
  std::span<const FaceId> faces_around(ArrEdgeId e) const { return edge_faces_.of(e); }
  std::span<const CellId> cells_around(ArrEdgeId e) const { return edge_cells_.of(e); }

  /// Bit j set: the element lies on the box plane k + j.
  std::uint8_t box_mask(ArrVertexId v) const { return vertex_box_[v.value]; }
  bool on_box(ArrVertexId v) const { return box_mask(v) != 0; }
  bool on_box(ArrEdgeId e) const { return (box_mask(ends(e)[0]) & box_mask(ends(e)[1])) != 0; }
  bool on_box(FaceId f) const { return is_box(plane_of(f)); }

  /// The sign vector of the open element over the k planes. The zero row holds all planes through it.
  SignView signs(ArrVertexId v) const { return row(v.value); }
  SignView signs(ArrEdgeId e) const { return row(first_edge_row() + e.value); }
  SignView signs(FaceId f) const { return row(first_face_row() + f.value); }
  SignView signs(CellId c) const { return row(first_cell_row() + c.value); }
  /// Words of each row.
  std::size_t words() const { return words_; }

  /// The element with this sign vector that is not on the box: unique, since all points of one sign vector
  /// form one convex set. The given rows must be those of a point inside the open box. O(words) expected.
  Location locate(SignView signs) const;
  /// The same for a point strictly inside the box, by its k side tests.
  Location locate(const LatticePoint& p) const;

  /// Checks everything that the class promises, with signs recomputed from the exact coordinates and planes;
  /// returns the first violation, empty if there is none. O(k vertices + sum of all lists).
  std::string verify() const;

 private:
  friend class ArrangementAssembly;

  std::uint32_t first_edge_row() const { return vertex_count(); }
  std::uint32_t first_face_row() const { return vertex_count() + edge_count(); }
  std::uint32_t first_cell_row() const { return first_face_row() + face_count(); }
  SignView row(std::uint32_t r) const {
    return {{pos_.data() + r * words_, words_}, {zero_.data() + r * words_, words_}};
  }

  std::uint32_t plane_count_ = 0;
  std::size_t words_ = 1;
  LatticeBox box_;
  std::vector<LatticePlane> planes_;  ///< k given, then the box

  std::vector<LatticePoint> points_;
  std::vector<std::uint8_t> vertex_box_;
  std::vector<std::array<ArrVertexId, 2>> ends_;
  std::vector<std::array<PlaneId, 2>> edge_planes_;
  std::vector<PlaneId> face_planes_;
  std::vector<std::array<CellId, 2>> face_cells_;
  Incidence<FaceId, ArrVertexId> face_vertices_;
  Incidence<FaceId, ArrEdgeId> face_edges_;
  Incidence<CellId, FaceId> cell_faces_;
  Incidence<CellId, ArrEdgeId> cell_edges_;
  Incidence<CellId, ArrVertexId> cell_vertices_;
  Incidence<ArrVertexId, ArrEdgeId> vertex_edges_;
  Incidence<ArrVertexId, FaceId> vertex_faces_;
  Incidence<ArrVertexId, CellId> vertex_cells_;
  Incidence<ArrEdgeId, FaceId> edge_faces_;
  Incidence<ArrEdgeId, CellId> edge_cells_;

  std::vector<SignWord> pos_, zero_;     ///< rows of all vertices, edges, faces, cells in this order
  std::vector<std::uint32_t> by_signs_;  ///< open addressing over the rows of elements not on the box
};

/// The arrangement of `planes` inside `box`. New points go to `store`, which must outlive the result.
/// REQUIRES: planes distinct as point sets; box as said there.
/// Errors: cancelled; usage for an empty box; too_large (over 2^30 pairs of a face and its edge, or a box
/// beyond its limit).
/// Planes are inserted one by one in a canonical order. O(1) work a new cell on average, and one side test
/// for every vertex and inserted plane: k planes in general position make O(k^3) elements in O(k^4) such
/// tests.
Result<Arrangement> build_arrangement(std::span<const LatticePlane> planes, const LatticeBox& box,
                                      LatticePointStore& store, const Context& context = {});

}  // namespace crossloft
