#pragma once
/// Pieces of lines and circles, and what of them lies in a rectangle: for drawing, in doubles.

#include <span>
#include <vector>

#include "../geom/vec2.h"
#include "svg.h"

namespace crossloft {

/// A directed segment, or an arc of a circle over less than half a turn.
struct CurvePiece {
  Vec2 from, to;
  bool is_line = true;
  Vec2 centre;        ///< of the circle
  double radius = 0;  ///< of the circle
  bool ccw = false;   ///< an arc walks counter-clockwise
};

CurvePiece reversed(const CurvePiece& piece);
/// The point half way along the piece.
Vec2 middle(const CurvePiece& piece);

/// The least box around the pieces. REQUIRES: there are some.
ViewBox bounds_of(std::span<const CurvePiece> pieces);

/// Appends an arc of any length as pieces of a third of a turn at most: ends and radius of a long arc fix its
/// centre badly. Whether it is over half a turn decides where the ends, being rounded, can't: if they nearly
/// coincide, it is tiny or all but a whole circle.
void append_arc(const CurvePiece& arc, bool over_half, std::vector<CurvePiece>& pieces);
/// Appends the circle as four pieces, from its rightmost point on.
void append_circle(Vec2 centre, double radius, bool ccw, std::vector<CurvePiece>& pieces);

/// The way from a point of a line, along `direction` of length 1, until it is far outside the box for good.
Vec2 far_along(Vec2 point, Vec2 direction, const ViewBox& box);

/// A connected part of a curve inside a box.
struct CurveRun {
  std::vector<CurvePiece> pieces;  ///< each begins where the one before it ends
  bool enters = false;             ///< begins on the border of the box, not at the beginning of the curve
  bool leaves = false;             ///< ends on the border, not at the end of the curve
};

/// The parts of a curve inside a box, in their order. `curve`: each piece begins where the one before it
/// ends.
std::vector<CurveRun> clip(std::span<const CurvePiece> curve, const ViewBox& box);

/// Where a point on the border of a box lies along it: counter-clockwise from 0 at the low corner, one unit a
/// side.
double border_position(Vec2 point, const ViewBox& box);
/// The corner at the border position 0, 1, 2 or 3.
Vec2 border_corner(unsigned position, const ViewBox& box);

}  // namespace crossloft
