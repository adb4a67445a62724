#pragma once
/// Delaunay triangulation of points in space.

#include <array>
#include <cstdint>
#include <string>

#include "delaunay_core.h"
#include "delaunay_verify.h"
#include "point_predicates.h"
#include "tet_mesh.h"

namespace crossloft {

/// The Delaunay triangulation of the points of `P`, ties broken by lifting each point to |x|^2 + eps^rank,
/// rank counted from the lexicographically largest point down (perturbation.h). So it is a function of the
/// point set alone: neither the order of the points nor their indices matter. Points are never moved:
/// orient3d = 0 stays 0 and no flat tetrahedron exists.
///
///     LatticePredicates3 predicates{points};
///     Delaunay3 triangulation(predicates);
///     triangulation.build();
///     if (triangulation.dimension() == 3) TetMesh mesh = triangulation.tet_mesh();
///
/// Expected time O(n log n) plus the tetrahedra made; 33 bytes a tetrahedron. 2^30 tetrahedra or more, hull
/// facets included, are a failed allocation. One object is used by one thread; `P` must outlive it.
template <PointPredicates3 P>
class Delaunay3 {
 public:
  explicit Delaunay3(const P& predicates) : core_(predicates) {}

  /// Triangulates all points. Call it once.
  void build() { core_.build(); }
  /// As build(), faster if the points are stored in insertion_order, possibly very slow if not. With several
  /// threads the same tetrahedra, in another order.
  void build_in_given_order(unsigned threads = 1) { core_.build_in_given_order(threads); }
  /// Adds the points that the predicates object gained: those from `first` on. The result is that of build()
  /// on all points. REQUIRES: the points before `first` are in.
  void extend(std::uint32_t first) { core_.build(first); }
  /// Of the affine hull: -1 no points, 0 one point, 1 collinear, 2 coplanar, 3 otherwise. Below 3 there are
  /// no tetrahedra, which is no error.
  int dimension() const { return core_.dimension(); }
  /// The lowest index of a point equal to point i; that one is the vertex. Found in dimension 3 only, i
  /// below.
  std::uint32_t kept(std::uint32_t i) const { return core_.kept(i); }
  /// The finite tetrahedra with their neighbours, in an order that depends on the order of the points.
  TetMesh tet_mesh() const {
    TetMesh mesh;
    core_.finite(mesh.vertices, mesh.neighbours);
    return mesh;
  }
  /// The same without a copy; afterwards only kept() and the dimension may be asked.
  TetMesh release_tet_mesh(unsigned threads = 1) {
    TetMesh mesh;
    core_.release(mesh.vertices, mesh.neighbours, threads);
    return mesh;
  }
  /// Empty if sound, else the first broken invariant: symmetric neighbours, positive orientation, ghosts in
  /// their slot, every facet locally Delaunay (perturbed), every point a vertex. Linear time.
  std::string verify() const { return detail::verify(core_); }

 private:
  detail::DelaunayCore<3, P> core_;
};

}  // namespace crossloft
