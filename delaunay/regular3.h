#pragma once
/// Regular (power) triangulation of sites in space, of any dimension that they span.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "delaunay_core.h"
#include "delaunay_verify.h"
#include "lower_chain.h"
#include "point_predicates.h"
#include "power_projection.h"
#include "tet_mesh.h"
#include "tri_mesh.h"

namespace crossloft {

/// The lower hull of the lifted sites of `P`, seen from below: for heights |x|^2 - w the dual of the power
/// diagram, for equal weights the Delaunay triangulation. Ties are broken as there, by heights + eps^rank,
/// rank counted from the lexicographically largest position down (perturbation.h): a function of the set of
/// sites alone.
///
/// A site above the lower hull is *hidden*: it is no vertex. One exactly on the hull is a vertex: it lies
/// between others, one of which is raised by far more. Of sites of equal position the lowest counts, of equal
/// height too the one of lowest index.
///
///     WeightedPredicates3 predicates(points);
///     Regular3 triangulation(predicates);
///     triangulation.build();
///     if (triangulation.dimension() == 3) TetMesh mesh = triangulation.tet_mesh();
///
/// Expected time O(n log n) plus the tetrahedra made; 33 bytes a tetrahedron, 8 a site. 2^30
/// tetrahedra or more, hull facets included, are a failed allocation. One object is used by one thread; `P`
/// must outlive it. Source: Edelsbrunner and Shah, Incremental topological flipping works for regular
/// triangulations (1996), for hidden sites and the walk; the insertion itself is that of delaunay_core.h.
template <PowerPredicates3 P>
class Regular3 {
 public:
  explicit Regular3(const P& predicates) : predicates_(predicates), space_(predicates) {}
  Regular3(const Regular3&) = delete;  // its parts refer to each other
  Regular3& operator=(const Regular3&) = delete;

  /// Triangulates all sites. Call it once, or the next.
  void build() {
    space_.build();
    build_lower_dimension();
  }
  /// As build(), faster if the sites are stored in insertion_order, possibly very slow if not.
  void build_in_given_order() {
    space_.build_in_given_order();
    build_lower_dimension();
  }
  /// Of the affine hull of the positions: -1 no sites, 0 all in one place, 1 collinear, 2 coplanar, 3
  /// otherwise.
  int dimension() const { return space_.dimension(); }
  /// The vertex that stands for site i: i itself, or the lowest index of its equals; kNone if i is hidden.
  std::uint32_t kept(std::uint32_t i) const;
  bool is_vertex(std::uint32_t i) const { return kept(i) == i; }

  /// Dimension 3: the finite tetrahedra, orient3d > 0, in an order that depends on the order of the sites.
  /// Otherwise empty.
  TetMesh tet_mesh() const;
  /// The same without a copy; afterwards only kept() and the dimension may be asked.
  TetMesh release_tet_mesh();
  /// Dimension 2: the triangles, orient2d(a, b, c, dropped_axis()) > 0. Otherwise empty.
  TriMesh tri_mesh() const;
  /// Dimension 2: the axis along which the plane of the sites is projected. Otherwise -1.
  int dropped_axis() const { return plane_ ? plane_->dropped_axis() : -1; }
  /// Dimension 1 or 0: the vertices in lexicographic order, each joined to the next. Otherwise empty.
  const std::vector<std::uint32_t>& chain() const { return chain_; }

  /// Empty if sound, else the first broken invariant: those of Delaunay3::verify(), and hidden sites are
  /// above the hull. Expected time O(n log n).
  std::string verify() const;

 private:
  void build_lower_dimension();

  const P& predicates_;
  detail::DelaunayCore<3, P> space_;
  std::optional<detail::PowerProjection<P>> plane_;  ///< dimension 2
  std::optional<detail::DelaunayCore<2, detail::PowerProjection<P>>> flat_;
  std::vector<std::uint32_t> chain_;       ///< dimension 1 and 0
  std::vector<std::uint32_t> chain_kept_;  ///< kept() there
};

template <PowerPredicates3 P>
void Regular3<P>::build_lower_dimension() {
  if (dimension() == 2) {
    const auto& b = space_.basis();
    int drop = 0;
    while (predicates_.orient2d(b[0], b[1], b[2], drop) == 0) ++drop;
    plane_.emplace(predicates_, drop);
    flat_.emplace(*plane_);
    flat_->build();
  } else if (dimension() < 2) {
    chain_ = detail::lower_chain(predicates_, chain_kept_);
  }
}

template <PowerPredicates3 P>
std::uint32_t Regular3<P>::kept(std::uint32_t i) const {
  if (dimension() == 3) return space_.kept(i);
  return dimension() == 2 ? flat_->kept(i) : chain_kept_[i];
}

template <PowerPredicates3 P>
TetMesh Regular3<P>::tet_mesh() const {
  TetMesh mesh;
  space_.finite(mesh.vertices, mesh.neighbours);
  return mesh;
}

template <PowerPredicates3 P>
TetMesh Regular3<P>::release_tet_mesh() {
  TetMesh mesh;
  space_.release(mesh.vertices, mesh.neighbours);
  return mesh;
}

template <PowerPredicates3 P>
TriMesh Regular3<P>::tri_mesh() const {
  TriMesh mesh;
  if (flat_) flat_->finite(mesh.vertices, mesh.neighbours);
  return mesh;
}

template <PowerPredicates3 P>
std::string Regular3<P>::verify() const {
  if (dimension() == 3) return detail::verify(space_);
  if (dimension() == 2) return detail::verify(*flat_);
  return detail::verify_chain(predicates_, chain_, chain_kept_);
}

}  // namespace crossloft
