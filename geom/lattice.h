#pragma once
/// The exact model: integer planes and the points on them.
///
/// Coordinates are integers, |x| <= 2^50 (kLatticeLimit), the images of input coordinates under the world
/// grid (grid.h). A plane is o + u e1 + v e2 with integer o, e1, e2; its normal N = e1 x e2 satisfies
/// |N_k| <= 2^40. A point is rational, (X, Y, Z) / W with W >= 1:
///   - explicit: W = 1, three integers that doubles hold exactly (contour vertices, splits, samples);
///   - line point: the point of the line of two planes at an integer coordinate, W <= 81 bits;
///   - arrangement vertex: three planes, W <= 122 bits.
/// The kinds are one type: a point is explicit iff its reduced W is 1, so equality is exact across kinds.
///
/// All predicates below are exact for every such point: a filter on the rounded coordinates first, fixed
/// width integers behind it. They read only the points, allocate nothing and may run on any thread.

#include <array>
#include <cstdint>
#include <deque>
#include <memory>

#include "fp_check.h"
#include "vec3.h"

namespace crossloft {

using LatticeVector = std::array<std::int64_t, 3>;

inline constexpr std::int64_t kLatticeLimit = std::int64_t{1} << 50;
inline constexpr std::int64_t kNormalLimit = std::int64_t{1} << 40;

/// Reduced homogeneous coordinates of a point that is not integral; layout in homogeneous.h.
struct Homogeneous;

/// A point as predicates see it: coordinates rounded to the nearest double (exact when `exact` is null) and
/// the exact ones. Trivially copyable; `exact` is owned by a LatticePointStore that must outlive the copy.
struct LatticePoint {
  double x = 0, y = 0, z = 0;
  const Homogeneous* exact = nullptr;

  bool is_explicit() const { return exact == nullptr; }
  double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

/// The plane { p : N.p = N.o }; the side that N points to is positive.
/// REQUIRES: N = e1 x e2 != 0, |N_k| <= 2^40, |o_k| <= 2^50.
struct LatticePlane {
  LatticeVector origin{}, e1{}, e2{}, normal{};
};

/// N = e1 x e2 filled in. REQUIRES: the result within kNormalLimit.
LatticePlane make_lattice_plane(LatticeVector origin, LatticeVector e1, LatticeVector e2);
/// The plane { x_axis = value }.
LatticePlane make_axis_plane(int axis, std::int64_t value);
/// The axis of the largest |N_k|, the lowest on a tie: projections along it are injective on the plane.
int dominant_axis(const LatticeVector& normal);
/// cross product in integers. REQUIRES: no overflow of 64 bits.
LatticeVector cross(const LatticeVector& a, const LatticeVector& b);

/// An integral point. REQUIRES: |coordinates| <= 2^50.
LatticePoint make_point(const LatticeVector& c);
/// The integer coordinates of an explicit point.
LatticeVector to_vector(const LatticePoint& explicit_point);

/// Owns the exact coordinates of rational points. Not thread safe; addresses stay valid for its lifetime.
class LatticePointStore {
 public:
  LatticePointStore();
  ~LatticePointStore();
  LatticePointStore(LatticePointStore&&) noexcept;
  LatticePointStore& operator=(LatticePointStore&&) noexcept;

  /// The common point of three planes into `point`; false if they have no or more than one common point or it
  /// lies outside |x| <= 2^50. An integral result is explicit. Equal points share one exact representation.
  bool meet(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c, LatticePoint& point);
  std::size_t size() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// Predicates. Each returns -1, 0 or +1 and is exact.

/// True iff the two points have the same exact coordinates.
bool equal(const LatticePoint& a, const LatticePoint& b);
/// Sign of a_axis - b_axis where both have the same rounded coordinate and one is not explicit.
int compare_axis_exact(int axis, const LatticePoint& a, const LatticePoint& b);
/// Sign of a_axis - b_axis. Rounding to nearest is monotone: different rounded values order the exact ones.
inline int compare_axis(int axis, const LatticePoint& a, const LatticePoint& b) {
  const double x = a[axis], y = b[axis];
  if (x != y) return x < y ? -1 : 1;
  return a.exact == b.exact ? 0 : compare_axis_exact(axis, a, b);
}
/// Lexicographic order by exact x, then y, then z: the rank of the symbolic perturbation.
inline int compare_lex(const LatticePoint& a, const LatticePoint& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (const int sign = compare_axis(axis, a, b)) return sign;
  return 0;
}

/// Sign of N.p - N.o: +1 on the side N points to.
int side_of_plane(const LatticePlane& plane, const LatticePoint& p);

/// Sign of det(b-a, c-a, d-a): +1 if d is on the side from which a, b, c turn counter-clockwise.
int orient3d(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d);
/// +1 if e is inside the sphere through a, b, c, d, 0 on it. REQUIRES: orient3d(a,b,c,d) > 0 for that meaning;
/// the sign flips with the orientation.
int insphere(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d,
             const LatticePoint& e);

/// Orientation of three points of the plane, +1 if counter-clockwise seen from the side of N.
/// REQUIRES: all points on the plane.
int orient2d(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b, const LatticePoint& c);
/// +1 if d is inside the circle through a, b, c (Euclidean circle within the plane), 0 on it.
/// REQUIRES: all points on the plane; orient2d(plane,a,b,c) > 0 for that meaning.
int incircle(const LatticePlane& plane, const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
             const LatticePoint& d);

}  // namespace crossloft
