#include "section_trace.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "section_edit.h"
#include "segment_distance.h"

namespace crossloft {
namespace {

/// An end of a wall seen from the line: how far along it, and how far beside it (0 if on it).
struct Beside {
  double along = 0, off = 0;
};

/// Adds where the wall leads over the line, the line moved aside by an infinitesimal to the given side.
void add_cut(const Beside& a, const Beside& b, bool up, std::vector<double>& cuts) {
  const auto above = [&](const Beside& e) { return e.off == 0 ? !up : e.off > 0; };
  if (above(a) == above(b)) return;
  cuts.push_back(a.off == 0   ? a.along
                 : b.off == 0 ? b.along
                              : a.along + (b.along - a.along) * (a.off / (a.off - b.off)));
}

bool odd_before(const std::vector<double>& cuts, double t) {
  return (std::lower_bound(cuts.begin(), cuts.end(), t) - cuts.begin()) % 2 != 0;
}

/// What both neighbours of the line say; where they differ a contour runs along it.
Trace combined(std::vector<double> up, std::vector<double> down) {
  std::sort(up.begin(), up.end());
  std::sort(down.begin(), down.end());
  std::vector<double> all = up;
  all.insert(all.end(), down.begin(), down.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  Trace trace{{}, {Inside::no}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    const double middle = k + 1 < all.size() ? all[k] / 2 + all[k + 1] / 2 : all[k] + 1;
    const bool u = odd_before(up, middle), d = odd_before(down, middle);
    const Inside state = u != d ? Inside::either : u ? Inside::yes : Inside::no;
    if (state == trace.states.back()) continue;
    trace.cuts.push_back(all[k]);
    trace.states.push_back(state);
  }
  return trace;
}

}  // namespace

Inside Trace::between(double t0, double t1) const {
  const double middle = t0 / 2 + t1 / 2;
  return states[static_cast<std::size_t>(std::upper_bound(cuts.begin(), cuts.end(), middle) - cuts.begin())];
}

SectionBoundary::SectionBoundary(const PlaneSection& section, const UnitPlane& plane, const PlaneChart& chart)
    : plane_(plane), chart_(chart) {
  std::vector<Bounds> boxes;
  for (const ContourEdge& e : section.edges) {
    if (!is_wall(e)) continue;
    // In one order: nothing is to depend on the direction of the edge.
    const auto [a, b] = std::minmax(section.vertices[e.a], section.vertices[e.b]);
    walls_.push_back({a, b, chart.to_grid(a), chart.to_grid(b), e.contour});
    boxes.emplace_back();
    boxes.back().add(a), boxes.back().add(b);
  }
  if (!boxes.empty()) tree_ = std::make_unique<BoxTree>(boxes);
}

Trace SectionBoundary::trace(const CommonLine& line, double on) const {
  const Vec3 aside = cross(plane_.normal, line.direction);
  const auto seen = [&](Vec3 p) {
    const double off = dot(aside, p - line.point);
    return Beside{line.parameter(p), std::fabs(off) <= on ? 0 : off};
  };
  std::vector<double> up, down;
  for (const WallSegment& w : walls_) {
    const Beside a = seen(w.a), b = seen(w.b);
    add_cut(a, b, true, up);
    add_cut(a, b, false, down);
  }
  return combined(std::move(up), std::move(down));
}

double SectionBoundary::distance(Vec3 p) const {
  if (empty()) return std::numeric_limits<double>::infinity();
  const double squared = tree_->nearest(p, [&](std::uint32_t w) {
    const Vec3 d = nearest_on_segment(walls_[w].a, walls_[w].b, p) - p;
    return dot(d, d);
  });
  return std::sqrt(squared);
}

double SectionBoundary::largest_distance_from(const SectionBoundary& other, Vec3* where) const {
  double largest = 0;
  for (const WallSegment& w : walls_)
    for (const Vec3 p : {w.a, w.b})
      if (const double d = other.distance(p); d > largest) {
        largest = d;
        if (where) *where = p;
      }
  return largest;
}

bool SectionBoundary::inside(Vec3 p) const {
  const PlanarPoint at = chart_.to_grid(p);
  bool odd = false;
  for (const WallSegment& w : walls_) {
    const bool forward = w.ga.x < w.gb.x;
    const PlanarPoint a = forward ? w.ga : w.gb, b = forward ? w.gb : w.ga;
    if (a.x <= at.x && at.x < b.x && turn(a, b, at) < 0) odd = !odd;
  }
  return odd;
}

Vec3 SectionBoundary::nearest(Vec3 p, std::uint32_t& contour) const {
  double least = std::numeric_limits<double>::infinity();
  Vec3 best = p;
  for (const WallSegment& w : walls_) {
    const Vec3 q = nearest_on_segment(w.a, w.b, p);
    const double d = dot(q - p, q - p);
    if (d > least || (d == least && !(q < best))) continue;
    least = d, best = q, contour = w.contour;
  }
  return best;
}

double largest_distance(const SectionBoundary& a, const SectionBoundary& b, Vec3* where) {
  if (a.empty() || b.empty()) return 0;
  Vec3 in_b;
  const double ab = a.largest_distance_from(b, where), ba = b.largest_distance_from(a, &in_b);
  if (where && ba > ab) *where = in_b;
  return std::max(ab, ba);
}

}  // namespace crossloft
