#include "section_loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace crossloft {
namespace {

struct Point2 {
  double x = 0, y = 0;
};

/// Drops the coordinate that the plane is steepest in.
std::vector<Point2> project(const PlaneSection& plane) {
  const double nx = std::abs(plane.normal.x), ny = std::abs(plane.normal.y), nz = std::abs(plane.normal.z);
  const int dropped = nx >= ny && nx >= nz ? 0 : ny >= nz ? 1 : 2;
  std::vector<Point2> points;
  points.reserve(plane.vertices.size());
  for (const Vec3& p : plane.vertices) {
    points.push_back(dropped == 0 ? Point2{p.y, p.z} : dropped == 1 ? Point2{p.z, p.x} : Point2{p.x, p.y});
  }
  return points;
}

bool is_wall(const ContourEdge& edge) {
  return edge.a != edge.b && (edge.material_a == 0) != (edge.material_b == 0);
}

/// Edges that bound the inside, in file order.
std::vector<ContourEdge> walls_of(const PlaneSection& plane) {
  using Key = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<std::pair<Key, std::uint32_t>> keyed;
  for (std::uint32_t e = 0; e < plane.edges.size(); ++e) {
    const ContourEdge& edge = plane.edges[e];
    if (is_wall(edge)) keyed.push_back({std::minmax(edge.a, edge.b), e});
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    const bool pair = i + 1 < keyed.size() && keyed[i].first == keyed[i + 1].first;
    if (pair)
      ++i;
    else
      kept.push_back(keyed[i].second);
  }
  std::sort(kept.begin(), kept.end());
  std::vector<ContourEdge> walls;
  for (const std::uint32_t e : kept) walls.push_back(plane.edges[e]);
  return walls;
}

/// One end of a wall: 2 w is its vertex a, 2 w + 1 its vertex b.
using End = std::uint32_t;

/// Grows with the angle of (dx, dy), without libm.
double pseudo_angle(double dx, double dy) {
  const double t = dy / (std::abs(dx) + std::abs(dy));
  return dx < 0 ? 2 - t : t < 0 ? 4 + t : t;
}

class LoopTracer {
 public:
  LoopTracer(const PlaneSection& plane, const std::vector<Point2>& points)
      : points_(points),
        walls_(walls_of(plane)),
        ends_at_(plane.vertices.size()),
        partner_(2 * walls_.size()) {
    for (End e = 0; e < partner_.size(); ++e) ends_at_[vertex(e)].push_back(e);
  }

  /// A wall that ends at a vertex with an odd number of walls, nullptr when all chains close.
  const ContourEdge* open_wall() const {
    for (const std::vector<End>& ends : ends_at_) {
      if (ends.size() % 2 != 0) return &walls_[ends.front() / 2];
    }
    return nullptr;
  }

  /// REQUIRES: no open wall.
  std::vector<SectionLoop> trace() {
    for (std::vector<End>& ends : ends_at_) join_neighbours(ends);
    std::vector<SectionLoop> loops;
    std::vector<bool> done(walls_.size(), false);
    for (std::uint32_t w = 0; w < walls_.size(); ++w) {
      if (!done[w]) loops.push_back(trace_from(w, done));
    }
    return loops;
  }

 private:
  std::uint32_t vertex(End e) const { return e % 2 == 0 ? walls_[e / 2].a : walls_[e / 2].b; }

  void join_neighbours(std::vector<End>& ends) {
    if (ends.size() > 2) {
      const auto angle = [&](End e) {
        const Point2 from = points_[vertex(e)], to = points_[vertex(e ^ 1)];
        return pseudo_angle(to.x - from.x, to.y - from.y);
      };
      std::sort(ends.begin(), ends.end(),
                [&](End e, End f) { return std::pair(angle(e), e) < std::pair(angle(f), f); });
    }
    for (std::size_t i = 0; i < ends.size(); i += 2) {
      partner_[ends[i]] = ends[i + 1];
      partner_[ends[i + 1]] = ends[i];
    }
  }

  SectionLoop trace_from(std::uint32_t first, std::vector<bool>& done) const {
    SectionLoop loop;
    loop.material = material(first);
    End e = 2 * first;
    do {
      done[e / 2] = true;
      loop.mixed = loop.mixed || material(e / 2) != loop.material;
      loop.vertices.push_back(vertex(e));
      e = partner_[e ^ 1];
    } while (e != 2 * first);
    return loop;
  }

  std::int32_t material(std::uint32_t wall) const {
    return walls_[wall].material_a != 0 ? walls_[wall].material_a : walls_[wall].material_b;
  }

  const std::vector<Point2>& points_;
  std::vector<ContourEdge> walls_;
  std::vector<std::vector<End>> ends_at_;
  std::vector<End> partner_;
};

class Nesting {
 public:
  Nesting(const std::vector<Point2>& points, std::vector<SectionLoop>& loops)
      : points_(points), loops_(loops) {
    for (const SectionLoop& loop : loops) boxes_.push_back(box(loop));
  }

  void find_parents() {
    std::vector<std::vector<std::uint32_t>> around(loops_.size());
    for (std::uint32_t i = 0; i < loops_.size(); ++i) {
      for (std::uint32_t j = 0; j < loops_.size(); ++j) {
        if (j != i && contains(j, point_on(i))) around[i].push_back(j);
      }
    }
    for (std::uint32_t i = 0; i < loops_.size(); ++i) {
      if (around[i].size() % 2 == 0) continue;
      loops_[i].parent = *std::max_element(
          around[i].begin(), around[i].end(),
          [&](std::uint32_t j, std::uint32_t k) { return around[j].size() < around[k].size(); });
    }
  }

 private:
  using Box = std::array<Point2, 2>;

  Box box(const SectionLoop& loop) const {
    Box b{points_[loop.vertices[0]], points_[loop.vertices[0]]};
    for (const std::uint32_t v : loop.vertices) {
      b[0] = {std::min(b[0].x, points_[v].x), std::min(b[0].y, points_[v].y)};
      b[1] = {std::max(b[1].x, points_[v].x), std::max(b[1].y, points_[v].y)};
    }
    return b;
  }

  /// The middle of a wall: a vertex may be shared by loops that touch.
  Point2 point_on(std::uint32_t loop) const {
    const Point2 p = points_[loops_[loop].vertices[0]], q = points_[loops_[loop].vertices[1]];
    return {(p.x + q.x) / 2, (p.y + q.y) / 2};
  }

  bool contains(std::uint32_t loop, Point2 p) const {
    const Box& b = boxes_[loop];
    if (p.x < b[0].x || p.y < b[0].y || p.x > b[1].x || p.y > b[1].y) return false;
    const std::vector<std::uint32_t>& vertices = loops_[loop].vertices;
    bool inside = false;
    for (std::size_t i = 0, last = vertices.size() - 1; i < vertices.size(); last = i++) {
      const Point2 u = points_[vertices[last]], v = points_[vertices[i]];
      if ((u.y > p.y) == (v.y > p.y)) continue;
      const double x = u.x + (p.y - u.y) / (v.y - u.y) * (v.x - u.x);
      if (p.x < x) inside = !inside;
    }
    return inside;
  }

  const std::vector<Point2>& points_;
  std::vector<SectionLoop>& loops_;
  std::vector<Box> boxes_;
};

}  // namespace

Result<std::vector<SectionLoop>> section_loops(const PlaneSection& plane) {
  const std::vector<Point2> points = project(plane);
  LoopTracer tracer(plane, points);
  if (const ContourEdge* wall = tracer.open_wall()) {
    return Error{.code = ErrorCode::open_chain,
                 .message = "the contour does not close",
                 .file = {},
                 .line = wall->line,
                 .contour = wall->contour};
  }
  std::vector<SectionLoop> loops = tracer.trace();
  Nesting(points, loops).find_parents();
  return loops;
}

}  // namespace crossloft
