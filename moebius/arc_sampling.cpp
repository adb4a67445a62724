#include "arc_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace crossloft {
namespace {

/// A piece of a circle (radius > 0) of at most a half turn, or of a line (radius 0).
struct Piece {
  Vec2 from, to;
  double radius = 0;
  double bulge = 0;  ///< +1 if it lies to the right of its chord (counter-clockwise), -1 to the left
};

double length(Vec2 v) { return std::sqrt(dot(v, v)); }

/// The middle of the chord, moved by `sagitta` to where the piece lies.
Vec2 pushed(const Piece& p, double sagitta) {
  const Vec2 chord = p.to - p.from;
  return 0.5 * (p.from + p.to) + (p.bulge * sagitta / length(chord)) * Vec2{chord.y, -chord.x};
}

double root_of_rest(const Piece& p, double square) {
  return std::sqrt(std::max(0.0, p.radius * p.radius - square));
}

/// The sagitta is (l/2)^2 / (R + sqrt(R^2 - (l/2)^2)): nothing cancels on a large circle.
Vec2 middle(const Piece& p) {
  const Vec2 chord = p.to - p.from;
  const double square = dot(chord, chord) / 4;
  if (p.radius == 0 || square == 0) return 0.5 * (p.from + p.to);
  return pushed(p, square / (p.radius + root_of_rest(p, square)));
}

/// The same of a piece of more than a half turn. If its ends are close it is across from them, whatever their
/// order.
Vec2 middle_of_longer(const Piece& p, Vec2 centre) {
  const Vec2 away = (centre - p.from) + (centre - p.to), chord = p.to - p.from;
  if (dot(away, away) > p.radius * p.radius) return centre + (p.radius / length(away)) * away;
  return pushed(p, p.radius + root_of_rest(p, dot(chord, chord) / 4));
}

std::array<Piece, 2> halves(const Piece& p, Vec2 mid) {
  return {Piece{p.from, mid, p.radius, p.bulge}, Piece{mid, p.to, p.radius, p.bulge}};
}

/// Whether the chord's disk, in which the piece lies, meets the box.
bool may_meet(const Piece& p, const Box2& box) {
  const Vec2 mid = 0.5 * (p.from + p.to), half = 0.5 * (p.to - p.from);
  const Vec2 nearest{std::clamp(mid.x, box.low.x, box.high.x), std::clamp(mid.y, box.low.y, box.high.y)};
  const Vec2 d = nearest - mid;
  return dot(d, d) <= 2 * dot(half, half);  // twice: room for rounding
}

bool contains(const Box2& box, Vec2 a) {
  return box.low.x <= a.x && a.x <= box.high.x && box.low.y <= a.y && a.y <= box.high.y;
}

/// The points of a piece after its begin, halved `depth` times.
void sample(const Piece& piece, int depth, const Box2& box, std::vector<Vec2>& points) {
  if (!may_meet(piece, box)) return;
  if (depth == 0) {
    if (contains(box, piece.to)) points.push_back(piece.to);
    return;
  }
  for (const Piece& half : halves(piece, middle(piece))) sample(half, depth - 1, box, points);
}

int halvings(Piece piece, double spacing) {
  int depth = 0;
  for (; length(piece.to - piece.from) > spacing && depth < 60; ++depth) piece.to = middle(piece);
  return depth;
}

/// The part of the line within the box; false if there is none.
bool clip(const FaceArc& arc, const Box2& box, Piece& piece) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Vec2 base = arc.curve.centre, direction = arc.curve.direction;
  const double from = arc.from_infinite ? -kInfinity : dot(arc.from - base, direction);
  const double to = arc.to_infinite ? kInfinity : dot(arc.to - base, direction);
  double low = from, high = to;
  const auto cut = [&](double begin, double way, double least, double most) {
    if (way == 0) {
      if (begin < least || begin > most) high = -kInfinity;
      return;
    }
    const double s = (least - begin) / way, t = (most - begin) / way;
    low = std::max(low, std::min(s, t));
    high = std::min(high, std::max(s, t));
  };
  cut(base.x, direction.x, box.low.x, box.high.x);
  cut(base.y, direction.y, box.low.y, box.high.y);
  // An end may be far from its line: a vertex where nearly parallel arcs meet is rounded along all of them.
  piece.from = low == from && contains(box, arc.from) ? arc.from : base + low * direction;
  piece.to = high == to && contains(box, arc.to) ? arc.to : base + high * direction;
  return low <= high;
}

void sample_line(const FaceArc& arc, double spacing, const Box2& box, std::vector<Vec2>& points) {
  Piece piece;
  if (!clip(arc, box, piece)) return;
  points.push_back(piece.from);
  // The ends are in the box but for rounding, so all is.
  const Box2 all{{-std::numeric_limits<double>::max(), -std::numeric_limits<double>::max()},
                 {std::numeric_limits<double>::max(), std::numeric_limits<double>::max()}};
  sample(piece, halvings(piece, spacing), all, points);
}

/// Whether the ends are where the circle is, but for an eighth of its radius: else halving leads nowhere.
bool ends_on_circle(const FaceArc& arc) {
  const auto is_on = [&](Vec2 end) {
    return std::fabs(length(end - arc.curve.centre) - arc.curve.radius) <= arc.curve.radius / 8;
  };
  return is_on(arc.from) && is_on(arc.to);
}

}  // namespace

void sample_arc(const FaceArc& arc, double spacing, const Box2& box, std::vector<Vec2>& points) {
  if (arc.curve.is_line) return sample_line(arc, spacing, box, points);
  if (!ends_on_circle(arc)) return;
  const Piece all{arc.from, arc.to, arc.curve.radius, arc.clockwise ? -1.0 : 1.0};
  if (contains(box, arc.from)) points.push_back(arc.from);
  if (!arc.whole && !arc.over_half) return sample(all, halvings(all, spacing), box, points);
  const auto parts = halves(all, middle_of_longer(all, arc.curve.centre));
  const int depth = halvings(parts[0], spacing);
  for (const Piece& part : parts) sample(part, depth, box, points);
}

}  // namespace crossloft
