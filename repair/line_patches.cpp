#include "line_patches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "../geom/disjoint_sets.h"

namespace crossloft {
namespace {

/// A lens keeps off other lines by a part of the way to them.
constexpr double kOfWay = 0.7;
/// A correction goes down to that of another line within the way to it: what a contour needs next to a point
/// that stays where it is grows with the distance from it, by slope 1 at most.
constexpr double kSteepest = 1.25;
constexpr double kOnLine = 1e-12;
/// Flatness of the rays at the ends of a span: way along the line over way beside it.
constexpr std::array kFan{4.0, 2.0, 1.0, 0.5, 0.25, 0.0};
/// Samples of a ray, and of its beginning.
constexpr int kAlongRay = 24, kBeginning = 6, kBisections = 8;

/// How far the ray from p runs to the nearest other line of the plane.
double way_to_lines(const PlaneLines& plane, const CommonLine& own, Vec3 p, Vec3 ray) {
  double way = HUGE_VAL;
  for (const LineInPlane& in_plane : plane.lines) {
    const CommonLine* line = in_plane.line;
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
  LensShape(const PlaneLines& plane, std::size_t line, const TargetSpan& span, double least)
      : plane_(plane), line_(*plane.lines[line].line), inside_(span.state == Inside::yes), least_(least) {
    const LineInPlane& own = plane.lines[line];
    for (const Correction& c : own.corrections) {
      if (c.inside() != inside_) continue;
      corrections_.push_back(&c);
      c.add_samples(samples_);
      reach_ = std::max(reach_, c.reach());
    }
    samples_.insert(samples_.end(), own.target->nodes.begin(), own.target->nodes.end());
    std::sort(samples_.begin(), samples_.end());
    samples_.erase(std::unique(samples_.begin(), samples_.end()), samples_.end());
    std::erase_if(samples_,
                  [&](double t) { return t <= span.begin || t >= span.end || own_correction(t, 0) == 0; });
  }

  const std::vector<double>& samples() const { return samples_; }
  bool is_near(double t) const {
    return std::any_of(corrections_.begin(), corrections_.end(),
                       [&](const Correction* c) { return c->is_near(t); });
  }
  bool is_misfit(double t) const {
    return std::any_of(corrections_.begin(), corrections_.end(),
                       [&](const Correction* c) { return c->holds(t); });
  }

  /// At a point of the line, to each side of it. It has no height on one side alone: a contour would run
  /// along the line.
  std::array<double, 2> heights(double t, Vec3 aside) const {
    std::array<double, 2> h{};
    for (const int side : {0, 1}) {
      const Ray ray = ray_from(t, side == 0 ? aside : -aside);
      const double floor = is_near(t) ? std::min(least_, ray.room) : 0;
      h[static_cast<std::size_t>(side)] = belongs(ray, 0) ? std::max(length(ray), floor) : floor;
    }
    return h[0] > 0 && h[1] > 0 ? h : std::array<double, 2>{0, 0};
  }

  /// Ends of slanted rays from an end of the span, the flattest first: where the contour runs at a small
  /// angle to the line, the lens has to reach beyond the span's end without touching the line there.
  std::vector<Vec3> fan(double t, Vec3 outwards, Vec3 aside) const {
    std::vector<Vec3> ends;
    if (!is_misfit(t)) return ends;
    for (const double flatness : kFan) {
      const Vec3 slanted = aside + flatness * outwards;
      const Ray ray = ray_from(t, (1 / norm(slanted)) * slanted);
      if (const double l = ray.room > 0 ? length(ray) : 0; l > least_ / 2)
        ends.push_back(ray.from + l * ray.direction);
    }
    return ends;
  }

 private:
  struct Ray {
    Vec3 from, direction;
    double t = 0;      ///< where it begins
    double along = 0;  ///< the line, of a step
    double off = 0;    ///< the line, of a step
    double room = 0;   ///< how far it may run
  };

  Ray ray_from(double t, Vec3 direction) const {
    Ray ray{line_.at(t), direction, t, dot(direction, line_.direction), 0, 0};
    ray.room = std::min(2 * reach_, kOfWay * way_to_lines(plane_, line_, ray.from, direction));
    ray.off = std::sqrt(std::max(0.0, 1 - ray.along * ray.along));
    return ray;
  }

  double own_correction(double t, double s) const {
    double size = 0;
    for (const Correction* c : corrections_) size = std::max(size, (*c)(t, s));
    return size;
  }

  /// No larger than what another line asks for, but for the way to it.
  double correction(const Ray& ray, double s) const {
    double size = own_correction(ray.t + s * ray.along, s * ray.off);
    const Vec3 p = ray.from + s * ray.direction;
    for (const LineInPlane& other : plane_.lines) {
      if (size == 0 || other.line == &line_) continue;
      const double t = other.line->parameter(p), way = norm(p - other.line->at(t));
      double theirs = 0;
      for (const Correction& c : other.corrections)
        if (c.inside() == inside_) theirs = std::max(theirs, c(t, 0));
      size = std::min(size, theirs + kSteepest * way);
    }
    return size;
  }

  /// f and the correction are on the span's side.
  bool belongs(const Ray& ray, double s) const {
    if (!(ray.room > 0)) return false;
    const double f = plane_.section.signed_distance(ray.from + s * ray.direction);
    return (inside_ ? f : -f) < correction(ray, s);
  }

  /// Up to where all of the ray belongs. Its beginning is not asked: from an end of the span it is on the
  /// border of what belongs.
  double length(const Ray& ray) const {
    int k = 1;
    while (k < kBeginning && !belongs(ray, ray.room * k / kAlongRay)) ++k;
    while (k <= kAlongRay && belongs(ray, ray.room * k / kAlongRay)) ++k;
    if (k > kAlongRay) return ray.room;
    if (k == kBeginning && !belongs(ray, ray.room * (k - 1) / kAlongRay)) return 0;
    double in = ray.room * (k - 1) / kAlongRay, out = ray.room * k / kAlongRay;
    for (int i = 0; i < kBisections; ++i) (belongs(ray, in / 2 + out / 2) ? in : out) = in / 2 + out / 2;
    return in;
  }

  const PlaneLines& plane_;
  const CommonLine& line_;
  bool inside_;
  double least_, reach_ = 0;
  std::vector<const Correction*> corrections_;
  std::vector<double> samples_;
};

void add_corner(Patch& patch, Vec3 p, bool fixed) {
  patch.corners.push_back(p);
  patch.fixed.push_back(fixed);
}

}  // namespace

Patch lens(const PlaneLines& plane, std::size_t number, const TargetSpan& span, double least) {
  const LensShape shape(plane, number, span, least);
  const CommonLine& line = *plane.lines[number].line;
  const Vec3 aside = cross(plane.section.plane().normal, line.direction);
  std::array<std::vector<Vec3>, 2> chains;  // above and below the line
  for (const std::size_t side : {0u, 1u})
    chains[side] = shape.fan(span.begin, -line.direction, side ? -aside : aside);
  bool reached = shape.is_misfit(span.begin);  // by a part with height
  for (const double t : shape.samples()) {
    const auto [up, down] = shape.heights(t, aside);
    if (!reached && up > 0) {
      // The lens begins here, on the line, and not at the span's end, which stays as it is.
      chains[0].push_back(line.at(t));
      chains[1].push_back(line.at(t));
    }
    reached |= up > 0;
    if (!reached) continue;
    chains[0].push_back(line.at(t) + up * aside);
    chains[1].push_back(line.at(t) - down * aside);
  }
  for (const std::size_t side : {0u, 1u}) {
    const std::vector<Vec3> end = shape.fan(span.end, line.direction, side ? -aside : aside);
    chains[side].insert(chains[side].end(), end.rbegin(), end.rend());
  }
  Patch patch;
  patch.kind = span.state == Inside::yes ? LayerKind::added : LayerKind::removed;
  if (shape.is_misfit(span.begin)) add_corner(patch, line.at(span.begin), true);
  for (const Vec3& p : chains[0]) add_corner(patch, p, false);
  if (shape.is_misfit(span.end)) add_corner(patch, line.at(span.end), true);
  for (std::size_t k = chains[1].size(); k-- > 0;) add_corner(patch, chains[1][k], false);
  return patch;
}

Patch plug(const PlaneLines& plane, Vec3 point, const std::vector<const CommonLine*>& through, bool inside,
           double radius) {
  Vec3 u;
  for (const LineInPlane& l : plane.lines) {
    if (!l.target || std::find(through.begin(), through.end(), l.line) == through.end()) continue;
    u = l.line->direction;
    const double t = l.line->parameter(point);
    for (const TargetSpan& span : l.target->spans)
      if (span.begin <= t && t <= span.end)
        radius = std::min({radius, (t - span.begin) / 2, (span.end - t) / 2});
  }
  Patch patch;
  patch.kind = inside ? LayerKind::added : LayerKind::removed;
  const Vec3 v = cross(plane.section.plane().normal, u);
  for (const auto& [x, y] : {std::pair{4, 1}, {1, 4}, {-1, 4}, {-4, 1}, {-4, -1}, {-1, -4}, {1, -4}, {4, -1}})
    add_corner(patch, point + (radius * x / 4) * u + (radius * y / 4) * v, false);
  return patch;
}

std::uint32_t drop_crumbs(PlaneSection& section, const PlaneLines& plane, double size) {
  DisjointSets parts(section.vertices.size());
  for (const ContourEdge& e : section.edges) parts.join(e.a, e.b);
  struct Part {
    Bounds box;
    bool fresh = false, meets_line = false;
  };
  std::map<std::uint32_t, Part> found;
  for (const ContourEdge& e : section.edges) {
    Part& part = found[parts.find(e.a)];
    const Vec3 a = section.vertices[e.a], b = section.vertices[e.b];
    part.box.add(a), part.box.add(b);
    part.fresh |= e.contour == kNone;
    for (const LineInPlane& l : plane.lines) {
      const Vec3 aside = cross(plane.section.plane().normal, l.line->direction);
      const double on = kOnLine * l.line->reach, s = dot(aside, a - l.line->point),
                   t = dot(aside, b - l.line->point);
      part.meets_line |= std::fabs(s) <= on || std::fabs(t) <= on || (s < 0) != (t < 0);
    }
  }
  std::erase_if(found, [&](const auto& entry) {
    return !entry.second.fresh || entry.second.meets_line || entry.second.box.diagonal() > size;
  });
  std::erase_if(section.edges, [&](const ContourEdge& e) { return found.contains(parts.find(e.a)); });
  return static_cast<std::uint32_t>(found.size());
}

}  // namespace crossloft
