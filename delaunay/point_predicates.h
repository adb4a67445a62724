#pragma once
/// What a triangulation knows of its points: exact signs by index, nothing else.
///
/// A predicates object is the seam between the triangulation and the world: it may answer from tags ("four
/// points share a plane, so orient3d is 0"), from filters, or from any exact arithmetic. All signs are exact,
/// raw (0 is a legal answer, the triangulation breaks ties itself) and must not change while it is in use.

#include <concepts>
#include <cstdint>

#include "../geom/lifted_row.h"

namespace crossloft {

/// Points 0..size()-1 in space. Conventions of geom/lattice.h:
/// - coordinate(i, axis): rounded, equal for equal points; used for ordering only, decides nothing;
/// - orient3d(a, b, c, d): sign of det(b-a, c-a, d-a);
/// - insphere(a, b, c, d, e): +1 if e is inside the sphere of a, b, c, d when orient3d(a, b, c, d) > 0;
/// - collinear(a, b, c): true iff the three points lie on one line; asked only until the first tetrahedron;
/// - compare_lex(a, b): sign of the exact lexicographic order, 0 iff the points are equal.
template <class P>
concept PointPredicates3 = requires(const P& p, std::uint32_t i, int axis) {
  { p.size() } -> std::convertible_to<std::uint32_t>;
  { p.coordinate(i, axis) } -> std::convertible_to<double>;
  { p.orient3d(i, i, i, i) } -> std::same_as<int>;
  { p.insphere(i, i, i, i, i) } -> std::same_as<int>;
  { p.collinear(i, i, i) } -> std::same_as<bool>;
  { p.compare_lex(i, i) } -> std::same_as<int>;
};

/// Points 0..size()-1 of one oriented plane; the object may grow while a triangulation uses it.
/// - coordinate(i, axis): rounded coordinates, axis 0 or 1, in any affine frame of the plane: ordering only;
/// - orient2d(a, b, c): +1 if counter-clockwise;
/// - incircle(a, b, c, d): +1 if d is inside the circle of a, b, c when orient2d(a, b, c) > 0;
/// - compare_lex(a, b): the rank of the perturbation, 0 iff the points are equal. For a plane in space this
///   is the lexicographic order in space: then the triangulation equals the hull facets on that plane of
///   every Delaunay triangulation in space.
template <class P>
concept PointPredicates2 = requires(const P& p, std::uint32_t i, int axis) {
  { p.size() } -> std::convertible_to<std::uint32_t>;
  { p.coordinate(i, axis) } -> std::convertible_to<double>;
  { p.orient2d(i, i, i) } -> std::same_as<int>;
  { p.incircle(i, i, i, i) } -> std::same_as<int>;
  { p.compare_lex(i, i) } -> std::same_as<int>;
};

/// Sites 0..size()-1 in space, each a position and a height: what the lower hull of the lifted sites
/// (position, height) is made from. For weighted points the height is |x|^2 - w; nothing here assumes so: any
/// rows (X, Y, Z, H) will do, as those of a diagram whose sites became linear functions. Adding a linear
/// function of the position to all heights changes no answer.
/// - coordinate(i, axis): of the position; rounded, equal for equal ones; used for ordering only;
/// - orient3d(a, b, c, d): sign of det(b-a, c-a, d-a) of the positions;
/// - power_test(a, b, c, d, e): +1 if lifted e is strictly below the hyperplane through the lifted a, b, c,
///   d, 0 on it, when orient3d(a, b, c, d) > 0; the sign flips with the orientation;
/// - compare_lex(a, b): of the positions alone, 0 iff they are equal;
/// - compare_height(a, b): -1 if a is lower. Asked for sites of equal position only.
///
/// And where all positions are on one plane or line, all of which is still exact:
/// - orient2d(a, b, c, drop): of the projection along axis `drop`, +1 if counter-clockwise, with the axes
///   (drop + 1) % 3 and (drop + 2) % 3 in this order; asked for any three sites too;
/// - power_test2d(a, b, c, d, drop): +1 if lifted d is strictly below the plane through the lifted a, b, c,
///   when orient2d(a, b, c, drop) > 0; the sign flips with the orientation. Asked for coplanar positions
///   only, with an axis that keeps the plane a plane;
/// - power_test1d(a, b, c): +1 if lifted c is strictly below the line through the lifted a and b, whatever
///   their order. Asked for collinear positions only, those of a and b different.
template <class P>
concept PowerPredicates3 = requires(const P& p, std::uint32_t i, int axis) {
  { p.size() } -> std::convertible_to<std::uint32_t>;
  { p.coordinate(i, axis) } -> std::convertible_to<double>;
  { p.orient3d(i, i, i, i) } -> std::same_as<int>;
  { p.power_test(i, i, i, i, i) } -> std::same_as<int>;
  { p.compare_lex(i, i) } -> std::same_as<int>;
  { p.compare_height(i, i) } -> std::same_as<int>;
  { p.orient2d(i, i, i, axis) } -> std::same_as<int>;
  { p.power_test2d(i, i, i, i, axis) } -> std::same_as<int>;
  { p.power_test1d(i, i, i) } -> std::same_as<int>;
};

/// Points or sites in space that come as rows of the in-sphere or power test, for speed: a triangulation asks
/// many cells about one point, and so lifts each vertex once.
/// - lifted(i, origin): site i relative to another, rounded (lifted_row.h);
/// - lifted_error(): how far lifted_determinant of four rows may be off, of the points there are now; infinite
///   where that is not known. A larger determinant has the sign of insphere or power_test.
template <class P>
concept LiftsPoints = requires(const P& p, std::uint32_t i) {
  { p.lifted(i, i) } -> std::same_as<LiftedRow>;
  { p.lifted_error() } -> std::same_as<LiftedError>;
};

/// PointPredicates2 that also measures: what conforming edge recovery needs to place its splits.
/// - squared_distance(a, b): Euclidean, rounded, symmetric in a and b.
template <class P>
concept MetricPredicates2 = PointPredicates2<P> && requires(const P& p, std::uint32_t i) {
  { p.squared_distance(i, i) } -> std::convertible_to<double>;
};

}  // namespace crossloft
