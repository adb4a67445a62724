#pragma once
/// Planes that coincide, meet in one line or in one point up to rounding: found on the wanted planes, before
/// each is snapped to its own frame and they would come apart.

#include <cstdint>
#include <vector>

#include "../geom/ids.h"
#include "../geom/vec3.h"

namespace crossloft {

/// A wanted plane { x : normal.x = offset }, |normal| = 1, the data around the origin.
struct WantedPlane {
  Vec3 normal;
  double offset = 0;
};

/// Three or more planes through one line.
struct Pencil {
  std::vector<std::uint32_t> planes;  ///< ascending
  Vec3 point;                         ///< of the line, nearest to the origin
  Vec3 direction;                     ///< unit
};

/// Four or more planes through one point.
struct CommonPoint {
  std::vector<std::uint32_t> planes;  ///< ascending
  Vec3 point;
};

struct Coincidences {
  std::vector<Pencil> pencils;
  std::vector<CommonPoint> points;  ///< only those that do not follow from the pencils
};

/// [plane] the first plane that agrees with it within `tolerance` over the ball of the radius around the
/// origin, transitively; itself if none before it does. O(k^2).
std::vector<std::uint32_t> find_equal_planes(const std::vector<WantedPlane>& planes, double radius,
                                             double tolerance);

/// Pencils and common points within the ball, up to the tolerance (a length). Lines of two planes that are
/// nearly parallel are told by both ends of a piece as long as the ball.
/// REQUIRES: no equal planes. O(k^3) for planes that are not parallel.
Coincidences find_coincidences(const std::vector<WantedPlane>& planes, double radius, double tolerance);

}  // namespace crossloft
