#include "arc_trace.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "nearest_site.h"

namespace crossloft {
namespace {

double length(Vec2 v) { return std::sqrt(dot(v, v)); }

/// So near on a circle that rounding may have changed the order of the ends. Where circles nearly touch, ends
/// are known to half the digits only; `scale` is the size of what is around them.
bool ends_nearly_coincide(const MoebiusCurve& circle, Vec2 from, Vec2 to, double scale) {
  constexpr double kTiny = 1e-6, kRounding = 1e-13;
  return length(to - from) <= kTiny * std::min(circle.radius, scale) + kRounding * length(from);
}

bool ends_nearly_coincide(const MoebiusDiagram& diagram, const MoebiusArc& arc) {
  const Vec2 from = diagram.vertices[arc.from], to = diagram.vertices[arc.to];
  const double scale =
      length(from - diagram.sites[arc.sites[0]].p) + length(from - diagram.sites[arc.sites[1]].p);
  return ends_nearly_coincide(arc.curve, from, to, scale);
}

bool same_sites(const MoebiusArc& a, const MoebiusArc& b) {
  return a.sites == b.sites || (a.sites[0] == b.sites[1] && a.sites[1] == b.sites[0]);
}

/// True if none is nearer to x than the site, but for rounding.
bool is_nearest(std::span<const MoebiusSite> sites, const MoebiusSite& site, Vec2 x) {
  constexpr double kRounding = 1e-9;
  const auto size = [x](const MoebiusSite& s) {
    return std::abs(s.mu) + std::abs(s.lambda) * dot(x - s.p, x - s.p);
  };
  const MoebiusSite& nearest = sites[nearest_site(sites, x)];
  return distance_from(site, x) - distance_from(nearest, x) <= kRounding * (size(site) + size(nearest));
}

/// For an arc whose ends nearly coincide: it is whole if no site is nearer on the far side of the circle (at
/// three points, since one may be a vertex), and if nothing else of the circle is an arc: of several at one
/// point the first is taken.
bool is_nearly_whole(const MoebiusDiagram& diagram, const MoebiusArc& arc) {
  const bool shared = std::any_of(diagram.arcs.begin(), diagram.arcs.end(), [&](const MoebiusArc& other) {
    return same_sites(arc, other) && (&other < &arc || !ends_nearly_coincide(diagram, other));
  });
  const Vec2 back = arc.curve.centre - diagram.vertices[arc.from];
  constexpr std::array<double, 3> kSlopes = {-0.7133, 0.0129, 0.6317};
  return !shared && std::all_of(kSlopes.begin(), kSlopes.end(), [&](double slope) {
    const Vec2 turned = (1 / std::sqrt(1 + slope * slope)) * (back + slope * Vec2{-back.y, back.x});
    return is_nearest(diagram.sites, diagram.sites[arc.sites[0]], arc.curve.centre + turned);
  });
}

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
  if (!arc.from || !arc.to)
    append_circle(centre, radius, arc.ccw, pieces);
  else if (ends_nearly_coincide(arc.curve, *arc.from, *arc.to, larger_side(box)))
    pieces.push_back(segment(*arc.from, *arc.to));
  else
    append_arc(*arc.from, *arc.to, centre, radius, arc.ccw, pieces);
  return straightened_if_huge(pieces, box);
}

std::vector<CurvePiece> trace_line(const ArcShape& arc, const ViewBox& box) {
  const Vec2 direction = arc.curve.direction, point = arc.curve.centre;
  const Vec2 from = arc.from ? *arc.from : far_along(arc.to.value_or(point), -direction, box);
  const Vec2 to = arc.to ? *arc.to : far_along(arc.from.value_or(point), direction, box);
  return {segment(from, to)};
}

/// All but a whole circle: by way of the point opposite its ends.
std::vector<CurvePiece> trace_nearly_whole(const ArcShape& arc) {
  const auto& [is_line, centre, radius, direction] = arc.curve;
  const Vec2 opposite = 2 * centre - *arc.from;
  std::vector<CurvePiece> pieces;
  append_arc(*arc.from, opposite, centre, radius, arc.ccw, pieces);
  append_arc(opposite, *arc.to, centre, radius, arc.ccw, pieces);
  return pieces;
}

}  // namespace

std::vector<CurvePiece> trace(const ArcShape& arc, const ViewBox& box) {
  return arc.curve.is_line ? trace_line(arc, box) : trace_circle(arc, box);
}

std::vector<CurvePiece> trace(const MoebiusDiagram& diagram, const MoebiusArc& arc, const ViewBox& box) {
  ArcShape shape{arc.curve, diagram.sites[arc.sites[0]].lambda > diagram.sites[arc.sites[1]].lambda, {}, {}};
  if (arc.from != kNone) shape.from = diagram.vertices[arc.from];
  if (arc.to != kNone) shape.to = diagram.vertices[arc.to];
  const bool has_ends = shape.from && shape.to;
  if (!arc.curve.is_line && has_ends && ends_nearly_coincide(diagram, arc) && is_nearly_whole(diagram, arc))
    return trace_nearly_whole(shape);
  return trace(shape, box);
}

}  // namespace crossloft
