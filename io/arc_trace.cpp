#include "arc_trace.h"

#include <algorithm>
#include <cmath>

namespace crossloft {
namespace {

CurvePiece segment(Vec2 from, Vec2 to) { return {from, to, true, {}, 0, false}; }

double larger_side(const ViewBox& box) { return std::max(box.size().x, box.size().y); }

/// How far an arc of at most half a turn is from its chord, not underestimated.
double height_over_chord(const CurvePiece& piece) {
  const Vec2 chord = piece.to - piece.from;
  return std::min(piece.radius, dot(chord, chord) / (4 * piece.radius));
}

bool misses(const CurvePiece& piece, const ViewBox& box) {
  const double reach = height_over_chord(piece);
  return std::max(piece.from.x, piece.to.x) + reach < box.low.x ||
         std::min(piece.from.x, piece.to.x) - reach > box.high.x ||
         std::max(piece.from.y, piece.to.y) + reach < box.low.y ||
         std::min(piece.from.y, piece.to.y) - reach > box.high.y;
}

/// Halves an arc until each part misses the box or is within a millionth of the box of its chord. Halving at
/// chords keeps the relative precision of the ends inside the box, whatever the radius.
void append_straight(const CurvePiece& piece, const ViewBox& box, std::vector<CurvePiece>& pieces) {
  constexpr double kFlat = 1e-6;
  if (height_over_chord(piece) <= kFlat * larger_side(box) || misses(piece, box))
    return pieces.push_back(segment(piece.from, piece.to));
  CurvePiece first = piece, second = piece;
  first.to = second.from = middle(piece);
  append_straight(first, box, pieces);
  append_straight(second, box, pieces);
}

/// Circles so large that doubles do not know well where they cross the box become chains of segments, a few
/// in the box.
std::vector<CurvePiece> straightened_if_huge(const std::vector<CurvePiece>& pieces, const ViewBox& box) {
  constexpr double kHuge = 1e6;
  std::vector<CurvePiece> straight;
  for (const CurvePiece& piece : pieces) {
    if (piece.is_line || piece.radius < kHuge * larger_side(box))
      straight.push_back(piece);
    else
      append_straight(piece, box, straight);
  }
  return straight;
}

std::vector<CurvePiece> trace_circle(const ArcShape& arc, const ViewBox& box) {
  const auto& [is_line, centre, radius, direction] = arc.curve;
  std::vector<CurvePiece> pieces;
  if (arc.from && arc.to)
    append_arc({*arc.from, *arc.to, false, centre, radius, arc.ccw}, arc.over_half, pieces);
  else
    append_circle(centre, radius, arc.ccw, pieces);
  return straightened_if_huge(pieces, box);
}

std::vector<CurvePiece> trace_line(const ArcShape& arc, const ViewBox& box) {
  const Vec2 direction = arc.curve.direction, point = arc.curve.centre;
  const Vec2 from = arc.from ? *arc.from : far_along(arc.to.value_or(point), -direction, box);
  const Vec2 to = arc.to ? *arc.to : far_along(arc.from.value_or(point), direction, box);
  return {segment(from, to)};
}

/// Squares stay finite. Larger numbers, infinities and NaN are what is left of a curve that went beyond the
/// range of doubles (diagram.h).
bool is_lost(const ArcShape& arc) {
  constexpr double kMost = 1e150;
  const auto fits = [](Vec2 p) { return std::abs(p.x) <= kMost && std::abs(p.y) <= kMost; };
  return !fits(arc.curve.centre) || !fits(arc.curve.direction) || !(arc.curve.radius <= kMost) ||
         !fits(arc.from.value_or(Vec2{})) || !fits(arc.to.value_or(Vec2{}));
}

}  // namespace

ArcShape shape_of(const MoebiusDiagram& diagram, const MoebiusArc& arc) {
  ArcShape shape{arc.curve, false, arc.over_half, {}, {}};
  shape.ccw = diagram.sites[arc.sites[0]].lambda > diagram.sites[arc.sites[1]].lambda;
  if (arc.from != kNone) shape.from = diagram.vertices[arc.from];
  if (arc.to != kNone) shape.to = diagram.vertices[arc.to];
  return shape;
}

ArcShape shape_of(const FaceArc& arc) {
  ArcShape shape{arc.curve, !arc.clockwise, arc.over_half, {}, {}};
  if (!arc.whole && !arc.from_infinite) shape.from = arc.from;
  if (!arc.whole && !arc.to_infinite) shape.to = arc.to;
  return shape;
}

std::vector<CurvePiece> trace(const ArcShape& arc, const ViewBox& box) {
  if (is_lost(arc)) return {};
  return arc.curve.is_line ? trace_line(arc, box) : trace_circle(arc, box);
}

}  // namespace crossloft
