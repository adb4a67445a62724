#include "section_overlay.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace crossloft {
namespace {

double length(Vec2 v) { return std::sqrt(dot(v, v)); }

/// The strand's curve as the zeros of k |y|^2 - 2 n.y, y seen from its begin: negative on the side of the
/// unit normal n, which is that of the centre (left of a line).
struct LocalCurve {
  double curvature;
  Vec2 normal;

  explicit LocalCurve(const Strand& s) : curvature(s.curvature) {
    const Vec2 chord = s.to - s.from;
    const double l = length(chord), sine = std::min(1.0, 0.5 * l * curvature);
    const Vec2 along = (1 / l) * chord, left{-along.y, along.x};
    normal = sine * along + (s.bulge * std::sqrt((1 - sine) * (1 + sine))) * left;
  }
  double at(Vec2 y) const { return curvature * dot(y, y) - 2 * dot(normal, y); }
};

/// Roots of a t^2 + 2 b t + c, the lower one first. REQUIRES: a >= 0, b^2 >= a c but for rounding.
std::array<double, 2> roots(double a, double b, double c) {
  const double s = std::sqrt(std::max(0.0, b * b - a * c)), q = b >= 0 ? -(b + s) : s - b;
  const double far = a > 0 ? q / a : (q >= 0 ? 2.0 : -2.0), near = q != 0 ? c / q : 0;
  return {std::min(near, far), std::max(near, far)};
}

bool on_strand(const Strand& strand, const WallCrossing& crossing) {
  if (!(crossing.along_strand >= 0 && crossing.along_strand <= 1)) return false;
  return strand.curvature == 0 ||
         strand.bulge * cross(strand.to - strand.from, crossing.at - strand.from) <= 0;
}

}  // namespace

void split_arc(const FaceArc& arc, std::uint32_t number, const Box2& box, std::vector<Strand>& strands) {
  const MoebiusCurve& curve = arc.curve;
  if (curve.is_line) {
    const Vec2 reach = box.high - box.low, to_box = box.low - curve.centre;
    const Vec2 far = (2 * (length(reach) + length(to_box))) * curve.direction;
    strands.push_back({arc.from_infinite ? curve.centre - far : arc.from,
                       arc.to_infinite ? curve.centre + far : arc.to, 0, 1, number});
    return;
  }
  const double bulge = arc.clockwise ? -1 : 1;
  const Strand all{arc.from, arc.to, 1 / curve.radius, bulge, number};
  if (!arc.whole && !arc.over_half) {
    if (arc.from != arc.to) strands.push_back(all);
    return;
  }
  const Vec2 across = 2 * curve.centre - arc.from;
  strands.push_back({arc.from, across, all.curvature, bulge, number});
  if (arc.to != across) strands.push_back({across, arc.to, all.curvature, bulge, number});
}

void cross_wall(const Strand& strand, const DirectedWall& wall, std::vector<WallCrossing>& crossings) {
  const LocalCurve curve(strand);
  const Vec2 a = wall.from - strand.from, b = wall.to - strand.from, d = b - a,
             chord = strand.to - strand.from;
  const double at_a = curve.at(a), at_b = curve.at(b);
  const bool a_within = at_a < 0, b_within = at_b < 0;
  const double square = curve.curvature * dot(d, d),
               half = curve.curvature * dot(a, d) - dot(curve.normal, d);
  // From outside to outside the wall may pass through the circle.
  const bool twice = !a_within && !b_within && half < 0 && square + half > 0 && half * half > square * at_a;
  if (a_within == b_within && !twice) return;
  const auto [first, second] = roots(square, half, at_a);
  const auto add = [&](double t, bool inwards) {
    WallCrossing crossing{kNone, kNone, 0, std::clamp(t, 0.0, 1.0), false, {}};
    const Vec2 y = a + crossing.along_wall * d;
    crossing.at = strand.from + y;
    crossing.along_strand = dot(y, chord) / dot(chord, chord);
    // A wall that comes from the strand's left to its right has the strand come from its right to its left:
    // into the section.
    crossing.enters = inwards == (strand.bulge < 0);
    if (on_strand(strand, crossing)) crossings.push_back(crossing);
  };
  if (twice || b_within) add(first, true);
  if (twice || a_within) add(second, false);
}

double twice_area(const Strand& strand, Vec2 p, Vec2 q) {
  double area = cross(p, q);
  const Vec2 chord = q - p;
  double half = 0.5 * length(chord), count = 1;
  // The segment over the chord: a triangle, and two smaller segments over its sides.
  for (int round = 0; round < 30 && strand.curvature > 0; ++round, count *= 2) {
    const double sine = std::min(1.0, half * strand.curvature);
    const double sagitta = half * sine / (1 + std::sqrt((1 - sine) * (1 + sine)));
    area += strand.bulge * count * 2 * half * sagitta;
    half = 0.5 * std::sqrt(half * half + sagitta * sagitta);
  }
  return area;
}

}  // namespace crossloft
