#include "face_frame.h"

#include "../geom/lattice_rounding.h"
#include "../geom/plane_line.h"

namespace crossloft {

FaceFrame::FaceFrame(const LatticePlane& plane, int side) : plane_(plane), origin_(real(plane.origin)) {
  const Vec3 e1 = real(plane.e1), normal = static_cast<double>(side) * real(plane.normal);
  per_value_ = static_cast<double>(side) / norm(normal);
  up_ = (1 / norm(normal)) * normal;
  x_ = (1 / norm(e1)) * e1;
  y_ = cross(up_, x_);
}

double FaceFrame::height(const LatticePoint& p) const { return per_value_ * plane_value(plane_, p); }

}  // namespace crossloft
