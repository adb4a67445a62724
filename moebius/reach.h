#pragma once
/// Bounds of tangent spheres over a part of a face, to leave out early what cannot matter there.

#include <span>
#include <vector>

#include "../geom/vec3.h"
#include "face_frame.h"

namespace crossloft {

/// A disk of a face's plane.
struct Disk {
  Vec3 centre;
  double radius = 0;
};

/// The disk around a box.
Disk disk_around(const FaceFrame& frame, const Box2& box);
/// Four disks that cover a box together, each smaller than the one around it.
std::vector<Disk> disks_over(const FaceFrame& frame, const Box2& box);

/// A site in space and its height over the face.
struct HighPoint {
  Vec3 point;
  double height = 0;  ///< > 0
};

/// The least and the greatest diameter of a sphere through the site that is tangent to the disk.
struct DiameterRange {
  double low = 0, high = 0;
};
DiameterRange diameters_over(const Disk& disk, const HighPoint& site);

/// False if one of the two sites has the smaller tangent sphere all over the disk.
bool change_ranks(const Disk& disk, const HighPoint& i, const HighPoint& j);

}  // namespace crossloft
