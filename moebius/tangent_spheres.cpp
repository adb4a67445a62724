#include "tangent_spheres.h"

#include <algorithm>
#include <cmath>

#include "face_diagram.h"

namespace crossloft {

TriangleAxis::TriangleAxis(Vec3 a, Vec3 b, Vec3 c) : base(a) {
  const Vec3 u = b - a, v = c - a;
  normal = cross(u, v);
  centre = (0.5 / dot(normal, normal)) * cross(dot(u, u) * v - dot(v, v) * u, normal);
}

TangentSpheres::TangentSpheres(const TriangleAxis& axis, const FaceFrame& frame, double height)
    : axis_(axis), frame_(frame) {
  const double r = height + dot(frame.up(), axis.centre), square = dot(axis.centre, axis.centre);
  const Vec3 slant = cross(frame.up(), axis.normal);
  const double t = dot(slant, slant), b = r * dot(frame.up(), axis.normal);
  const double discriminant = r * r * dot(axis.normal, axis.normal) - t * square;
  exist_ = t > 0 && discriminant > 0;
  const double root = std::sqrt(std::max(0.0, discriminant));
  // The larger root by adding, the other one by the product of both: nothing cancels.
  const double q = b >= 0 ? b + root : b - root;
  const double near = q != 0 ? (square - r * r) / q : 0;
  const double far = t > 0 ? q / t : near;
  low_ = b >= 0 ? near : far;
  high_ = b >= 0 ? far : near;
  middle_ = t > 0 ? b / t : near;
}

bool TangentSpheres::farther_from_middle(Vec3 point) const {
  const Vec3 w = point - axis_.base;
  return dot(w, w) > 2 * dot(w, at(middle_));
}

MoebiusCurve tangent_curve(const FaceSite& i, const FaceSite& j) {
  const Vec2 d = i.foot - j.foot;
  const double square = dot(d, d), rise = j.height - i.height;
  if (rise == 0) {
    const double length = std::sqrt(square);
    return {true, 0.5 * (i.foot + j.foot), 0, {d.y / length, -d.x / length}};
  }
  return {false,
          i.foot + (i.height / rise) * d,
          std::sqrt((square + rise * rise) * (i.height * j.height)) / std::abs(rise),
          {}};
}

Vec2 near_point_of_circle(const FaceSite& i, const FaceSite& j) {
  if (i.height > j.height) return near_point_of_circle(j, i);
  // From the lower site's foot away from its centre: R - |centre - foot|, multiplied out so that nothing
  // cancels.
  const Vec2 d = j.foot - i.foot;
  const double square = dot(d, d), rise = j.height - i.height;
  const double mean = std::sqrt((square + rise * rise) * (i.height * j.height));
  if (square == 0) return i.foot + Vec2{mean / rise, 0};
  const double length = std::sqrt(square);
  const double step = i.height * (square + rise * j.height) / (mean + length * i.height);
  return i.foot + (step / length) * d;
}

}  // namespace crossloft
