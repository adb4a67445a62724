#pragma once
/// Spheres through three or two points that are tangent to a face: the vertices and the curves of its
/// diagram.

#include "../geom/vec3.h"
#include "diagram.h"
#include "face_frame.h"

namespace crossloft {

/// The line of the centres of all spheres through three points: base + centre + s normal.
struct TriangleAxis {
  Vec3 base;    ///< the first point
  Vec3 centre;  ///< of the circle through the three, seen from base
  Vec3 normal;  ///< (b - a) x (c - a), any length

  TriangleAxis(Vec3 a, Vec3 b, Vec3 c);
  /// s of the sphere that passes through `point` too.
  double place_of(Vec3 point) const {
    const Vec3 w = point - base;
    return (dot(w, w) - 2 * dot(w, centre)) / (2 * dot(w, normal));
  }
};

/// The two spheres through three points on one side of a face that are tangent to it. Between their centres
/// the centre is higher over the face than it is far from the points.
///
/// With r the height of the circle's centre, R its radius, k = up . normal, T = |up x normal|^2: the height r
/// + s k equals the distance to the points where T s^2 - 2 r k s - (r^2 - R^2) = 0. The discriminant r^2
/// |normal|^2 - T R^2 is positive iff the circle stays clear of the plane.
class TangentSpheres {
 public:
  /// `height` is that of the axis' base.
  TangentSpheres(const TriangleAxis& axis, const FaceFrame& frame, double height);

  bool exist() const { return slant_ > 0 && discriminant_ > 0; }
  /// Where the lower one (its centre first along the normal), or the upper one, touches the face. Its place
  /// on the axis is kept between `least` and `most`; if there is none, where one nearly does.
  Vec2 touch(bool upper, double least, double most) const;
  /// True iff the point (not one of the three) is farther than the three from the middle between both
  /// centres. REQUIRES: exist().
  bool farther_from_middle(Vec3 point) const {
    const Vec3 w = point - axis_.base;
    return (dot(w, w) - 2 * dot(w, axis_.centre)) * slant_ > 2 * dot(w, axis_.normal) * half_sum_;
  }

 private:
  const TriangleAxis& axis_;
  const FaceFrame& frame_;
  double radius_excess_;  ///< R^2 - r^2
  double slant_;          ///< T
  double half_sum_;       ///< r k: T times the mean of the roots
  double discriminant_;
};

/// The curve of equal tangent spheres of i and j, its line directed with i on the left. REQUIRES: the sites
/// differ.
MoebiusCurve tangent_curve(const FaceSite& i, const FaceSite& j);
/// A point of the circle of equal tangent spheres of two sites of different heights: that next to their feet.
Vec2 near_point_of_circle(const FaceSite& i, const FaceSite& j);

}  // namespace crossloft
