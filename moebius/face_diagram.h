#pragma once
/// The Moebius diagrams of all faces of a convex cell, read off the Delaunay triangulation of its section
/// vertices.
///
/// For a point a of a face, the sites are the section vertices off the face's plane, and the nearest is the
/// one on the smallest sphere that is tangent to the plane at a. The site with foot p and height h is the
/// Moebius site (p, lambda = 1/h, mu = -h). *Why the triangulation knows them all*: the centre of the
/// smallest sphere lies in the Voronoi cell of its site, as far from the plane as from the site. So the arcs
/// of a face are the facets of the Voronoi diagram cut by the surface { c : height of c = distance of c to
/// its nearest site }, projected on the plane; the Voronoi diagram is one for all faces. Source: Boissonnat,
/// Memari, Shape reconstruction from unorganized cross-sections (2007), for the diagrams.
///
/// A Voronoi vertex is inside the surface or not; that one bit per tetrahedron and face, rounded or not,
/// decides the structure. So arcs always fit together: where three of them meet, they end at the same bits.

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "../delaunay/tet_mesh.h"
#include "../geom/lattice.h"
#include "diagram.h"
#include "face_frame.h"

namespace crossloft {

/// A piece of a face's diagram, in the face's frame. Walked from `from` to `to`, the cell of sites[0] is on
/// the left; on a circle that is counter-clockwise iff sites[0] is the lower one.
struct FaceArc {
  std::array<std::uint32_t, 2> sites{};  ///< vertices of the cell
  MoebiusCurve curve;
  Vec2 from, to;                                    ///< equal on a whole circle; anything at an infinite end
  bool whole = false;                               ///< the whole circle
  bool from_infinite = false, to_infinite = false;  ///< only on a line
};

/// The curve of equal tangent spheres of i and j, its line directed with i on the left. REQUIRES: the sites
/// differ.
MoebiusCurve tangent_curve(const FaceSite& i, const FaceSite& j);

/// What the diagrams are made of; the spans must outlive the object that reads them.
struct CellSites {
  std::span<const LatticePoint> points;
  const TetMesh* mesh = nullptr;  ///< the Delaunay triangulation of the points
  std::span<const FaceFrame> faces;
  std::span<const std::uint64_t>
      on_faces;  ///< `words` per point; bit f of them iff the point is on the plane of face f
  std::uint32_t words = 1;
};

/// Reads off diagrams, 64 faces at a time: those of one word of CellSites::on_faces.
/// REQUIRES: all points on the planes or on the cells' sides of them.
class CellDiagrams {
 public:
  /// O(tetrahedra): decides for each which faces its Voronoi vertex is inside of.
  CellDiagrams(const CellSites& sites, std::uint32_t word = 0);

  /// Appends the arcs between the pairs that are wanted: wanted(a, b), a < b, is the set of faces (bits of
  /// this word) whose arcs between a and b are asked for; it may be called several times for a pair and must
  /// answer the same. arcs[f] belongs to face 64 word + f. Sorted by sites, then ends: a function of the
  /// numbered points alone. Time: the tetrahedra, plus those around the edges that are wanted, plus the arcs.
  template <class Wanted>
  void arcs(Wanted&& wanted, std::span<std::vector<FaceArc>> arcs);

  FaceSite site(std::uint32_t vertex, std::uint32_t face) const {
    return {frame(face).to_plane(sites_.points[vertex]), height(vertex, face)};
  }

 private:
  const FaceFrame& frame(std::uint32_t face) const { return sites_.faces[64 * std::size_t{word_} + face]; }
  double height(std::uint32_t v, std::uint32_t face) const {
    return heights_[std::size_t{v} * face_count_ + face];
  }

  CellSites sites_;
  std::uint32_t word_ = 0, face_count_ = 0;
  std::vector<double> heights_;  ///< face_count_ per point
};

}  // namespace crossloft
