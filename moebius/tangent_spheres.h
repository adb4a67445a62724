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

  bool exist() const { return exist_; }
  /// Where the lower one (its centre first along the normal), or the upper one, touches the face. If there is
  /// none, where one nearly does.
  Vec2 touch(bool upper) const { return frame_.to_plane(axis_.base + at(upper ? high_ : low_)); }
  /// True iff the point (not one of the three) is farther than the three from the middle between both
  /// centres.
  bool farther_from_middle(Vec3 point) const;

 private:
  Vec3 at(double s) const { return axis_.centre + s * axis_.normal; }

  const TriangleAxis& axis_;
  const FaceFrame& frame_;
  bool exist_ = false;
  double low_ = 0, high_ = 0, middle_ = 0;
};

/// The curve of equal tangent spheres of i and j, its line directed with i on the left. REQUIRES: the sites
/// differ.
MoebiusCurve tangent_curve(const FaceSite& i, const FaceSite& j);
/// A point of the circle of equal tangent spheres of two sites of different heights: that next to their feet.
Vec2 near_point_of_circle(const FaceSite& i, const FaceSite& j);

}  // namespace crossloft
