#pragma once
/// Samples of the branching and cutting diagrams of one cell (paper, section 2): points inside sections where
/// the reconstruction changes over from one neighbour to another.

#include <cstdint>
#include <span>
#include <vector>

#include "../arrangement/section_graph.h"
#include "../moebius/face_diagram.h"
#include "branching_options.h"
#include "cell_triangulation.h"

namespace crossloft {

/// What the diagram of one face, seen from one of its two cells, has given.
struct FaceBranching {
  FaceId face;
  std::size_t side = 0;       ///< 0: seen from the cell on the negative side of the plane, 1: positive
  FaceFrame frame;            ///< plane coordinates of the arcs
  std::vector<FaceArc> arcs;  ///< those that samples were looked for on
  std::vector<Vec2> sites;    ///< feet of the vertices that the arcs are between
  std::vector<LatticePoint> samples;  ///< strictly inside the face and its section
  std::vector<double> apart;  ///< in step: the least distance from samples of the other side, lattice units
};

struct CellBranching {
  std::vector<FaceBranching> faces;  ///< those with arcs
  double seconds = 0;                ///< of the diagrams and samples, without the triangulation
};

/// Works out the samples of one cell. References must outlive it.
class BranchingCell {
 public:
  /// `ids` and `faces` in step: the faces of the cell that are not on the box. `points` by number.
  BranchingCell(const SectionGraph& graph, const Arrangement& arrangement, const PlaneLocators& locators,
                std::span<const FaceId> ids, std::span<const CellFace> faces,
                std::span<const LatticePoint> points, const BranchingOptions& options);

  /// False if no diagram of the cell can have a sample: there must be a section, in mode automatic three
  /// components.
  bool may_branch() const;
  /// Takes in what of the sections is covered, on both sides: the calls below rest on it. REQUIRES: no cell
  /// is being pruned meanwhile.
  void find_bare();
  /// Samples are wanted over the holes of sections, too.
  void find_holes();
  /// Where only cells that lack something are looked at: whether the cell, pruned without samples, leaves a
  /// section component bare, or a part of one that is bare on its other side too, or has holes that samples
  /// are wanted over. Else true.
  bool lacks_something() const;
  /// `draw_all`: also arcs on which, in mode automatic, no sample can be of use. REQUIRES: `triangulation`
  /// holds the vertices of the faces and has tetrahedra.
  CellBranching run(const CellTriangulation& triangulation, bool draw_all) const;

 private:
  class Sampler;
  void label_vertices();
  /// Whether a section component on the face is bare, or flat somewhere.
  bool lacks_on(std::size_t face) const;
  /// Component of an internal triangle.
  std::uint32_t label_of(std::size_t face, std::size_t triangle) const {
    return labels_[local_[face][faces_[face].triangulation->triangles[triangle][0]]];
  }

  const SectionGraph& graph_;
  const Arrangement& arrangement_;
  const PlaneLocators& locators_;
  std::span<const FaceId> ids_;
  std::span<const CellFace> faces_;
  std::span<const LatticePoint> points_;
  BranchingOptions options_;
  std::vector<std::uint32_t> numbers_;             ///< of the cell's vertices, ascending
  std::vector<std::vector<std::uint32_t>> local_;  ///< by face and its local vertex: position in numbers_
  std::vector<std::uint32_t>
      labels_;  ///< in step: section component, kNone for a vertex of no internal triangle
  std::vector<std::uint8_t> bare_;  ///< by component: no triangle of it is covered in this cell
  std::vector<std::uint8_t> flat_;  ///< by component: a triangle of it is covered in neither of its cells
  std::uint32_t components_ = 0;
  std::vector<std::array<std::uint32_t, 2>> hole_edges_;  ///< positions in numbers_, sorted
};

/// Appends the samples of one side of a face to `all`, those of its other side or none. Where the two
/// diagrams (nearly) coincide one sample serves both; two would be the ends of needles. O(product of both
/// numbers).
void merge_samples(const FaceBranching& side, std::vector<LatticePoint>& all);

}  // namespace crossloft
