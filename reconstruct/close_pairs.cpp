#include "close_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "../geom/box_tree.h"
#include "../geom/ids.h"
#include "../geom/triangle_meeting.h"

namespace crossloft {
namespace {

/// So many triangles around a vertex cost less as pairs than as a hub.
constexpr std::uint32_t kMostAround = 64;

/// Unit vector, but for a few units in the last place. REQUIRES: not 0.
Vec3 direction(const Vec3& v) {
  int exponent = 0;
  const Vec3 d = to_unit_size(v, exponent);
  return 1 / norm(d) * d;
}

/// Of the directions from a hub to the points of a segment. With the angle w between the ends' they are
/// 1 - cos(w / 2) from the chord at most, which is not more than sin^2(w / 2), a quarter of its square.
Bounds box_of_arc(const Vec3& hub, const Vec3& p, const Vec3& q) {
  constexpr double kRounding = 0x1p-46;
  const std::array<Vec3, 2> ends{direction(p - hub), direction(q - hub)};
  const Vec3 chord = ends[1] - ends[0];
  const double room = 0.25 * dot(chord, chord) + kRounding;
  const Bounds box = bounds_of(ends);
  return {box.low - Vec3{room, room, room}, box.high + Vec3{room, room, room}};
}

/// The plane of a triangle in rounded numbers.
class RoundedPlane {
 public:
  explicit RoundedPlane(const Corners& t)
      : base_(t[0]), normal_(cross(t[1] - t[0], t[2] - t[0])), size_(sum(t[1] - t[0]) * sum(t[2] - t[0])) {}
  /// Point and box are strictly on one side for sure. Less than 16 units in the last place of the product of
  /// all lengths are rounded, where none of them underflows.
  bool is_beside(const Vec3& p, const Bounds& box) const {
    if (!(size_ > 0x1p-900)) return false;
    const Vec3 d = p - base_, low = box.low - base_, high = box.high - base_;
    const double slack = 0x1p-48 * size_ * (sum(d) + sum(low) + sum(high)) + 0x1p-1000;
    const double at = dot(normal_, d);
    if (std::fabs(at) <= slack) return false;
    const double sign = at > 0 ? 1 : -1;
    return least(sign * normal_.x, low.x, high.x) + least(sign * normal_.y, low.y, high.y) +
               least(sign * normal_.z, low.z, high.z) >
           slack;
  }

 private:
  static double sum(const Vec3& v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }
  static double least(double n, double low, double high) { return n > 0 ? n * low : n * high; }

  Vec3 base_, normal_;
  double size_;
};

/// The triangles around a hub.
struct Star {
  Vec3 hub;
  std::vector<std::uint32_t> triangles = {};
  std::vector<Bounds> rims = {};  ///< in step: boxes of the edges opposite to the hub
};

class PairFinder {
 public:
  PairFinder(const Surface& surface, std::span<const std::uint8_t> asked, SameCorner same, CancelFlag cancel,
             const std::function<void(std::uint32_t, std::uint32_t)>& visit)
      : surface_(surface), asked_(asked), cancel_(cancel), visit_(visit) {
    find_hubs(same);
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) place(t);
  }
  void run() {
    pair_rest();
    if (stars_.empty()) return;
    for (const Star& star : stars_) pair_around(star);
    pair_stars();
  }

 private:
  Corners corners(std::uint32_t t) const {
    const auto& c = surface_.triangles[t];
    return {surface_.points[c[0]], surface_.points[c[1]], surface_.points[c[2]]};
  }
  void look_at(std::uint32_t s, std::uint32_t t) const {
    if ((asked_[s] | asked_[t]) != 0 && !is_raised(cancel_)) visit_(s, t);
  }
  void find_hubs(SameCorner same);
  void place(std::uint32_t t);
  void pair_rest() const;
  void pair_around(const Star& star) const;
  void pair_stars() const;
  void pair_with_star(std::uint32_t t, const Star& star, const BoxTree& rims) const;

  const Surface& surface_;
  std::span<const std::uint8_t> asked_;
  CancelFlag cancel_;
  const std::function<void(std::uint32_t, std::uint32_t)>& visit_;
  std::vector<std::uint32_t> around_;   ///< by vertex: how many triangles
  std::vector<std::uint32_t> star_at_;  ///< by vertex
  std::vector<Star> stars_;
  std::vector<std::uint32_t> rest_;  ///< triangles without a hub
};

void PairFinder::find_hubs(SameCorner same) {
  around_.resize(surface_.points.size());
  star_at_.resize(surface_.points.size(), kNone);
  for (const auto& t : surface_.triangles)
    for (const std::uint32_t v : t) ++around_[v];
  std::vector<std::uint32_t> hubs;
  for (std::uint32_t v = 0; v < around_.size(); ++v)
    if (around_[v] > kMostAround) hubs.push_back(v);
  const auto& points = surface_.points;
  if (same == SameCorner::place)
    std::sort(hubs.begin(), hubs.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::tie(points[a], a) < std::tie(points[b], b);
    });
  for (const std::uint32_t v : hubs) {
    if (same == SameCorner::index || stars_.empty() || stars_.back().hub != points[v])
      stars_.push_back({points[v]});
    star_at_[v] = static_cast<std::uint32_t>(stars_.size() - 1);
  }
}

/// Into the star of its largest hub, if it has one.
void PairFinder::place(std::uint32_t t) {
  const auto& c = surface_.triangles[t];
  const auto largest = std::max_element(c.begin(), c.end(), [&](std::uint32_t a, std::uint32_t b) {
    return around_[a] != around_[b] ? around_[a] < around_[b] : a < b;
  });
  const std::uint32_t star = star_at_[*largest];
  if (star == kNone || collinear(corners(t))) return rest_.push_back(t);
  const auto k = static_cast<std::size_t>(largest - c.begin());
  stars_[star].triangles.push_back(t);
  stars_[star].rims.push_back(
      bounds_of(std::array{surface_.points[c[(k + 1) % 3]], surface_.points[c[(k + 2) % 3]]}));
}

void PairFinder::pair_rest() const {
  std::vector<std::uint32_t> asked;
  std::vector<Bounds> boxes;
  for (const std::uint32_t t : rest_)
    if (asked_[t] != 0) asked.push_back(t), boxes.push_back(bounds_of(corners(t)));
  const BoxTree tree(boxes);
  tree.for_pairs([&](std::uint32_t i, std::uint32_t j) { look_at(asked[i], asked[j]); });
  for (const std::uint32_t t : rest_)
    if (asked_[t] == 0)
      tree.for_overlaps(bounds_of(corners(t)), [&](std::uint32_t i) { look_at(asked[i], t); });
}

/// Of one star.
void PairFinder::pair_around(const Star& star) const {
  std::vector<Bounds> arcs;
  for (const std::uint32_t t : star.triangles) {
    const Corners c = corners(t);
    const std::size_t k = c[0] == star.hub ? 0 : c[1] == star.hub ? 1 : 2;
    arcs.push_back(box_of_arc(star.hub, c[(k + 1) % 3], c[(k + 2) % 3]));
  }
  BoxTree(arcs).for_pairs(
      [&](std::uint32_t i, std::uint32_t j) { look_at(star.triangles[i], star.triangles[j]); });
}

/// Each with what is not in it.
void PairFinder::pair_stars() const {
  std::vector<BoxTree> rims;
  std::vector<Bounds> boxes;
  for (const Star& star : stars_) {
    rims.emplace_back(star.rims);
    Bounds& box = boxes.emplace_back();
    box.add(star.hub);
    for (const Bounds& rim : star.rims) box.join(rim);
  }
  const BoxTree tree(boxes);
  for (const std::uint32_t t : rest_)
    tree.for_overlaps(bounds_of(corners(t)), [&](std::uint32_t i) { pair_with_star(t, stars_[i], rims[i]); });
  tree.for_pairs([&](std::uint32_t i, std::uint32_t j) {
    const bool swapped = stars_[i].triangles.size() > stars_[j].triangles.size();
    const std::uint32_t fewer = swapped ? j : i, more = swapped ? i : j;
    for (const std::uint32_t t : stars_[fewer].triangles) pair_with_star(t, stars_[more], rims[more]);
  });
}

/// A triangle of a star lies in the convex hull of the hub and its rim, or of a box around several rims.
void PairFinder::pair_with_star(std::uint32_t t, const Star& star, const BoxTree& rims) const {
  if (is_raised(cancel_)) return;
  const Corners c = corners(t);
  const Bounds box = bounds_of(c);
  const RoundedPlane plane(c);
  rims.for_admitted(
      [&](Bounds rim) {
        if (plane.is_beside(star.hub, rim)) return false;
        rim.add(star.hub);
        return overlap(rim, box);
      },
      [&](std::uint32_t i) { look_at(star.triangles[i], t); });
}

}  // namespace

void for_close_pairs(const Surface& surface, std::span<const std::uint8_t> asked, SameCorner same,
                     CancelFlag cancel, const std::function<void(std::uint32_t, std::uint32_t)>& visit) {
  PairFinder(surface, asked, same, cancel, visit).run();
}

}  // namespace crossloft
