#include "face_frame.h"

#include "../geom/plane_line.h"

namespace crossloft {
namespace {

Vec3 as_doubles(const LatticeVector& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

}  // namespace

FaceFrame::FaceFrame(const LatticePlane& plane, int side) : plane_(plane), origin_(as_doubles(plane.origin)) {
  const Vec3 e1 = as_doubles(plane.e1), normal = static_cast<double>(side) * as_doubles(plane.normal);
  per_value_ = static_cast<double>(side) / norm(normal);
  up_ = (1 / norm(normal)) * normal;
  x_ = (1 / norm(e1)) * e1;
  y_ = cross(up_, x_);
}

double FaceFrame::height(const LatticePoint& p) const { return per_value_ * plane_value(plane_, p); }

}  // namespace crossloft
