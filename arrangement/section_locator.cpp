#include "section_locator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../geom/ids.h"

namespace crossloft {
namespace {

/// Strip bounds of all items as offsets, then the items: counting sort of intervals into strips.
template <class Range>
void fill_strips(std::uint32_t strips, std::uint32_t count, Range&& range, std::vector<std::uint32_t>& starts,
                 std::vector<std::uint32_t>& items) {
  starts.assign(strips + 1, 0);
  for (std::uint32_t w = 0; w < count; ++w) {
    const auto [lo, hi] = range(w);
    for (std::uint32_t s = lo; s <= hi; ++s) ++starts[s + 1];
  }
  for (std::uint32_t s = 0; s < strips; ++s) starts[s + 1] += starts[s];
  items.resize(starts[strips]);
  std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
  for (std::uint32_t w = 0; w < count; ++w) {
    const auto [lo, hi] = range(w);
    for (std::uint32_t s = lo; s <= hi; ++s) items[next[s]++] = w;
  }
}

}  // namespace

SectionLocator::SectionLocator(const LatticePlane& plane, std::span<const LatticePoint> points,
                               std::span<const WallEnds> walls)
    : plane_(plane), points_(points), walls_(walls) {
  const int k = dominant_axis(plane.normal);
  first_ = (k + 1) % 3;
  second_ = (k + 2) % 3;
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const WallEnds& w : walls) {
    const bool upward = compare_level(points[w.a], points[w.b]) < 0;
    ordered_.push_back(upward ? w : WallEnds{w.b, w.a});
    lowest = std::min(lowest, points[ordered_.back().a][second_]);
    highest = std::max(highest, points[ordered_.back().b][second_]);
  }
  const auto count = static_cast<std::uint32_t>(walls.size());
  // As many strips as walls, fewer where walls are long: each wall is in 1 + strips * span / height of them, which
  // this bounds by 9 on average.
  double spans = 0;
  for (std::uint32_t w = 0; w < count; ++w) spans += high(w)[second_] - low(w)[second_];
  const double wanted = spans > 0 ? 8.0 * count * ((highest - lowest) / spans) : 1;
  const std::uint32_t strips = count == 0 ? 1 : static_cast<std::uint32_t>(std::clamp(wanted, 1.0, 1.0 * count));
  origin_ = count > 0 ? lowest : 0;
  last_strip_ = strips - 1.0;
  inverse_ = count > 0 && highest > lowest ? strips / (highest - lowest) : 0.0;
  fill_strips(
      strips, count,
      [&](std::uint32_t w) {
        const auto [lo, hi] = level_range(w);
        return std::pair{strip_of(lo), strip_of(hi)};
      },
      starts_, items_);
}

std::array<double, 2> SectionLocator::level_range(std::uint32_t w) const {
  return {low(w)[second_], high(w)[second_]};
}

/// Monotone in the level, so that a wall's strips are those between its ends' strips.
std::uint32_t SectionLocator::strip_of(double level) const {
  const double s = (level - origin_) * inverse_;
  return static_cast<std::uint32_t>(std::clamp(s, 0.0, last_strip_));
}

int SectionLocator::compare_level(const LatticePoint& p, const LatticePoint& q) const {
  if (const int s = compare_axis(second_, p, q)) return s;
  return compare_axis(first_, p, q);
}

SectionLocator::Count SectionLocator::count(const LatticePoint& p, const LatticePoint* toward,
                                            std::uint32_t skip) const {
  Count result;
  const bool upward = toward == nullptr || compare_level(p, *toward) < 0;
  for (const std::uint32_t w : strip(strip_of(p[second_]))) {
    if (w == skip) continue;
    const int from_low = compare_level(low(w), p), from_high = compare_level(high(w), p);
    if (from_low == 0 || from_high == 0) {
      result.on_wall = true;
      // The wall starts at p: it reaches the level of the moved point iff it leaves p in the same sense.
      if (toward != nullptr && (from_low == 0) == upward && orient2d(plane_, low(w), high(w), *toward) > 0)
        result.odd = !result.odd;
      if (toward != nullptr) continue;
    }
    const bool spans = upward ? from_low <= 0 && from_high > 0 : from_low < 0 && from_high >= 0;
    if (!spans) continue;
    int side = orient2d(plane_, low(w), high(w), p);
    if (side == 0) result.on_wall = true;
    if (side == 0 && toward != nullptr) side = orient2d(plane_, low(w), high(w), *toward);
    if (side > 0) result.odd = !result.odd;
  }
  return result;
}

SectionLocator::Place SectionLocator::locate(const LatticePoint& p) const {
  const Count c = count(p, nullptr, kNone);
  return c.on_wall ? Place::boundary : c.odd ? Place::inside : Place::outside;
}

bool SectionLocator::inside_toward(const LatticePoint& p, const LatticePoint& q) const {
  return count(p, &q, kNone).odd;
}

bool SectionLocator::inside_left(std::uint32_t w) const {
  // A wall counts for the points on the left of its upward direction. Just left of w the walls other than w decide,
  // plus w itself, which counts there when w is followed upward.
  const bool upward = ordered_[w].a == walls_[w].a;
  const bool others = count(points_[walls_[w].a], &points_[walls_[w].b], w).odd;
  return upward ? !others : others;
}

bool SectionLocator::boxes_meet(std::uint32_t v, std::uint32_t w) const {
  for (const int axis : {first_, second_}) {
    const double v0 = low(v)[axis], v1 = high(v)[axis], w0 = low(w)[axis], w1 = high(w)[axis];
    if (std::max(v0, v1) < std::min(w0, w1) || std::max(w0, w1) < std::min(v0, v1)) return false;
  }
  return true;
}

bool SectionLocator::in_conflict(std::uint32_t v, std::uint32_t w) const {
  if (!boxes_meet(v, w)) return false;
  const WallEnds& p = ordered_[v];
  const WallEnds& q = ordered_[w];
  const int a = orient2d(plane_, points_[p.a], points_[p.b], points_[q.a]);
  const int b = orient2d(plane_, points_[p.a], points_[p.b], points_[q.b]);
  if (a == 0 && b == 0)  // on one line: they share more than an end iff their spans overlap
    return compare_level(low(v), high(w)) < 0 && compare_level(low(w), high(v)) < 0;
  if (a * b > 0) return false;
  const int c = orient2d(plane_, points_[q.a], points_[q.b], points_[p.a]);
  const int d = orient2d(plane_, points_[q.a], points_[q.b], points_[p.b]);
  if (c * d > 0) return false;
  // They share exactly one point. It is an end of both iff an end of each is on the other's line there.
  const bool end_of_w = a == 0 || b == 0, end_of_v = c == 0 || d == 0;
  return !(end_of_w && end_of_v);
}

bool SectionLocator::near_interior(std::uint32_t w, std::uint32_t v, double tolerance) const {
  const auto position = [&](std::uint32_t i) { return Vec3{points_[i].x, points_[i].y, points_[i].z}; };
  const Vec3 a = position(walls_[w].a), d = position(walls_[w].b) - a, p = position(v) - a;
  const double along = dot(p, d), length2 = dot(d, d);
  return along > 0 && along < length2 && norm(cross(p, d)) <= tolerance * std::sqrt(length2);
}

std::vector<std::array<std::uint32_t, 2>> SectionLocator::near_touches(double tolerance) const {
  std::vector<std::array<std::uint32_t, 2>> found;
  for (const WallEnds& from : walls_)
    for (const std::uint32_t v : {from.a, from.b}) {
      const double level = points_[v][second_];
      const std::uint32_t last = strip_of(level + tolerance);
      for (std::uint32_t s = strip_of(level - tolerance); s <= last; ++s)
        for (const std::uint32_t w : strip(s))
          if (walls_[w].a != v && walls_[w].b != v && near_interior(w, v, tolerance)) found.push_back({w, v});
    }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::vector<std::array<std::uint32_t, 2>> SectionLocator::conflicts() const {
  std::vector<std::array<std::uint32_t, 2>> found;
  const auto starts_in = [&](std::uint32_t w, std::uint32_t s) { return strip_of(low(w)[second_]) == s; };
  for (std::uint32_t s = 0; s + 1 < starts_.size(); ++s)
    for (const std::uint32_t v : strip(s)) {
      if (!starts_in(v, s)) continue;  // a pair is tested in the first strip they share: there one of them starts
      for (const std::uint32_t w : strip(s))
        if (w != v && (w > v || !starts_in(w, s)) && in_conflict(v, w)) found.push_back({std::min(v, w), std::max(v, w)});
    }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace crossloft
