#pragma once
/// Common lines of planes within the data, and the points where three or more planes meet.

#include <cstdint>
#include <span>
#include <vector>

#include "../geom/unit_plane.h"

namespace crossloft {

/// The ball that holds the data.
struct DataBall {
  Vec3 middle;
  double radius = 0;
};

struct CommonLine {
  Vec3 point, direction;              ///< the point nearest to the middle of the data; unit length
  double reach = 0;                   ///< the line is within the data for |t| <= reach
  std::vector<std::uint32_t> planes;  ///< all that contain it, ascending

  Vec3 at(double t) const { return point + t * direction; }
  double parameter(Vec3 p) const { return dot(direction, p - point); }
};

/// The lines of each two planes that meet within the ball, one for all planes that contain it up to
/// `tolerance`. O(k^2) lines of k planes, O(k) for each.
std::vector<CommonLine> common_lines(std::span<const UnitPlane> planes, const DataBall& ball,
                                     double tolerance);

/// A point of three or more planes.
struct SharedPoint {
  Vec3 point;
  std::vector<std::uint32_t> planes;  ///< all that contain it, ascending
  std::vector<std::uint32_t> lines;   ///< common lines through it, ascending
};

/// The points of lines with planes that do not contain them, within the ball. O(l k) for l lines, O(k) more
/// for each point.
std::vector<SharedPoint> common_points(std::span<const UnitPlane> planes, std::span<const CommonLine> lines,
                                       double tolerance);

}  // namespace crossloft
