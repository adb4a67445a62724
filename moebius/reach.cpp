#include "reach.h"

#include <algorithm>
#include <cmath>

namespace crossloft {

Disk disk_around(const FaceFrame& frame, const Box2& box) {
  const Vec2 half = 0.5 * (box.high - box.low);
  return {frame.to_space(box.low + half), std::sqrt(dot(half, half))};
}

std::vector<Disk> disks_over(const FaceFrame& frame, const Box2& box) {
  const Vec2 size = box.high - box.low;
  // Four parts in a row if the box is long, else two by two.
  const double columns = size.x > 3 * size.y ? 4 : size.y > 3 * size.x ? 1 : 2, rows = 4 / columns;
  const Vec2 step{size.x / columns, size.y / rows};
  std::vector<Disk> disks;
  for (double x = 0; x < columns; ++x)
    for (double y = 0; y < rows; ++y) {
      const Vec2 low = box.low + Vec2{x * step.x, y * step.y};
      disks.push_back(disk_around(frame, {low, low + step}));
    }
  return disks;
}

/// |a - foot|^2 / h + h, from the nearest and to the farthest point of the disk.
DiameterRange diameters_over(const Disk& disk, const HighPoint& site) {
  const Vec3 d = disk.centre - site.point;
  const double distance = std::sqrt(std::max(0.0, dot(d, d) - site.height * site.height));
  const double near = std::max(0.0, distance - disk.radius), far = distance + disk.radius;
  return {near * near / site.height + site.height, far * far / site.height + site.height};
}

/// Seen from the centre m, g(a) = h_j |a - i|^2 - h_i |a - j|^2 has the gradient 2 (h_j (m - i) - h_i (m -
/// j)), which has no component normal to the face, and the second derivative 2 (h_j - h_i).
bool change_ranks(const Disk& disk, const HighPoint& i, const HighPoint& j) {
  const Vec3 to_i = disk.centre - i.point, to_j = disk.centre - j.point;
  const double value = j.height * dot(to_i, to_i) - i.height * dot(to_j, to_j);
  const double change =
      2 * norm(j.height * to_i - i.height * to_j) + std::abs(j.height - i.height) * disk.radius;
  return std::abs(value) <= change * disk.radius;
}

}  // namespace crossloft
