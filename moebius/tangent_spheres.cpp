#include "tangent_spheres.h"

#include <algorithm>
#include <cmath>

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
  radius_excess_ = square - r * r;
  slant_ = dot(slant, slant);
  half_sum_ = r * dot(frame.up(), axis.normal);
  discriminant_ = r * r * dot(axis.normal, axis.normal) - slant_ * square;
}

Vec2 TangentSpheres::touch(bool upper, double least, double most) const {
  const double root = std::sqrt(std::max(0.0, discriminant_));
  // The root of larger size by adding, the other one by the product of both: nothing cancels.
  const double q = half_sum_ >= 0 ? half_sum_ + root : half_sum_ - root;
  double s = q != 0 ? radius_excess_ / q : 0;
  if (upper == (half_sum_ >= 0) && slant_ > 0) s = q / slant_;
  if (s < least) s = least;
  if (s > most) s = most;
  return frame_.to_plane(axis_.base + axis_.centre + s * axis_.normal);
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
