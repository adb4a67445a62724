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
/// decides the structure. So arcs fit together: where three of them meet, they end at the same bits. But for
/// arcs with an end that no double holds, as where three sites are on a line within rounding: these are left
/// out, and those that they met end alone there.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "../delaunay/tet_mesh.h"
#include "../geom/lattice.h"
#include "diagram.h"
#include "face_frame.h"
#include "facet_cut.h"
#include "reach.h"
#include "tangent_spheres.h"
#include "voronoi_facet.h"

namespace crossloft {

/// A piece of a face's diagram, in the face's frame. Walked from `from` to `to`, the cell of sites[0] is on
/// the left.
struct FaceArc {
  std::array<std::uint32_t, 2> sites{};  ///< vertices of the cell, ascending
  MoebiusCurve curve;
  Vec2 from, to;                                    ///< equal on a whole circle; anything at an infinite end
  bool clockwise = false;                           ///< around the circle: iff sites[0] is the higher one
  bool over_half = false;                           ///< more than half of the circle, but not the whole
  bool whole = false;                               ///< the whole circle
  bool from_infinite = false, to_infinite = false;  ///< only on a line
};

/// Order by sites, then ends; within a face's diagram it is total.
bool before(const FaceArc& a, const FaceArc& b);

/// What the diagrams are made of; the spans must outlive the object that reads them.
struct CellSites {
  std::span<const LatticePoint> points;
  const TetMesh* mesh = nullptr;  ///< the Delaunay triangulation of the points
  std::span<const FaceFrame> faces;
  /// `words` per point; bit f of them iff the point is on the plane of face f.
  std::span<const std::uint64_t> on_faces;
  std::uint32_t words = 1;
  /// Per face, in its frame: arcs that miss the box may be left out, for speed; nothing is wanted of a face
  /// whose box has low > high. If there are none, all arcs are wanted.
  std::span<const Box2> regions;
};

/// Edge `edge` (kEdgeSlots) of tetrahedron `tet`, between the vertices i < j.
struct TetEdge {
  std::uint32_t tet;
  std::uint32_t edge;
  std::uint32_t i, j;
};

/// Reads off diagrams, 64 faces at a time: those of one word of CellSites::on_faces.
/// REQUIRES: all points on the planes or on the cell's sides of them.
class CellDiagrams {
 public:
  explicit CellDiagrams(const CellSites& sites, std::uint32_t word = 0);

  /// Appends the arcs between the pairs that are wanted: wanted(TetEdge) is the set of faces (bits of this
  /// word) whose arcs between i and j are asked for; it may be called for several tetrahedra around an edge
  /// and must answer the same. arcs[f] belongs to face 64 word + f. Sorted by sites, then ends: a function of
  /// the numbered points alone. Time: the tetrahedra, those around the edges that are wanted, the arcs.
  template <class Wanted>
  void arcs(Wanted&& wanted, std::span<std::vector<FaceArc>> arcs);

  /// Faces of the word.
  std::uint32_t face_count() const { return face_count_; }
  /// Faces of the word that the vertex is on.
  std::uint64_t on(std::uint32_t vertex) const {
    return sites_.on_faces[std::size_t{vertex} * sites_.words + word_] & all_;
  }
  /// REQUIRES: the vertex is not on the face, and something is wanted of the face.
  FaceSite site(std::uint32_t vertex, std::uint32_t face) const {
    return {frame(face).to_plane(sites_.points[vertex]), height(vertex, face)};
  }

 private:
  using Arcs = std::span<std::vector<FaceArc>>;
  /// How a side of the facet meets the surfaces: sets of faces.
  struct SideCut {
    std::uint64_t enters = 0, leaves = 0, dips = 0, inside = 0;
    std::optional<TriangleAxis> axis;  ///< when it has been needed
  };
  static constexpr std::uint8_t kKnown = 1 << 6;

  const FaceFrame& frame(std::uint32_t face) const { return sites_.faces[64 * std::size_t{word_} + face]; }
  const Box2& region(std::uint32_t face) const { return sites_.regions[64 * std::size_t{word_} + face]; }
  Vec3 point(std::uint32_t v) const { return real(sites_.points[v]); }
  double height(std::uint32_t v, std::uint32_t face) const {
    return heights_[std::size_t{v} * face_count_ + face];
  }

  void measure_heights(std::uint32_t face);
  void find_near(std::uint32_t face);
  std::uint64_t inside(std::uint32_t tet);
  std::uint64_t inside_of(std::uint32_t tet) const;
  std::uint64_t may_have_arcs(const TetEdge& edge, std::uint64_t faces);
  std::uint64_t within_reach(const TetEdge& edge, std::uint64_t faces) const;
  void edge_arcs(const TetEdge& edge, std::uint64_t faces, Arcs arcs);
  void cut_sides(std::uint64_t faces);
  std::uint64_t straight_up(const VoronoiSide& side, int way, std::uint64_t faces) const;
  std::uint64_t highest(std::uint64_t faces) const;
  std::uint64_t dips(std::size_t side, std::uint64_t faces);
  const TriangleAxis& axis(std::size_t side);
  void face_arcs(std::uint32_t face, std::vector<FaceArc>& arcs);
  bool facet_holds(const FaceSite& i, Vec2 at, std::uint32_t face, double margin) const;
  bool is_over_half(const FaceArc& arc, std::span<const FaceArc> of_facet, std::uint32_t face) const;
  void whole_circle(std::uint32_t face, std::vector<FaceArc>& arcs) const;
  Vec2 crossing(const FacetCrossing& at, std::uint32_t face);

  CellSites sites_;
  std::uint32_t word_ = 0, face_count_ = 0;
  std::uint64_t all_ = 0, wanted_ = 0;  ///< faces of the word, those that something is wanted of
  std::vector<Disk> disks_;             ///< of the faces, around their regions; or none
  // Per point, its height over each face (face_count_ numbers), and the faces over which it may be nearest.
  std::vector<double> heights_;
  std::vector<std::uint64_t> near_;
  // Per tetrahedron, the faces whose surface its Voronoi vertex is inside of, and its edges that are done.
  std::vector<std::uint64_t> inside_;
  std::vector<std::uint8_t> state_;
  // Of the facet at hand:
  VoronoiFacet facet_;
  std::vector<SideCut> cuts_;  ///< of the sides, and of the gap at infinity
  std::vector<Passage> passages_;
  std::vector<FacetArc> pieces_;
};

template <class Wanted>
void CellDiagrams::arcs(Wanted&& wanted, std::span<std::vector<FaceArc>> arcs) {
  for (std::uint8_t& state : state_) state &= kKnown;
  for (std::uint32_t t = 0; t < sites_.mesh->size(); ++t) {
    const auto& v = sites_.mesh->vertices[t];
    const std::array near{near_[v[0]], near_[v[1]], near_[v[2]], near_[v[3]]};
    for (std::uint32_t e = 0; e < kEdgeSlots.size(); ++e) {
      const auto [a, b] = kEdgeSlots[e];
      std::uint64_t faces = near[a] & near[b];
      if (faces == 0 || (state_[t] >> e & 1) != 0) continue;
      const TetEdge edge{t, e, std::min(v[a], v[b]), std::max(v[a], v[b])};
      faces &= wanted(edge);
      if (faces != 0) faces = may_have_arcs(edge, faces);
      if (faces != 0) edge_arcs(edge, faces, arcs);
    }
  }
  for (std::vector<FaceArc>& list : arcs) std::sort(list.begin(), list.end(), before);
}

}  // namespace crossloft
