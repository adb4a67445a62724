#pragma once
/// A face of a convex cell seen as the plane of a diagram: orthonormal axes, feet and heights in doubles.

#include "../geom/lattice.h"
#include "../geom/lattice_rounding.h"
#include "../geom/vec2.h"
#include "../geom/vec3.h"

namespace crossloft {

/// Axes of a plane, lattice units: x, y along it, the third towards the cell, right-handed.
/// Only + - * / sqrt: the same bits everywhere.
class FaceFrame {
 public:
  FaceFrame() = default;
  /// `side` is +1 if the cell is on the side that the plane's normal points to, else -1.
  FaceFrame(const LatticePlane& plane, int side);

  const LatticePlane& plane() const { return plane_; }
  /// Unit vectors; `up` is normal to the plane and points into the cell.
  const Vec3& x_axis() const { return x_; }
  const Vec3& y_axis() const { return y_; }
  const Vec3& up() const { return up_; }

  /// The foot of p on the plane. Rounded, error a few ulp of the coordinates' size.
  Vec2 to_plane(const LatticePoint& p) const { return to_plane(real(p)); }
  Vec2 to_plane(Vec3 p) const {
    const Vec3 d = p - origin_;
    return {dot(x_, d), dot(y_, d)};
  }
  Vec3 to_space(Vec2 a) const { return origin_ + a.x * x_ + a.y * y_; }
  /// Height of p over the plane, positive on the cell's side; a relative error of a few ulp also next to the
  /// plane.
  double height(const LatticePoint& p) const;

 private:
  LatticePlane plane_;
  Vec3 origin_, x_, y_, up_;
  double per_value_ = 0;  ///< height of a point per unit of plane_value, signed
};

/// The part of a plane with low <= x <= high per axis.
struct Box2 {
  Vec2 low, high;
};

/// A site of a face's diagram: its distance from a is twice the radius of the sphere through it tangent to
/// the face at a.
struct FaceSite {
  Vec2 foot;
  double height = 0;  ///< > 0
};

/// Radius of the sphere through the site that is tangent to the plane at a: (|a - foot|^2 + h^2) / 2h.
inline double tangent_radius(const FaceSite& site, Vec2 a) {
  const Vec2 d = a - site.foot;
  return (dot(d, d) + site.height * site.height) / (2 * site.height);
}

}  // namespace crossloft
