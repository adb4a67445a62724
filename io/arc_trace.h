#pragma once
/// The arcs of Moebius diagrams as pieces of lines and circles that can be drawn.

#include <optional>
#include <vector>

#include "../moebius/diagram.h"
#include "../moebius/face_diagram.h"
#include "curve_piece.h"

namespace crossloft {

/// An arc by its curve and ends. A line is walked along its direction, and has no end where it runs to
/// infinity; a circle without ends is whole.
struct ArcShape {
  MoebiusCurve curve;
  bool ccw = false;        ///< a circle is walked counter-clockwise
  bool over_half = false;  ///< more than half of the circle, but not the whole: rounded ends may not tell
  std::optional<Vec2> from, to;
};

ArcShape shape_of(const MoebiusDiagram& diagram, const MoebiusArc& arc);
ArcShape shape_of(const FaceArc& arc);

/// The pieces of the arc in the direction of its walk. Ends at infinity become points outside the box, which
/// the line does not meet beyond them. In the box the pieces are as precise as the ends, whatever the radius.
/// None for an arc that is not finite, as those are whose computation left the range of doubles.
std::vector<CurvePiece> trace(const ArcShape& arc, const ViewBox& box);

}  // namespace crossloft
