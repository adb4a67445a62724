#pragma once
/// The arcs of Moebius diagrams as pieces of lines and circles that can be drawn.

#include <optional>
#include <vector>

#include "../moebius/diagram.h"
#include "curve_piece.h"

namespace crossloft {

/// An arc by its curve and ends. A line is walked along its direction, and has no end where it runs to
/// infinity; a circle without ends is whole.
struct ArcShape {
  MoebiusCurve curve;
  bool ccw = false;  ///< a circle is walked counter-clockwise
  std::optional<Vec2> from, to;
};

/// The pieces of the arc in the direction of its walk. Ends at infinity become points outside the box, which
/// the line does not meet beyond them. An arc whose ends nearly coincide is taken for a tiny one.
std::vector<CurvePiece> trace(const ArcShape& arc, const ViewBox& box);

/// The same for an arc of a diagram. Whether an arc whose ends nearly coincide is tiny or all but a whole
/// circle, which rounded ends can't tell, is looked up in the diagram: linear time for such an arc.
std::vector<CurvePiece> trace(const MoebiusDiagram& diagram, const MoebiusArc& arc, const ViewBox& box);

}  // namespace crossloft
