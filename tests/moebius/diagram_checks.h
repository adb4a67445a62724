#pragma once
// A Moebius diagram against its definition: brute-force argmin.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "../../moebius/diagram.h"

namespace crossloft::test {

using Sites = std::vector<MoebiusSite>;

inline double distance(const MoebiusSite& s, Vec2 x) { return s.lambda * dot(x - s.p, x - s.p) - s.mu; }

inline std::uint32_t nearest(const Sites& sites, Vec2 x) {
  std::uint32_t best = 0;
  for (std::uint32_t i = 1; i < sites.size(); ++i)
    if (distance(sites[i], x) < distance(sites[best], x)) best = i;
  return best;
}

inline double length(Vec2 v) { return std::sqrt(dot(v, v)); }

/// An arc as a parameter s in 0..1 of its point and direction; infinite ends are cut at `reach` beyond.
class ArcPath {
 public:
  ArcPath(const MoebiusDiagram& diagram, const MoebiusArc& arc, double reach) : curve_(arc.curve) {
    const Vec2* from = arc.from == kNone ? nullptr : &diagram.vertices[arc.from];
    const Vec2* to = arc.to == kNone ? nullptr : &diagram.vertices[arc.to];
    if (curve_.is_line) {
      const auto along = [&](Vec2 p) { return dot(p - curve_.centre, curve_.direction); };
      begin_ = from ? along(*from) : std::min(to ? along(*to) : 0, 0.0) - reach;
      end_ = to ? along(*to) : std::max(from ? along(*from) : 0, 0.0) + reach;
      return;
    }
    ccw_ = diagram.sites[arc.sites[0]].lambda > diagram.sites[arc.sites[1]].lambda;
    begin_ = from ? angle(*from) : 0;
    end_ = to ? angle(*to) : begin_;
    const double turn = 2 * std::numbers::pi * (ccw_ ? 1 : -1), sweep = end_ - begin_;
    const bool is_tiny = from && std::abs(std::remainder(sweep, turn)) < 1e-6;
    if (is_tiny)
      end_ = begin_ + std::remainder(sweep, turn) + (arc.over_half ? turn : 0);
    else if (!from || (ccw_ ? end_ < begin_ : end_ > begin_))
      end_ += turn;
    const double beyond_half = std::abs(end_ - begin_) - std::numbers::pi;
    half_is_right_ = !from || is_tiny || std::abs(beyond_half) < 1e-6 || arc.over_half == (beyond_half > 0);
  }

  bool half_is_right() const { return half_is_right_; }
  /// The part of the whole turn, or the length: how far apart the ends are.
  double extent() const { return curve_.is_line ? end_ - begin_ : std::abs(end_ - begin_) * curve_.radius; }
  Vec2 point(double s) const {
    const double t = begin_ + s * (end_ - begin_);
    if (curve_.is_line) return curve_.centre + t * curve_.direction;
    return curve_.centre + curve_.radius * Vec2{std::cos(t), std::sin(t)};
  }
  /// Unit normal to the left.
  Vec2 left(double s) const {
    if (curve_.is_line) return {-curve_.direction.y, curve_.direction.x};
    const double t = begin_ + s * (end_ - begin_);
    return (ccw_ ? -1.0 : 1.0) * Vec2{std::cos(t), std::sin(t)};
  }
  /// How far a point next to the curve is from the arc, along it and across it.
  double distance(Vec2 p) const {
    const Vec2 d = p - curve_.centre;
    if (curve_.is_line) {
      const double t = dot(d, curve_.direction), beyond = std::max({begin_ - t, t - end_, 0.0});
      return std::abs(cross(curve_.direction, d)) + beyond;
    }
    const double low = std::min(begin_, end_), high = std::max(begin_, end_), turn = 2 * std::numbers::pi;
    double a = angle(p);
    while (a < low) a += turn;
    while (a - turn >= low) a -= turn;
    const double beyond = a <= high ? 0 : std::min(a - high, low + turn - a);
    return std::abs(length(d) - curve_.radius) + beyond * curve_.radius;
  }

 private:
  double angle(Vec2 p) const { return std::atan2(p.y - curve_.centre.y, p.x - curve_.centre.x); }

  MoebiusCurve curve_;
  bool ccw_ = true, half_is_right_ = true;
  double begin_ = 0, end_ = 0;
};

inline std::string describe(const Sites& sites) {
  std::string text;
  for (const MoebiusSite& s : sites)
    text += std::to_string(s.p.x) + " " + std::to_string(s.p.y) + " " + std::to_string(s.lambda) + " " +
            std::to_string(s.mu) + "\n";
  return text;
}

/// Site i is nearest at x, to within `slack`.
inline bool is_nearest(const Sites& sites, std::uint32_t i, Vec2 x, double slack) {
  return distance(sites[i], x) <= distance(sites[nearest(sites, x)], x) + slack;
}

/// Along every arc both sites are nearest, equally, and left and right of it the right one of them is. Number
/// of failures.
inline int wrong_arcs(const MoebiusDiagram& diagram, double reach) {
  int wrong = 0;
  for (const MoebiusArc& arc : diagram.arcs) {
    const ArcPath path(diagram, arc, reach);
    wrong += !path.half_is_right();
    for (const double s : {0.03, 0.31, 0.5, 0.77, 0.98}) {
      const Vec2 x = path.point(s);
      if (length(x) > 1e6) continue;
      const double size = 1 + dot(x, x), slack = 1e-9 * size;
      bool sound = is_nearest(diagram.sites, arc.sites[0], x, slack) &&
                   is_nearest(diagram.sites, arc.sites[1], x, slack);
      for (const double side : {1.0, -1.0}) {
        const Vec2 beside = x + side * 1e-4 * path.left(s);
        const double lead =
            distance(diagram.sites[arc.sites[0]], beside) - distance(diagram.sites[arc.sites[1]], beside);
        if (std::abs(lead) > slack && path.extent() > 1e-3) sound = sound && (lead < 0) == (side > 0);
      }
      wrong += !sound;
    }
  }
  return wrong;
}

/// Wherever the nearest site changes along the lines of a grid, an arc of these two sites passes. Number of
/// failures.
inline int missing_arcs(const MoebiusDiagram& diagram, double extent, int steps) {
  const auto& sites = diagram.sites;
  int missing = 0;
  const auto probe = [&](Vec2 a, Vec2 b) {
    std::uint32_t i = nearest(sites, a), j = nearest(sites, b);
    if (i == j) return;
    for (int k = 0; k < 60;
         ++k) {  // to the last change; the part where i is nearest may not be connected, which does no harm
      const Vec2 middle = 0.5 * (a + b);
      if (const std::uint32_t m = nearest(sites, middle); m == i)
        a = middle;
      else
        b = middle, j = m;
    }
    const double slack = 1e-6 * (1 + extent);
    for (const MoebiusArc& arc : diagram.arcs) {
      const std::array<std::uint32_t, 2> pair{std::min(i, j), std::max(i, j)};
      if ((arc.sites == pair || arc.sites == std::array{pair[1], pair[0]}) &&
          ArcPath(diagram, arc, 1e6).distance(a) < slack)
        return;
    }
    // Where several sites are nearly equal, any of their arcs will do.
    for (const MoebiusArc& arc : diagram.arcs)
      if (is_nearest(sites, arc.sites[0], a, 1e-7 * (1 + dot(a, a))) &&
          is_nearest(sites, arc.sites[1], a, 1e-7 * (1 + dot(a, a))) &&
          ArcPath(diagram, arc, 1e6).distance(a) < 1e-3)
        return;
    ++missing;
  };
  const auto at = [&](int x, int y) {
    const double step = 2 * extent / steps;
    return Vec2{-extent + (x + 0.123) * step, -extent + (y + 0.456) * step};
  };
  for (int y = 0; y < steps; ++y)
    for (int x = 0; x < steps; ++x) probe(at(x, y), at(x + 1, y)), probe(at(x, y), at(x, y + 1));
  return missing;
}

inline MoebiusDiagram diagram_of(const Sites& sites) {
  auto diagram = moebius_diagram(sites);
  REQUIRE(diagram.ok());
  return std::move(diagram.value());
}

/// The diagram, checked in every way.
inline MoebiusDiagram checked(const Sites& sites, double extent, int steps) {
  MoebiusDiagram diagram = diagram_of(sites);
  INFO(describe(sites));
  CHECK(verify(diagram) == "");
  CHECK(wrong_arcs(diagram, 10 * extent) == 0);
  CHECK(missing_arcs(diagram, extent, steps) == 0);
  return diagram;
}

}  // namespace crossloft::test
