#pragma once
/// The cell complex of an arrangement while planes are inserted one by one. Used by build_arrangement only.
///
/// Elements are 32-bit indices into flat arrays and never move or die: a split keeps the old index for one
/// part and appends the other. A face's boundary is a ring of uses; the uses of one edge form a list, and so
/// do the sides of faces that bound one cell. A split therefore only relinks and touches nothing of its
/// neighbours.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "../geom/lattice.h"
#include "complex.h"

namespace crossloft {

class GrowingComplex {
 public:
  struct Edge {
    std::array<std::uint32_t, 2> ends;
    std::array<std::uint32_t, 2> planes;  ///< whose meet is the edge's line
    std::uint32_t first_use = kNone;
  };
  /// One face along one of its edges, from `vertex` to the vertex of `next`.
  struct Use {
    std::uint32_t vertex, edge, face;
    std::uint32_t next;          ///< counter-clockwise seen from the positive side of the face's plane
    std::uint32_t next_of_edge;  ///< another face's use of the same edge
  };
  struct Face {
    std::uint32_t plane;
    std::uint32_t first_use;
    std::array<std::uint32_t, 2> cells;         ///< negative and positive side, kNone outside the box
    std::array<std::uint32_t, 2> next_of_cell;  ///< next face side (2 face + side) of the same cell
  };

  /// The box alone: one cell. `planes` are the k given ones followed by the six of the box.
  GrowingComplex(std::span<const LatticePlane> planes, const LatticeBox& box, LatticePointStore& store);

  /// Splits all that plane `p` < k crosses and tags all that lies on it. False if an index would overflow or
  /// a meet does not exist, which needs planes out of their range.
  bool insert(std::uint32_t p);

  std::size_t words() const { return words_; }
  const std::vector<LatticePoint>& points() const { return points_; }
  const std::vector<std::uint8_t>& boxes() const { return boxes_; }  ///< bit j: on box plane k + j
  const std::vector<SignWord>& pos() const { return pos_; }          ///< words() a vertex
  const std::vector<SignWord>& zero() const { return zero_; }
  const std::vector<Edge>& edges() const { return edges_; }
  const std::vector<Use>& uses() const { return uses_; }
  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<std::uint32_t>& cells() const { return cells_; }  ///< first face side of each

 private:
  void seed_edges(const LatticeBox& box);
  void seed_faces();
  std::uint32_t add_vertex(const LatticePoint& point, std::uint8_t box);
  std::uint32_t add_edge(std::uint32_t a, std::uint32_t b, std::array<std::uint32_t, 2> planes);
  std::uint32_t add_face(std::uint32_t plane);
  std::uint32_t add_cell();
  std::uint32_t add_use(std::uint32_t vertex, std::uint32_t edge, std::uint32_t face);
  void add_side(std::uint32_t cell, std::uint32_t face, std::uint32_t side);

  void sign_vertices();
  bool split_edges();
  bool split_edge(std::uint32_t e);
  void split_uses(std::uint32_t e, std::uint32_t tail, std::uint32_t middle);
  void set_edge(std::uint32_t use, std::uint32_t edge);
  void touch_faces_of(std::uint32_t e);
  void split_faces();
  void split_face(std::uint32_t f, std::uint32_t leaving, std::uint32_t entering);
  void touch_cells_of(std::uint32_t f);
  void split_cells();
  void split_cell(std::uint32_t c);
  void link_polygon(std::uint32_t side, std::uint32_t& start);
  void add_polygon(std::uint32_t start, std::uint32_t negative, std::uint32_t positive);
  int face_sign(std::uint32_t f) const;
  std::uint32_t next_side(std::uint32_t side) const { return faces_[side / 2].next_of_cell[side % 2]; }

  std::span<const LatticePlane> planes_;
  LatticePointStore& store_;
  std::size_t words_;

  std::vector<LatticePoint> points_;
  std::vector<std::uint8_t> boxes_;
  std::vector<SignWord> pos_, zero_;
  std::vector<Edge> edges_;
  std::vector<Use> uses_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> cells_;

  // State of one insertion.
  std::uint32_t plane_ = 0;
  std::vector<std::int8_t> signs_;  ///< of every vertex against plane_
  std::vector<std::uint32_t> touched_faces_, touched_cells_;
  std::vector<std::uint32_t> face_stamps_, cell_stamps_;  ///< last plane that touched
  struct Step {
    std::uint32_t vertex = kNone, edge = kNone;
  };
  std::vector<Step> polygon_;  ///< by vertex: the way on along the polygon of one cell
};

}  // namespace crossloft
