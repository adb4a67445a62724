#pragma once
/// Splitting a contour edge of a face at a lattice point, for conforming edge recovery.

#include <span>
#include <vector>

#include "../arrangement/section_graph.h"
#include "../delaunay/conform.h"
#include "../geom/box_tree.h"
#include "open_face.h"

namespace crossloft {

/// Makes lattice points near contour edges: on the edge or on its outer side (one on the inner side would
/// make an external sliver of the section), strictly inside the face, with no other vertex between it and the
/// edge. O(log^2 n) for each, amortised, and what is in the box of the edge.
class FaceSplitter {
 public:
  /// `points` grows by the splits; `walls` are the segments in the order given to conform().
  FaceSplitter(const SectionGraph& graph, const Arrangement& arrangement, FaceId face, std::uint32_t plane,
               std::span<const Wall> walls, std::vector<LatticePoint>& points);

  std::uint32_t operator()(const SplitRequest& request);

 private:
  /// Of points in a row.
  struct Grove {
    std::uint32_t begin, end;
    BoxTree tree;
  };

  void plant();
  template <class Visit>
  void for_points_in(const Bounds& box, Visit&& visit) const;
  bool sweeps_nothing(std::uint32_t a, std::uint32_t b, const LatticePoint& c) const;

  LatticePlane plane_;
  OpenFace face_;
  std::span<const Wall> walls_;
  std::vector<LatticePoint>* points_;
  std::vector<Grove> groves_;  ///< of all points but the last few, each more than the next one
};

}  // namespace crossloft
