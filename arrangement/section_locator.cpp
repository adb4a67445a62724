#include "section_locator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../geom/ids.h"

namespace crossloft {
namespace {

/// Walls in the strips of a wall, on average, from which on there are strips of the other axis as well: some
/// 80 are in nine strips, but thousands may be at one level, of a flat section or of one side of a rectangle.
constexpr std::size_t kCrowd = 512;

}  // namespace

SectionLocator::SectionLocator(const LatticePlane& plane, std::span<const LatticePoint> points,
                               std::span<const WallEnds> walls)
    : SectionLocator(plane, points, walls, false) {
  if (is_crowded()) other_.reset(new SectionLocator(plane, points, walls, true));
}

SectionLocator::SectionLocator(const LatticePlane& plane, std::span<const LatticePoint> points,
                               std::span<const WallEnds> walls, bool swapped)
    : plane_(plane), points_(points), walls_(walls) {
  const int k = dominant_axis(plane.normal);
  first_ = (k + 1) % 3;
  second_ = (k + 2) % 3;
  left_side_ = plane.normal[static_cast<std::size_t>(k)] > 0 ? 1 : -1;
  if (swapped) std::swap(first_, second_), left_side_ = -left_side_;
  measure();
  const auto count = static_cast<double>(walls.size());
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest, spans = 0;
  for (const Box& box : boxes_) {
    lowest = std::min(lowest, box.low);
    highest = std::max(highest, box.high);
    spans += box.high - box.low;
  }
  // As many strips as walls, fewer where walls are long: each wall is in 1 + strips * span / height of them,
  // which this bounds by 9 on average.
  const double wanted = spans > 0 ? 8.0 * count * ((highest - lowest) / spans) : 1;
  const std::uint32_t strips = walls.empty() ? 1 : static_cast<std::uint32_t>(std::clamp(wanted, 1.0, count));
  origin_ = walls.empty() ? 0 : lowest;
  last_strip_ = strips - 1.0;
  inverse_ = !walls.empty() && highest > lowest ? strips / (highest - lowest) : 0.0;
  fill_strips(strips);
}

/// Walls upward, and their boxes.
void SectionLocator::measure() {
  ordered_.reserve(walls_.size());
  boxes_.reserve(walls_.size());
  for (const WallEnds& w : walls_) {
    ordered_.push_back(compare_level(points_[w.a], points_[w.b]) < 0 ? w : WallEnds{w.b, w.a});
    const LatticePoint &p = points_[ordered_.back().a], &q = points_[ordered_.back().b];
    const auto [left, right] = std::minmax({p[first_], q[first_]});
    boxes_.push_back({p[second_], q[second_], left, right});
  }
}

/// Counting sort of the walls into strips. A wall's strips are those between its ends' strips, since
/// strip_of() is monotone.
void SectionLocator::fill_strips(std::uint32_t strips) {
  starts_.assign(strips + std::size_t{2}, 0);
  strips_.reserve(boxes_.size());
  for (const Box& box : boxes_) {
    strips_.push_back({strip_of(box.low), strip_of(box.high)});
    for (std::uint32_t s = strips_.back().first; s <= strips_.back().last; ++s) ++starts_[s + 2];
  }
  for (std::size_t s = 2; s < starts_.size(); ++s) starts_[s] += starts_[s - 1];
  items_.resize(starts_.back());
  for (std::uint32_t w = 0; w < strips_.size(); ++w)
    for (std::uint32_t s = strips_[w].first; s <= strips_[w].last; ++s) items_[starts_[s + 1]++] = w;
  starts_.pop_back();  // each has moved on to where the next one begins
}

bool SectionLocator::is_crowded() const {
  std::size_t together = 0;
  for (std::uint32_t s = 0; s + 1 < starts_.size(); ++s) together += strip(s).size() * strip(s).size();
  return together > kCrowd * walls_.size();
}

std::size_t SectionLocator::walls_around(std::uint32_t w) const {
  return starts_[strips_[w].last + std::size_t{1}] - starts_[strips_[w].first];
}

inline std::uint32_t SectionLocator::strip_of(double level) const {
  const double s = (level - origin_) * inverse_;
  return static_cast<std::uint32_t>(std::clamp(s, 0.0, last_strip_));
}

inline int SectionLocator::compare_level(const LatticePoint& p, const LatticePoint& q) const {
  if (const int s = compare_axis(second_, p, q)) return s;
  return compare_axis(first_, p, q);
}

/// orient2d(low, high, p). REQUIRES: the level of p is one of the wall's; then a point beside its box is on
/// that side.
inline int SectionLocator::side_of(std::uint32_t w, const LatticePoint& p) const {
  if (p[first_] < boxes_[w].left) return left_side_;
  if (p[first_] > boxes_[w].right) return -left_side_;
  return orient2d(plane_, low(w), high(w), p);
}

SectionLocator::Count SectionLocator::count(const LatticePoint& p, const LatticePoint* toward,
                                            std::uint32_t skip) const {
  if (asks_other(p)) return other_->count(p, toward, skip);
  Count result;
  const bool upward = toward == nullptr || compare_level(p, *toward) < 0;
  const double level = p[second_];
  for (const std::uint32_t w : strip_at(p)) {
    if (boxes_[w].high < level || boxes_[w].low > level || w == skip) continue;
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
    int side = side_of(w, p);
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
  if (asks_other(points_[walls_[w].a])) return other_->inside_left(w);
  // A wall counts for the points on the left of its upward direction. Just left of w the walls other than w
  // decide, plus w itself, which counts there when w is followed upward.
  const bool upward = ordered_[w].a == walls_[w].a;
  const bool others = count(points_[walls_[w].a], &points_[walls_[w].b], w).odd;
  return upward ? !others : others;
}

/// Of walls on one line: they share more than an end iff their spans overlap.
bool SectionLocator::overlap_on_line(std::uint32_t v, std::uint32_t w) const {
  return compare_level(low(v), high(w)) < 0 && compare_level(low(w), high(v)) < 0;
}

/// REQUIRES: their boxes meet.
bool SectionLocator::in_conflict(std::uint32_t v, std::uint32_t w) const {
  const WallEnds &p = ordered_[v], &q = ordered_[w];
  const auto turn = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return orient2d(plane_, points_[a], points_[b], points_[c]);
  };
  // Neighbours on a contour, most of what comes here: one question instead of four.
  if (p.a == q.a || p.b == q.a) return turn(p.a, p.b, q.b) == 0 && overlap_on_line(v, w);
  if (p.a == q.b || p.b == q.b) return turn(p.a, p.b, q.a) == 0 && overlap_on_line(v, w);
  const int a = turn(p.a, p.b, q.a), b = turn(p.a, p.b, q.b);
  if (a == 0 && b == 0) return overlap_on_line(v, w);
  if (a * b > 0) return false;
  const int c = turn(q.a, q.b, p.a), d = turn(q.a, q.b, p.b);
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

void SectionLocator::find_near_walls(std::uint32_t v, double tolerance, Pairs& found) const {
  // What is further from a wall's box is further from the wall, roundings of up to 2^-3 included.
  const double margin = tolerance + 1;
  const double level = points_[v][second_], at = points_[v][first_];
  const std::uint32_t last = strip_of(level + tolerance);
  for (std::uint32_t s = strip_of(level - tolerance); s <= last; ++s)
    for (const std::uint32_t w : strip(s))
      if (boxes_[w].holds(at, level, margin) && walls_[w].a != v && walls_[w].b != v &&
          near_interior(w, v, tolerance))
        found.push_back({w, v});
}

SectionLocator::Pairs SectionLocator::near_touches(double tolerance) const {
  Pairs found;
  const auto look_around = [&](std::uint32_t v) {
    (asks_other(points_[v]) ? *other_ : *this).find_near_walls(v, tolerance, found);
  };
  // Each vertex once: it is an end of two walls as a rule.
  std::uint32_t least = kNone, most = 0;
  for (const WallEnds& w : walls_) least = std::min({least, w.a, w.b}), most = std::max({most, w.a, w.b});
  std::vector<bool> done(walls_.empty() ? 0 : most - least + std::size_t{1});
  for (const WallEnds& from : walls_)
    for (const std::uint32_t v : {from.a, from.b})
      if (!done[v - least]) done[v - least] = true, look_around(v);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

SectionLocator::Pairs SectionLocator::conflicts() const {
  Pairs found;
  if (other_)
    for (std::uint32_t v = 0; v < walls_.size(); ++v)
      (other_->walls_around(v) < walls_around(v) ? *other_ : *this).find_conflicts_of(v, found);
  else
    find_conflicts(found);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

void SectionLocator::find_conflicts(Pairs& found) const {
  for (std::uint32_t s = 0; s + 1 < starts_.size(); ++s)
    for (const std::uint32_t v : strip(s)) {
      if (strips_[v].first != s)
        continue;  // a pair is tested in the first strip they share: there one of them starts
      for (const std::uint32_t w : strip(s))
        if (boxes_[v].meets(boxes_[w]) && w != v && (w > v || strips_[w].first != s) && in_conflict(v, w))
          found.push_back({std::min(v, w), std::max(v, w)});
    }
}

void SectionLocator::find_conflicts_of(std::uint32_t v, Pairs& found) const {
  for (std::uint32_t s = strips_[v].first; s <= strips_[v].last; ++s)
    for (const std::uint32_t w : strip(s))
      if (w != v && boxes_[v].meets(boxes_[w]) && in_conflict(v, w))
        found.push_back({std::min(v, w), std::max(v, w)});
}

}  // namespace crossloft
