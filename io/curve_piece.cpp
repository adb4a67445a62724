#include "curve_piece.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace crossloft {
namespace {

/// A side of a box: one coordinate is fixed, the other runs from low to high.
struct Side {
  bool upright;  ///< x is the fixed one
  double value, low, high;

  double across(Vec2 p) const { return upright ? p.x : p.y; }
  double along(Vec2 p) const { return upright ? p.y : p.x; }
  Vec2 point(double along) const { return upright ? Vec2{value, along} : Vec2{along, value}; }
  bool has(double along) const { return along >= low && along <= high; }
};

std::array<Side, 4> sides_of(const ViewBox& box) {
  return {{{true, box.low.x, box.low.y, box.high.y},
           {true, box.high.x, box.low.y, box.high.y},
           {false, box.low.y, box.low.x, box.high.x},
           {false, box.high.y, box.low.x, box.high.x}}};
}

bool contains(const ViewBox& box, Vec2 p) {
  return p.x > box.low.x && p.x < box.high.x && p.y > box.low.y && p.y < box.high.y;
}

/// The middle of an arc of more than half a turn: seen from the centre opposite to the middle of the chord,
/// and at right angles to the chord. Ends near to each other fix the former direction well, ends far from
/// each other the latter.
Vec2 far_middle(const CurvePiece& arc) {
  const Vec2 chord = arc.to - arc.from;
  const bool is_long = dot(chord, chord) > arc.radius * arc.radius;
  const Vec2 across = arc.ccw ? Vec2{chord.y, -chord.x} : Vec2{-chord.y, chord.x};
  const Vec2 direction = is_long ? across : 2 * arc.centre - arc.from - arc.to;
  return arc.centre + (arc.radius / std::sqrt(dot(direction, direction))) * direction;
}

std::array<CurvePiece, 2> split(const CurvePiece& piece, Vec2 at) {
  std::array<CurvePiece, 2> parts{piece, piece};
  parts[0].to = parts[1].from = at;
  return parts;
}

/// Appends an arc of at most half a turn, halved if it is over a third.
void append_half(const CurvePiece& arc, std::vector<CurvePiece>& pieces) {
  const double third = -0.5 * arc.radius * arc.radius;  // |a||b| cos 120 degrees
  if (dot(arc.from - arc.centre, arc.to - arc.centre) >= third) return pieces.push_back(arc);
  for (const CurvePiece& half : split(arc, middle(arc))) pieces.push_back(half);
}

/// For a point of the circle: whether it is on the piece, between the directions of its ends and not opposite
/// to them.
bool is_on_arc(const CurvePiece& piece, Vec2 point) {
  const Vec2 a = piece.from - piece.centre, b = piece.to - piece.centre, c = point - piece.centre;
  const bool between =
      piece.ccw ? cross(a, c) >= 0 && cross(c, b) >= 0 : cross(a, c) <= 0 && cross(c, b) <= 0;
  return between && dot(c, a + b) >= 0;
}

void cut_segment(const CurvePiece& piece, const Side& side, std::vector<Vec2>& cuts) {
  const double from = side.across(piece.from), to = side.across(piece.to);
  if ((from < side.value) == (to < side.value)) return;
  const double t = (side.value - from) / (to - from);
  const double along = side.along(piece.from) + t * (side.along(piece.to) - side.along(piece.from));
  if (side.has(along)) cuts.push_back(side.point(along));
}

void cut_arc(const CurvePiece& piece, const Side& side, std::vector<Vec2>& cuts) {
  const double d = side.value - side.across(piece.centre);
  const double square = (piece.radius - d) * (piece.radius + d);
  if (!(square >= 0)) return;
  const double half = std::sqrt(square);
  for (const double along : {side.along(piece.centre) - half, side.along(piece.centre) + half}) {
    if (side.has(along) && is_on_arc(piece, side.point(along))) cuts.push_back(side.point(along));
  }
}

/// The piece's crossings with the border, in the order in which it meets them, between its ends.
std::vector<Vec2> cut_points(const CurvePiece& piece, const ViewBox& box) {
  std::vector<Vec2> cuts;
  for (const Side& side : sides_of(box))
    piece.is_line ? cut_segment(piece, side, cuts) : cut_arc(piece, side, cuts);
  // Along the chord points keep their order, since the piece is no longer than half a turn.
  const Vec2 chord = piece.to - piece.from;
  std::stable_sort(cuts.begin(), cuts.end(),
                   [chord](Vec2 a, Vec2 b) { return dot(chord, a) < dot(chord, b); });
  cuts.insert(cuts.begin(), piece.from);
  cuts.push_back(piece.to);
  // A border that is only touched is not crossed; but a piece of no length stays a piece.
  if (cuts.size() > 2) cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  if (cuts.size() == 1) cuts.push_back(piece.to);
  return cuts;
}

}  // namespace

CurvePiece reversed(const CurvePiece& piece) {
  CurvePiece back = piece;
  std::swap(back.from, back.to);
  back.ccw = !piece.ccw;
  return back;
}

Vec2 middle(const CurvePiece& piece) {
  const Vec2 half = 0.5 * (piece.to - piece.from), on_chord = 0.5 * (piece.from + piece.to);
  const double r = piece.radius, square = dot(half, half);
  if (piece.is_line || !(square > 0)) return on_chord;
  // The height over the chord is r - sqrt(r^2 - h^2) for half a chord h; written as a quotient nothing
  // cancels. It is at most r also where rounding has put the ends too far apart.
  const double height = std::min(r, square / (r + std::sqrt(std::max(r * r - square, 0.0))));
  const double scale = (piece.ccw ? height : -height) / std::sqrt(square);
  return on_chord + Vec2{scale * half.y, -scale * half.x};
}

ViewBox bounds_of(std::span<const CurvePiece> pieces) {
  ViewBox box{pieces.front().from, pieces.front().from};
  const auto add = [&box](Vec2 p) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  };
  for (const CurvePiece& piece : pieces) {
    add(piece.from);
    add(piece.to);
    if (piece.is_line) continue;
    const double r = piece.radius;
    for (const Vec2 reach : {Vec2{r, 0}, Vec2{0, r}, Vec2{-r, 0}, Vec2{0, -r}})
      if (is_on_arc(piece, piece.centre + reach)) add(piece.centre + reach);
  }
  return box;
}

void append_arc(const CurvePiece& arc, bool over_half, std::vector<CurvePiece>& pieces) {
  if (!over_half) return append_half(arc, pieces);
  const auto [first, second] = split(arc, far_middle(arc));
  append_half(first, pieces);
  append_half(second, pieces);
}

void append_circle(Vec2 centre, double radius, bool ccw, std::vector<CurvePiece>& pieces) {
  const double step = ccw ? radius : -radius;
  const std::array<Vec2, 5> corners = {centre + Vec2{radius, 0}, centre + Vec2{0, step},
                                       centre - Vec2{radius, 0}, centre - Vec2{0, step},
                                       centre + Vec2{radius, 0}};
  for (std::size_t i = 0; i < 4; ++i)
    pieces.push_back({corners[i], corners[i + 1], false, centre, radius, ccw});
}

Vec2 far_along(Vec2 point, Vec2 direction, const ViewBox& box) {
  const Vec2 centre = 0.5 * (box.low + box.high), size = box.size();
  const double forth = dot(direction, centre - point);
  return point + (std::max(forth, 0.0) + 2 * (size.x + size.y)) * direction;
}

std::vector<CurveRun> clip(std::span<const CurvePiece> curve, const ViewBox& box) {
  std::vector<CurveRun> runs;
  bool inside = false, first = true;
  for (const CurvePiece& piece : curve) {
    const std::vector<Vec2> points = cut_points(piece, box);
    for (std::size_t i = 0; i + 1 < points.size(); ++i, first = false) {
      CurvePiece part = piece;
      part.from = points[i];
      part.to = points[i + 1];
      const bool was_inside = std::exchange(inside, contains(box, middle(part)));
      if (inside && !was_inside) runs.push_back({{}, !first, false});
      if (inside) runs.back().pieces.push_back(part);
      if (!inside && was_inside) runs.back().leaves = true;
    }
  }
  return runs;
}

double border_position(Vec2 point, const ViewBox& box) {
  const Vec2 size = box.size();
  const double x = std::clamp((point.x - box.low.x) / size.x, 0.0, 1.0);
  const double y = std::clamp((point.y - box.low.y) / size.y, 0.0, 1.0);
  const std::array<double, 4> gaps = {y, 1 - x, 1 - y, x};
  const std::array<double, 4> positions = {x, 1 + y, 3 - x, 4 - y};
  return positions[static_cast<std::size_t>(std::min_element(gaps.begin(), gaps.end()) - gaps.begin())];
}

Vec2 border_corner(unsigned position, const ViewBox& box) {
  return {position == 1 || position == 2 ? box.high.x : box.low.x, position >= 2 ? box.high.y : box.low.y};
}

}  // namespace crossloft
