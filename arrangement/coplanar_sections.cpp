#include "coplanar_sections.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "normalise.h"

namespace crossloft {
namespace {

std::tuple<double, double, double> key(const LatticePoint& p) { return {p.x, p.y, p.z}; }

/// A section in the plane's projection along its dominant axis, coordinates doubled so that middles of pieces
/// are integral too.
class Projected {
 public:
  Projected(const LatticePlane& plane, const LatticeSection& section) : plane_(plane) {
    const int k = dominant_axis(plane.normal);
    i_ = (k + 1) % 3, j_ = (k + 2) % 3;
    for (const LatticePoint& p : section.vertices) points_.push_back({2 * p.x, 2 * p.y, 2 * p.z, nullptr});
    for (const WallEdge& w : section.walls) edges_.push_back({w.a, w.b});
  }

  /// The middles of the pieces that the vertices of both cut the edges into.
  std::vector<LatticePoint> middles(const Projected& other) const {
    std::vector<LatticePoint> result, ends;
    for (const Edge& e : edges_) {
      ends.clear();
      for (const Projected* section : {this, &other})
        for (const LatticePoint& p : section->points_)
          if (on_edge(e, p)) ends.push_back(p);
      std::sort(ends.begin(), ends.end(), [](const auto& p, const auto& q) { return key(p) < key(q); });
      for (std::size_t k = 1; k < ends.size(); ++k) {
        const LatticePoint &p = ends[k - 1], &q = ends[k];
        if (key(p) != key(q)) result.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2, nullptr});
      }
    }
    return result;
  }

  /// Whether the section holds the place beside p, no vertex, that an infinitesimal step away from the axes
  /// leads to: towards low i and much less towards high j, or, on the `far` side, the other way. Even-odd
  /// along the ray towards growing i.
  bool holds_beside(const LatticePoint& p, bool far) const {
    const auto above = [&](const LatticePoint& q) { return far ? q[j_] >= p[j_] : q[j_] > p[j_]; };
    bool inside = false;
    for (const auto& [ia, ib] : edges_) {
      const LatticePoint &a = points_[ia], &b = points_[ib];
      if (above(a) == above(b) || std::max(a[i_], b[i_]) < p[i_]) continue;
      const int side = orient2d(plane_, a, b, p);
      // p is left of an upward edge iff the triangle (a, b, p) turns as (i, j) do.
      const int left = positive_axis() ? side : -side;
      const bool hit = side == 0 ? !far : (b[j_] > a[j_]) == (left > 0);
      inside = inside != hit;
    }
    return inside;
  }

  bool crosses(const Projected& other) const {
    return std::any_of(edges_.begin(), edges_.end(), [&](const Edge& e) {
      return std::any_of(other.edges_.begin(), other.edges_.end(), [&](const Edge& f) {
        return cross(points_[e.a], points_[e.b], other.points_[f.a], other.points_[f.b]);
      });
    });
  }

 private:
  struct Edge {
    std::uint32_t a, b;
  };

  bool positive_axis() const { return plane_.normal[static_cast<std::size_t>(3 - i_ - j_)] > 0; }

  bool apart(int axis, const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
             const LatticePoint& d) const {
    return std::max(a[axis], b[axis]) < std::min(c[axis], d[axis]) ||
           std::max(c[axis], d[axis]) < std::min(a[axis], b[axis]);
  }
  /// At an end or between.
  bool on_edge(const Edge& e, const LatticePoint& p) const {
    const LatticePoint &a = points_[e.a], &b = points_[e.b];
    return !apart(i_, a, b, p, p) && !apart(j_, a, b, p, p) && orient2d(plane_, a, b, p) == 0;
  }
  /// True iff the open segments have one common point.
  bool cross(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c,
             const LatticePoint& d) const {
    if (apart(i_, a, b, c, d) || apart(j_, a, b, c, d)) return false;
    return orient2d(plane_, a, b, c) * orient2d(plane_, a, b, d) < 0 &&
           orient2d(plane_, c, d, a) * orient2d(plane_, c, d, b) < 0;
  }

  const LatticePlane& plane_;
  int i_ = 0, j_ = 1;
  std::vector<LatticePoint> points_;
  std::vector<Edge> edges_;
};

double distance2(const LatticePoint& a, const LatticePoint& b) {
  const Vec3 d = Vec3{a.x, a.y, a.z} - Vec3{b.x, b.y, b.z};
  return dot(d, d);
}

/// [vertex of a] the nearest vertex of b; empty if one is further than the tolerance.
std::vector<std::uint32_t> match_vertices(const LatticeSection& a, const LatticeSection& b,
                                          double tolerance) {
  std::vector<std::uint32_t> match;
  for (const LatticePoint& p : a.vertices) {
    const auto nearest =
        std::min_element(b.vertices.begin(), b.vertices.end(),
                         [&](const auto& q, const auto& r) { return distance2(p, q) < distance2(p, r); });
    if (distance2(p, *nearest) > tolerance * tolerance) return {};
    match.push_back(static_cast<std::uint32_t>(nearest - b.vertices.begin()));
  }
  return match;
}

bool equal_walls(const std::vector<WallEdge>& a, const std::vector<WallEdge>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const WallEdge& x, const WallEdge& y) { return x.a == y.a && x.b == y.b; });
}

bool nearly_same(const LatticeSection& a, const LatticeSection& b, double tolerance) {
  if (a.vertices.size() != b.vertices.size() || a.walls.size() != b.walls.size()) return false;
  const std::vector<std::uint32_t> match = match_vertices(a, b, tolerance);
  if (match.size() != a.vertices.size()) return false;
  std::vector<WallEdge> mapped;
  for (const WallEdge& w : a.walls)
    mapped.push_back({std::min(match[w.a], match[w.b]), std::max(match[w.a], match[w.b]), 0, 0, 0});
  cancel_pairs(mapped);
  return equal_walls(mapped, b.walls);
}

void renumber(std::vector<WallEdge>& walls, const std::vector<std::uint32_t>& index) {
  for (WallEdge& w : walls) {
    const std::uint32_t a = index[w.a], b = index[w.b];
    w.a = std::min(a, b), w.b = std::max(a, b);
  }
}

/// Lexicographic order; of equal points the first input.
void merge_equal_vertices(LatticeSection& s) {
  const auto not_before = [](const LatticePoint& p, const LatticePoint& q) { return key(p) >= key(q); };
  if (std::adjacent_find(s.vertices.begin(), s.vertices.end(), not_before) == s.vertices.end()) return;
  std::vector<std::uint32_t> order(s.vertices.size()), index(s.vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t v, std::uint32_t w) {
    return std::pair(key(s.vertices[v]), s.input[v]) < std::pair(key(s.vertices[w]), s.input[w]);
  });
  std::vector<LatticePoint> vertices;
  std::vector<Vec3> input;
  for (const std::uint32_t v : order) {
    if (vertices.empty() || key(vertices.back()) != key(s.vertices[v])) {
      vertices.push_back(s.vertices[v]);
      input.push_back(s.input[v]);
    }
    index[v] = static_cast<std::uint32_t>(vertices.size() - 1);
  }
  renumber(s.walls, index);
  s.vertices = std::move(vertices);
  s.input = std::move(input);
}

void drop_isolated(LatticeSection& s) {
  std::vector<std::uint32_t> index(s.vertices.size(), kNone);
  for (const WallEdge& w : s.walls) index[w.a] = index[w.b] = 0;
  if (std::find(index.begin(), index.end(), kNone) == index.end()) return;
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < index.size(); ++v) {
    if (index[v] == kNone) continue;
    s.vertices[kept] = s.vertices[v];
    s.input[kept] = s.input[v];
    index[v] = kept++;
  }
  s.vertices.resize(kept);
  s.input.resize(kept);
  renumber(s.walls, index);
}

}  // namespace

SectionRelation relation(const LatticePlane& plane, const LatticeSection& a, const LatticeSection& b,
                         double tolerance) {
  if (a.walls.empty() || b.walls.empty())
    return a.walls.size() == b.walls.size() ? SectionRelation::same : SectionRelation::apart;
  if (nearly_same(a, b, tolerance)) return SectionRelation::same;
  const Projected p(plane, a), q(plane, b);
  if (p.crosses(q)) return SectionRelation::overlapping;
  // Without a proper crossing no edge of one enters or leaves the other, or its border, within a piece
  // between vertices: both sides of its middle stand for the piece. What the sections have in common has a
  // border, and so has what only one of them holds, if there is any: pieces tell of both.
  bool any_common = false, all_common = true;
  for (const auto& middles : {p.middles(q), q.middles(p)})
    for (const LatticePoint& m : middles)
      for (const bool far : {false, true}) {
        const bool in_p = p.holds_beside(m, far), in_q = q.holds_beside(m, far);
        any_common = any_common || (in_p && in_q);
        all_common = all_common && in_p == in_q;
      }
  if (all_common) return SectionRelation::same;
  return any_common ? SectionRelation::overlapping : SectionRelation::apart;
}

void tidy(LatticeSection& s) {
  merge_equal_vertices(s);
  cancel_pairs(s.walls);
  drop_isolated(s);
}

}  // namespace crossloft
