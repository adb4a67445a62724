#pragma once
/// Points along the arcs of a diagram.

#include <vector>

#include "../geom/vec2.h"
#include "face_diagram.h"

namespace crossloft {

/// Appends points of the arc at equal steps, consecutive ones at most `spacing` apart, both (finite) ends
/// included, from `from` to `to`; only those in the box. Equal steps come from halving, so they may be half
/// as long as asked. A vertex that was rounded far off the arc's line is left out, and so is an arc of a circle with
/// such an end. Only + - * / sqrt. REQUIRES: spacing > 0. O(points), also for arcs that leave the box.
void sample_arc(const FaceArc& arc, double spacing, const Box2& box, std::vector<Vec2>& points);

}  // namespace crossloft
