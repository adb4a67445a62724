#include "cell_geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace crossloft {
namespace {

/// A step in the direction of its walk.
struct Walk {
  const MoebiusArc& arc;
  const MoebiusCurve& curve;
  std::uint32_t begin, end;
  bool backwards, ccw;

  Walk(const MoebiusDiagram& diagram, CellStep step)
      : arc(diagram.arcs[step.arc]),
        curve(arc.curve),
        begin(begin_vertex(diagram, step)),
        end(end_vertex(diagram, step)),
        backwards(step.backwards),
        ccw((diagram.sites[arc.sites[0]].lambda > diagram.sites[arc.sites[1]].lambda) != step.backwards) {}

  bool is_whole_circle() const { return !curve.is_line && begin == kNone; }
  /// Of a line, as walked.
  Vec2 direction() const { return backwards ? -curve.direction : curve.direction; }
};

/// Square of chord over radius: a flatter arc is within 1e-7 of its length from its chord, which serves
/// better than a circle whose centre is far away.
constexpr double kFlat = 1e-12;

/// (t - sin t) / 2, the area between an arc of angle t <= pi of the unit circle and its chord, from x = sin(t
/// / 2): the triangle on the chord and two segments of half the angle, again and again. All terms are
/// positive, so that flat arcs lose no digits.
double segment_area(double x) {
  double area = 0, copies = 1;
  for (int halvings = 0; halvings < 6; ++halvings) {
    const double cosine = std::sqrt(std::max(1 - x * x, 0.0));
    area += copies * (x * x * x) / (1 + cosine);
    x /= std::sqrt(2 * (1 + cosine));
    copies *= 2;
  }
  return area + copies * (x * x * x) * 2 / 3;
}

/// What the walk adds to the area of its loop, beyond its chord.
double bulge(const MoebiusDiagram& diagram, const Walk& walk) {
  if (walk.curve.is_line) return 0;
  const double r = walk.curve.radius, sign = walk.ccw ? 1 : -1;
  if (walk.is_whole_circle()) return sign * std::numbers::pi * r * r;
  const Vec2 chord = diagram.vertices[walk.end] - diagram.vertices[walk.begin];
  const double half = r > 0 ? std::min(0.5 * std::sqrt(dot(chord, chord)) / r, 1.0) : 0;
  const double area = segment_area(half);
  return sign * r * r * (walk.arc.over_half ? std::numbers::pi - area : area);
}

/// Crossings of a loop with the ray from a point to the right: +1 upwards, -1 downwards. A place on the line
/// of the ray counts as below, so that each passage counts once.
class RayCrossings {
 public:
  RayCrossings(const MoebiusDiagram& diagram, Vec2 point) : diagram_(diagram), point_(point) {}

  /// The winding number that an only step of a loop has, or what it adds.
  int of(const Walk& walk) const {
    if (walk.curve.is_line) return of_line(walk);
    if (!walk.is_whole_circle()) return of_arc(walk);
    const Vec2 d = point_ - walk.curve.centre;
    return dot(d, d) < walk.curve.radius * walk.curve.radius ? (walk.ccw ? 1 : -1) : 0;
  }

  /// From where one step ends at infinity to where the next one begins, half a turn at most: past the ray if
  /// from below to above, or half around from and to the same line on the other side of it.
  int of_infinity(const Walk& before, const Walk& after) const {
    const bool from_above = end_above(before), to_above = begin_above(after);
    if (from_above != to_above) return to_above ? 1 : 0;
    const double from = before.direction().x, to = -after.direction().x;
    return from * to < 0 && (from < 0) == from_above ? 1 : 0;
  }

 private:
  bool above(double y) const { return y > point_.y; }
  bool infinity_above(const MoebiusCurve& line, Vec2 towards) const {
    return towards.y != 0 ? towards.y > 0 : above(line.centre.y);
  }
  bool begin_above(const Walk& w) const {
    return w.begin != kNone ? above(diagram_.vertices[w.begin].y) : infinity_above(w.curve, -w.direction());
  }
  bool end_above(const Walk& w) const {
    return w.end != kNone ? above(diagram_.vertices[w.end].y) : infinity_above(w.curve, w.direction());
  }

  int crossing(bool from_above, bool to_above, double x) const {
    if (from_above == to_above || !(x > point_.x)) return 0;
    return to_above ? 1 : -1;
  }

  int of_line(const Walk& walk) const {
    const MoebiusCurve& line = walk.curve;
    const double x = line.centre.x + (point_.y - line.centre.y) / line.direction.y * line.direction.x;
    return crossing(begin_above(walk), end_above(walk), x);
  }

  /// How often the arc passes the top or the bottom of its circle, between pieces east and west of the
  /// centre. One that begins and ends on one side passes none or both; only if its ends are close that takes
  /// more than to see whether it goes up there as it should.
  static int turns(const Walk& walk, Vec2 begin, Vec2 end) {
    const MoebiusCurve& circle = walk.curve;
    const bool east = begin.x >= circle.centre.x, ends_east = end.x >= circle.centre.x;
    if (east != ends_east) return 1;
    const bool is_close = dot(end - begin, end - begin) < circle.radius * circle.radius;
    const bool is_long = is_close ? walk.arc.over_half : (east == walk.ccw) != (end.y > begin.y);
    return is_long ? 2 : 0;
  }

  int of_arc(const Walk& walk) const {
    const MoebiusCurve& circle = walk.curve;
    const Vec2 begin = diagram_.vertices[walk.begin], end = diagram_.vertices[walk.end], chord = end - begin;
    if (!walk.arc.over_half && dot(chord, chord) < kFlat * circle.radius * circle.radius)
      return crossing(above(begin.y), above(end.y), begin.x + (point_.y - begin.y) / chord.y * chord.x);
    const double dy = point_.y - circle.centre.y;
    const double reach = std::sqrt(std::max(circle.radius * circle.radius - dy * dy, 0.0));
    bool east = begin.x >= circle.centre.x, from_above = above(begin.y);
    int sum = 0;
    for (int left = turns(walk, begin, end); left >= 0; --left, east = !east) {
      const double pole = circle.centre.y + (east == walk.ccw ? circle.radius : -circle.radius);
      const bool to_above = above(left == 0 ? end.y : pole);
      sum += crossing(from_above, to_above, circle.centre.x + (east ? reach : -reach));
      from_above = to_above;
    }
    return sum;
  }

  const MoebiusDiagram& diagram_;
  Vec2 point_;
};

}  // namespace

double signed_area(const MoebiusDiagram& diagram, std::span<const CellStep> loop) {
  double twice = 0, bulges = 0;
  const std::uint32_t first = begin_vertex(diagram, loop.front());
  const Vec2 origin = first == kNone ? Vec2{} : diagram.vertices[first];
  for (const CellStep step : loop) {
    const Walk walk(diagram, step);
    bulges += bulge(diagram, walk);
    if (walk.begin != kNone)
      twice += cross(diagram.vertices[walk.begin] - origin, diagram.vertices[walk.end] - origin);
  }
  return 0.5 * twice + bulges;
}

int winding_number(const MoebiusDiagram& diagram, std::span<const CellStep> loop, Vec2 point) {
  const RayCrossings crossings(diagram, point);
  int winding = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Walk walk(diagram, loop[k]);
    winding += crossings.of(walk);
    if (walk.curve.is_line && walk.end == kNone)
      winding += crossings.of_infinity(walk, Walk(diagram, loop[(k + 1) % loop.size()]));
  }
  return winding;
}

}  // namespace crossloft
