#pragma once
/// The cells of a face's diagram cut by the section on the face: how many pieces each has.

#include <cstdint>
#include <span>
#include <vector>

#include "../geom/vec2.h"
#include "cutting.h"

namespace crossloft {

/// A piece of an arc that turns by at most a half.
struct Strand {
  Vec2 from, to;
  double curvature = 0;  ///< 1 / radius, 0 for a line
  double bulge = 1;      ///< +1 counter-clockwise, -1 clockwise
  std::uint32_t arc = kNone;
};

/// A strand passes a wall.
struct WallCrossing {
  std::uint32_t strand = kNone, wall = kNone;
  double along_strand = 0, along_wall = 0;  ///< in step with the place, from 0 to 1
  bool enters = false;                      ///< the strand comes into the section
  Vec2 at;
};

/// Appends the pieces of an arc; infinite ends are cut beyond the box.
void split_arc(const FaceArc& arc, std::uint32_t number, const Box2& box, std::vector<Strand>& strands);

/// Appends where the strand passes the wall, at most twice. The sides of the wall's ends are asked of the
/// strand's whole curve, so that walls in a row miss none between them.
void cross_wall(const Strand& strand, const DirectedWall& wall, std::vector<WallCrossing>& crossings);

/// Twice the area between the origin and the strand's way from p to q, both on it.
double twice_area(const Strand& strand, Vec2 p, Vec2 q);

}  // namespace crossloft
