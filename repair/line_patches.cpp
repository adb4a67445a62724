#include "line_patches.h"

#include <algorithm>
#include <cmath>

namespace crossloft {
namespace {

/// Height of a lens over the blend: the tangent of the angle between the new contour and the line.
constexpr double kSlope = 3;
/// A lens keeps off other lines by a part of the way to them.
constexpr double kOfWay = 0.7;
constexpr double kOnLine = 1e-12;

/// How far the ray from p runs to the nearest other line of the plane.
double way_to_lines(const PlaneLines& plane, const CommonLine& own, Vec3 p, Vec3 ray) {
  double way = HUGE_VAL;
  for (const CommonLine* line : plane.lines) {
    if (line == &own) continue;
    const Vec3 aside = cross(plane.section.plane().normal, line->direction);
    const double speed = dot(aside, ray), off = dot(aside, line->point - p);
    if (std::fabs(off) <= kOnLine * own.reach) return 0;
    if (const double s = off / speed; speed != 0 && s > 0) way = std::min(way, s);
  }
  return way;
}

class LensShape {
 public:
  LensShape(const PlaneLines& plane, const CommonLine& line, const LineTarget& target, const TargetSpan& span,
            std::span<const Misfit> misfits)
      : plane_(plane), line_(line), target_(target), span_(span), misfits_(misfits) {
    for (const Misfit& m : misfits) {
      double size = std::min(std::max(blend(m.begin), blend(m.end)), m.depth);
      for (const double t : target.nodes)
        if (t > m.begin && t < m.end) size = std::max(size, std::min(blend(t), m.depth));
      sizes_.push_back(size);
      deepest_ = std::max(deepest_, m.depth);
    }
  }

  /// At a point of the line, to one side of it.
  double height(double t, Vec3 ray) const {
    double fall = 0;
    for (std::size_t k = 0; k < misfits_.size(); ++k) {
      const Misfit& m = misfits_[k];
      const double beyond = std::max({0.0, m.begin - t, t - m.end});
      fall = std::max(fall, kSlope * sizes_[k] - beyond);
    }
    const Vec3 p = line_.at(t);
    double h = std::min({fall, kSlope * blend(t), kOfWay * way_to_lines(plane_, line_, p, ray)});
    for (int halvings = 0; h > 0 && goes_too_far(p + h * ray); ++halvings) h = halvings < 8 ? h / 2 : 0;
    return h;
  }

 private:
  double blend(double t) const { return std::fabs(target_.blend_at(t)); }
  bool goes_too_far(Vec3 p) const {
    return plane_.section.inside(p) != (span_.state == Inside::yes) && plane_.section.distance(p) > deepest_;
  }

  const PlaneLines& plane_;
  const CommonLine& line_;
  const LineTarget& target_;
  const TargetSpan& span_;
  std::span<const Misfit> misfits_;
  std::vector<double> sizes_;  ///< by misfit: the largest blend in it
  double deepest_ = 0;
};

void add_corner(Patch& patch, Vec3 p, bool fixed) {
  patch.corners.push_back(p);
  patch.fixed.push_back(fixed);
}

/// True iff p and q are on one side of each other line of the plane, and neither on one.
bool same_face(const PlaneLines& plane, const CommonLine& own, Vec3 p, Vec3 q) {
  return std::all_of(plane.lines.begin(), plane.lines.end(), [&](const CommonLine* line) {
    const Vec3 aside = cross(plane.section.plane().normal, line->direction);
    return line == &own || dot(aside, p - line->point) * dot(aside, q - line->point) > 0;
  });
}

}  // namespace

Patch lens(const PlaneLines& plane, const CommonLine& line, const LineTarget& target, const TargetSpan& span,
           std::span<const Misfit> misfits) {
  const LensShape shape(plane, line, target, span, misfits);
  const Vec3 aside = cross(plane.section.plane().normal, line.direction);
  std::vector<double> inner;
  for (const double t : target.nodes)
    if (t > span.begin && t < span.end) inner.push_back(t);
  Patch patch;
  patch.kind = span.state == Inside::yes ? LayerKind::added : LayerKind::removed;
  add_corner(patch, line.at(span.begin), true);
  for (const double t : inner) add_corner(patch, line.at(t) + shape.height(t, aside) * aside, false);
  add_corner(patch, line.at(span.end), true);
  std::reverse(inner.begin(), inner.end());
  for (const double t : inner) add_corner(patch, line.at(t) - shape.height(t, -aside) * aside, false);
  return patch;
}

bool bridge(const PlaneLines& plane, const CommonLine& line, const LineTarget& target, const TargetSpan& span,
            Patch& patch) {
  if (plane.section.empty()) return false;
  double deepest = span.begin / 2 + span.end / 2;
  for (const double t : target.nodes)
    if (t > span.begin && t < span.end && target.blend_at(t) < target.blend_at(deepest)) deepest = t;
  const Vec3 from = line.at(deepest);
  std::uint32_t contour = kNone;
  const Vec3 way = plane.section.nearest(from, contour) - from;
  const double length = norm(way);
  if (!(length > 0)) return false;
  double width = std::min(deepest - span.begin, span.end - deepest) / 2;
  const Vec3 aside = cross(plane.section.plane().normal, line.direction);
  for (int halvings = 0; halvings < 6; ++halvings, width /= 2) {
    const Vec3 foot = width * line.direction, to = from + (1 + std::min(width / length, 0.5)) * way;
    const Vec3 left = to - 0.5 * foot, right = to + 0.5 * foot;
    const bool clear = same_face(plane, line, from - foot, left) && same_face(plane, line, from + foot, right) &&
                       same_face(plane, line, left, right) &&
                       dot(aside, left - line.point) * dot(aside, way) > 0;
    if (!clear) continue;
    patch = {LayerKind::added, {from - foot, from + foot, right, left}, {false, false, false, false}};
    return true;
  }
  return false;
}

}  // namespace crossloft
