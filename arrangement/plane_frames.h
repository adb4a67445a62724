#pragma once
/// Integer planes for wanted ones, with the lines and points that they share kept exactly.

#include <cstdint>
#include <vector>

#include "../geom/context.h"
#include "../geom/lattice.h"
#include "coincidences.h"

namespace crossloft {

/// A plane to be framed, in lattice units.
struct PlaneWish {
  LatticeVector direction;  ///< of quantise_direction
  WantedPlane plane;
  std::vector<LatticeVector> points;  ///< what it should pass through; empty: `plane` alone counts
  LatticeVector centre;               ///< of the points, or the foot of the origin
};

struct PlaneFrames {
  std::vector<LatticePlane> planes;                 ///< one for each wish
  std::uint32_t pencils = 0, points = 0;            ///< coincidences that hold exactly
  std::uint32_t lost_pencils = 0, lost_points = 0;  ///< found, but the integers could not keep them
};

/// Frames the planes. Each is first framed alone; planes with small integers keep what they share by
/// themselves. Of what does not hold then, common points are given one lattice point for all their planes,
/// and pencils a lattice axis through one lattice point. A plane is bound once: what would bind it in two
/// ways is lost. `radius` bounds the data around the origin, `tolerance` is for the coincidences, both in
/// lattice units. The order of the wishes matters for ties only: pass them in canonical order.
PlaneFrames frame_planes(const std::vector<PlaneWish>& wishes, std::int64_t radius, double tolerance,
                         const Context& context);

}  // namespace crossloft
