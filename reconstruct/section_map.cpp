#include "section_map.h"

#include <algorithm>
#include <cmath>

namespace crossloft {
namespace {

std::array<double, 2> range_of(std::initializer_list<double> values) {
  return {std::min(values), std::max(values)};
}

/// Edges that one triangle alone has, as that triangle runs through them.
std::vector<std::array<std::uint32_t, 2>> border_of(std::span<const std::array<std::uint32_t, 3>> triangles) {
  struct Edge {
    std::array<std::uint32_t, 2> ends, directed;
  };
  std::vector<Edge> edges;
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      edges.push_back({{std::min(a, b), std::max(a, b)}, {a, b}});
    }
  std::sort(edges.begin(), edges.end(), [](const Edge& x, const Edge& y) { return x.ends < y.ends; });
  std::vector<std::array<std::uint32_t, 2>> border;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool first = i == 0 || edges[i - 1].ends != edges[i].ends;
    if (first && (i + 1 == edges.size() || edges[i + 1].ends != edges[i].ends))
      border.push_back(edges[i].directed);
  }
  return border;
}

}  // namespace

double squared_distance(Vec2 a, Vec2 p, Vec2 q) {
  const Vec2 d = q - p, e = a - p;
  const double length = dot(d, d);
  const double t = length > 0 ? std::clamp(dot(d, e) / length, 0.0, 1.0) : 0;
  const Vec2 away = e - t * d;
  return dot(away, away);
}

SectionMap::SectionMap(const FaceTriangulation& face, std::vector<Vec2> points, bool mirrored)
    : points_(std::move(points)) {
  for (std::uint32_t t = 0; t < face.triangles.size(); ++t)
    if (face.internal[t] != 0) {
      numbers_.push_back(t);
      auto v = face.triangles[t];
      if (mirrored) std::swap(v[1], v[2]);
      triangles_.push_back(v);
    }
  if (triangles_.empty()) return;
  border_ = border_of(triangles_);
  box_ = {points_[border_[0][0]], points_[border_[0][0]]};
  for (const auto& edge : border_)
    for (const std::uint32_t v : edge) {
      box_.low = {std::min(box_.low.x, points_[v].x), std::min(box_.low.y, points_[v].y)};
      box_.high = {std::max(box_.high.x, points_[v].x), std::max(box_.high.y, points_[v].y)};
    }
  strip_count_ = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles_.size()))) + 1;
  per_height_ = box_.high.y > box_.low.y ? strip_count_ / (box_.high.y - box_.low.y) : 0;
  triangle_strips_ = sort_into_strips(triangles_.size(), [&](std::size_t t) {
    const auto& v = triangles_[t];
    return range_of({points_[v[0]].y, points_[v[1]].y, points_[v[2]].y});
  });
  border_strips_ = sort_into_strips(border_.size(), [&](std::size_t e) {
    return range_of({points_[border_[e][0]].y, points_[border_[e][1]].y});
  });
}

std::uint32_t SectionMap::strip_of(double y) const {
  const double strip = (y - box_.low.y) * per_height_;
  if (!(strip > 0)) return 0;  // also where y has overflowed
  return static_cast<std::uint32_t>(std::min(strip, strip_count_ - 1.0));
}

template <class Range>
SectionMap::Strips SectionMap::sort_into_strips(std::size_t count, Range&& range) const {
  Strips strips;
  strips.begin.assign(strip_count_ + 1, 0);
  const auto for_each = [&](auto&& act) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto [low, high] = range(i);
      for (std::uint32_t s = strip_of(low); s <= strip_of(high); ++s) act(s, i);
    }
  };
  for_each([&](std::uint32_t s, std::uint32_t) { ++strips.begin[s + 1]; });
  for (std::uint32_t s = 0; s < strip_count_; ++s) strips.begin[s + 1] += strips.begin[s];
  strips.items.resize(strips.begin.back());
  std::vector<std::uint32_t> next(strips.begin.begin(), strips.begin.end() - 1);
  for_each([&](std::uint32_t s, std::uint32_t i) { strips.items[next[s]++] = i; });
  return strips;
}

std::uint32_t SectionMap::triangle_at(Vec2 a) const {
  if (empty()) return kNone;
  const std::uint32_t s = strip_of(a.y);
  for (std::uint32_t k = triangle_strips_.begin[s]; k < triangle_strips_.begin[s + 1]; ++k) {
    const auto& v = triangles_[triangle_strips_.items[k]];
    const Vec2 p = points_[v[0]], q = points_[v[1]], r = points_[v[2]];
    const double u = cross(q - p, a - p), w = cross(r - q, a - q), x = cross(p - r, a - r);
    if (u >= 0 && w >= 0 && x >= 0) return numbers_[triangle_strips_.items[k]];
  }
  return kNone;
}

double SectionMap::squared_distance_to_border(Vec2 a, double limit) const {
  if (empty()) return limit;
  const double reach = std::sqrt(limit);
  double best = limit;
  for (std::uint32_t s = strip_of(a.y - reach); s <= strip_of(a.y + reach); ++s)
    for (std::uint32_t k = border_strips_.begin[s]; k < border_strips_.begin[s + 1]; ++k) {
      const auto& [p, q] = border_[border_strips_.items[k]];
      best = std::min(best, squared_distance(a, points_[p], points_[q]));
    }
  return best;
}

}  // namespace crossloft
