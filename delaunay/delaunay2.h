#pragma once
/// Delaunay triangulation of points of one plane, incremental.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "delaunay_core.h"
#include "delaunay_verify.h"
#include "point_predicates.h"
#include "tri_mesh.h"

namespace crossloft {

/// As Delaunay3, in a plane: the result is a function of the point set and its ranks alone. Points that the
/// predicates object gains later are added one by one. 2^30 triangles or more are a failed
/// allocation.
template <PointPredicates2 P>
class Delaunay2 {
 public:
  using Edge = std::array<std::uint32_t, 2>;

  explicit Delaunay2(const P& predicates) : core_(predicates) {}

  /// Triangulates all points that are there. Call it once, before any insert().
  void build() { core_.build(); }
  /// Adds point i; returns i, or the vertex that it equals. `near` is a point to start the search from, for
  /// speed. Expected time: the length of the walk plus the triangles changed.
  std::uint32_t insert(std::uint32_t i, std::uint32_t near = kNone) { return core_.insert(i, near); }
  /// Edges that the last insert() removed, each once, in no particular order.
  const std::vector<Edge>& removed_edges() const { return core_.removed_ridges(); }

  /// Of the affine hull: -1 no points, 0 one point, 1 collinear, 2 otherwise. Below 2 there are no triangles
  /// yet; a later point may make them.
  int dimension() const { return core_.dimension(); }
  /// The vertex that stands for point i: i itself, or the lowest index (of build()) of an equal point. Found
  /// in dimension 2 only, i below.
  std::uint32_t kept(std::uint32_t i) const { return core_.kept(i); }
  /// True iff ab is an edge; in dimension 1, iff a and b are neighbours along the line. A point that equals
  /// another stands for its vertex. Takes the smaller of
  /// the two degrees, in dimension 1 linear time.
  bool has_edge(std::uint32_t a, std::uint32_t b) const;
  /// The finite triangles with their neighbours, in an order that depends on the order of insertion.
  TriMesh tri_mesh() const {
    TriMesh mesh;
    core_.finite(mesh.vertices, mesh.neighbours);
    return mesh;
  }
  /// Empty if sound, else the first broken invariant, as Delaunay3::verify().
  std::string verify() const { return detail::verify(core_); }
  const P& predicates() const { return core_.predicates(); }

 private:
  bool adjacent_on_line(std::uint32_t a, std::uint32_t b) const;

  detail::DelaunayCore<2, P> core_;
};

template <PointPredicates2 P>
bool Delaunay2<P>::has_edge(std::uint32_t a, std::uint32_t b) const {
  if (dimension() < 2) return adjacent_on_line(a, b);
  a = kept(a), b = kept(b);
  const auto& cells = core_.cells();
  // Round both ends in step, so that a spoke of a hub costs no more than its other end.
  detail::Facet at_a = core_.spoke(a), at_b = core_.spoke(b);
  const std::uint32_t first_a = at_a.cell(), first_b = at_b.cell();
  do {
    if (cells.ahead(at_a) == b || cells.ahead(at_b) == a) return true;
    at_a = cells.turn(at_a);
    at_b = cells.turn(at_b);
  } while (at_a.cell() != first_a && at_b.cell() != first_b);
  return false;
}

template <PointPredicates2 P>
bool Delaunay2<P>::adjacent_on_line(std::uint32_t a, std::uint32_t b) const {
  const P& p = predicates();
  const int way = p.compare_lex(a, b);
  return way != 0 && !core_.any_waiting([&](std::uint32_t c) {
    return p.compare_lex(a, c) == way && p.compare_lex(c, b) == way;
  });
}

}  // namespace crossloft
