/// First step of the section graph: what framing gave, with contour vertices that are crossings put on their
/// lines.

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "../geom/lattice_filters.h"
#include "../geom/parallel.h"
#include "../geom/plane_line.h"
#include "data_box.h"
#include "section_steps.h"

namespace crossloft::section_steps {
namespace {

double length(const LatticeVector& v) {
  return norm({static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])});
}

Vec3 position(const LatticePoint& p) { return {p.x, p.y, p.z}; }

/// A plane that vertices may be near.
struct NearPlane {
  std::uint32_t plane = 0;
  PlaneInDoubles at;
  double length = 0;  ///< of the normal

  /// Whether a real point is within `tolerance` of it, lattice units; rounding of about 2^-4 is far below any
  /// tolerance.
  bool holds(Vec3 p, double tolerance) const {
    double sum = at.normal.x * (p.x - at.origin.x);
    sum += at.normal.y * (p.y - at.origin.y);
    sum += at.normal.z * (p.z - at.origin.z);
    sum = std::abs(sum);
    return sum <= 2 * tolerance * length && sum / length <= tolerance;  // the first spares most divisions
  }
};

/// Shortest contour edge at each vertex of one plane, lattice units. The plane's vertices follow each other:
/// a list over those of all planes, made for each plane, would be most of the work with a stack of slices.
class ShortestEdges {
 public:
  ShortestEdges(const SectionGraph& graph, std::uint32_t p) {
    std::uint32_t last = 0;
    for (const Wall& w : graph.walls[p])
      first_ = std::min({first_, w.a, w.b}), last = std::max({last, w.a, w.b});
    if (graph.walls[p].empty()) return;
    of_.assign(last - first_ + 1, INFINITY);
    for (const Wall& w : graph.walls[p]) {
      const double l = norm(position(graph.points[w.a]) - position(graph.points[w.b]));
      of_[w.a - first_] = std::min(of_[w.a - first_], l);
      of_[w.b - first_] = std::min(of_[w.b - first_], l);
    }
  }
  /// Infinity where there is no edge.
  double operator[](std::uint32_t v) const {
    return v >= first_ && v - first_ < of_.size() ? of_[v - first_] : INFINITY;
  }

 private:
  std::uint32_t first_ = kNone;
  std::vector<double> of_;
};

/// The planes that meet plane i in a line. In a stack of slices there is none, and nothing to ask of a
/// vertex.
std::vector<std::uint32_t> planes_across(const SectionGraph& graph, std::uint32_t i) {
  std::vector<std::uint32_t> across;
  for (std::uint32_t j = 0; j < graph.planes.size(); ++j)
    if (line_axis(graph.planes[i], graph.planes[j]) >= 0) across.push_back(j);
  return across;
}

/// The point of the line of planes i, j whose dominant coordinate is that of `from`, rounded: at most sqrt(3)
/// times as far as the nearest.
std::optional<LatticePoint> drop_on_line(const SectionGraph& graph, LatticePointStore& store, std::uint32_t i,
                                         std::uint32_t j, const LatticePoint& from) {
  const int axis = line_axis(graph.planes[i], graph.planes[j]);
  LatticePoint point;
  if (axis < 0 || !line_point(store, graph.planes[i], graph.planes[j], std::llround(from[axis]), point))
    return std::nullopt;
  return point;
}

/// Where vertex v of plane i goes when it is near the planes of `near`: the common point of two of their
/// lines if that is within reach, else the nearest point of one line.
std::optional<LatticePoint> target(const SectionGraph& graph, LatticePointStore& store, std::uint32_t i,
                                   std::uint32_t v, const std::vector<std::uint32_t>& near, double reach) {
  const LatticePoint& from = graph.points[v];
  std::optional<LatticePoint> best;
  double best_way = reach;
  for (std::size_t m = 0; m < near.size(); ++m)
    for (std::size_t n = m + 1; n < near.size(); ++n) {
      LatticePoint corner;
      if (!store.meet(graph.planes[i], graph.planes[near[m]], graph.planes[near[n]], corner)) continue;
      const double way = norm(position(corner) - position(from));
      if (way <= best_way) best = corner, best_way = way;
    }
  if (best) return best;
  for (const std::uint32_t j : near) {
    const auto point = drop_on_line(graph, store, i, j, from);
    if (!point) continue;
    const double way = norm(position(*point) - position(from));
    if (way <= best_way && (!best || way < best_way)) best = point, best_way = way;
  }
  return best;
}

/// A vertex far off its plane in the file may lie on another plane there that it is not near any more: the
/// way to the line of both is long then, and can lead out of the arrangement.
bool is_within(const LatticeBox& box, const LatticePoint& point) {
  constexpr double kRounding = 2;
  for (int k = 0; k < 3; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    if (!(point[k] > static_cast<double>(box.lower[axis]) + kRounding &&
          point[k] < static_cast<double>(box.upper[axis]) - kRounding))
      return false;
  }
  return true;
}

/// A vertex near the interior of a wall of the same plane.
struct Touch {
  std::uint32_t wall = 0, vertex = 0;
  double along = 0, distance = 0;  ///< along the wall, times its length; from it, lattice units
};

/// By wall, those of one wall in its direction. Beyond `snapping` only as far as a quarter of the shortest
/// edge at the vertex and of the wall: what is small itself keeps its shape.
std::vector<Touch> find_touches(const SectionGraph& graph, std::uint32_t p, double snapping,
                                double tolerance) {
  std::vector<WallEnds> ends;
  const ShortestEdges shortest(graph, p);
  std::vector<Touch> touches;
  for (const auto& [w, v] : graph.locator(p, ends).near_touches(tolerance)) {
    const Wall& wall = graph.walls[p][w];
    const Vec3 from = position(graph.points[wall.a]), way = position(graph.points[wall.b]) - from,
               to = position(graph.points[v]) - from;
    const Touch touch{w, v, dot(to, way), norm(cross(to, way)) / norm(way)};
    if (touch.distance <= std::max(snapping, std::min(shortest[v], norm(way)) / 4)) touches.push_back(touch);
  }
  std::sort(touches.begin(), touches.end(), [](const Touch& s, const Touch& t) {
    return std::tie(s.wall, s.along, s.vertex) < std::tie(t.wall, t.along, t.vertex);
  });
  return touches;
}

/// REQUIRES: touches ordered as find_touches() does.
void lead_through(SectionGraph& graph, std::uint32_t p, const std::vector<Touch>& touches) {
  for (const Touch& touch : touches) {
    Wall rest = graph.walls[p][touch.wall];
    graph.walls[p][touch.wall].b = touch.vertex;
    rest.a = touch.vertex;
    std::swap(graph.walls[p][touch.wall], rest);
    graph.walls[p].push_back(rest);
  }
  cancel_pairs(graph.walls[p]);
}

}  // namespace

SectionGraph start(const FramedSections& framed) {
  SectionGraph graph;
  for (const FramedPlane& plane : framed.planes) graph.planes.push_back(plane.plane);
  graph.rows = SignRows(graph.planes);
  graph.walls.resize(graph.planes.size());
  std::size_t vertices = 0;
  for (const FramedPlane& plane : framed.planes) vertices += plane.vertices.size();
  graph.points.reserve(vertices);
  graph.row_of.reserve(vertices);
  for (std::uint32_t p = 0; p < framed.planes.size(); ++p) {
    const std::uint32_t base = graph.size();
    graph.add_on_plane(framed.planes[p].vertices, planes_across(graph, p));
    graph.walls[p].reserve(framed.planes[p].walls.size());
    for (const WallEdge& w : framed.planes[p].walls)
      graph.walls[p].push_back({base + w.a, base + w.b, w.contour, w.plane, w.line, false});
  }
  return graph;
}

double snapping_tolerance(const LatticePlane& plane) {
  constexpr double kSteps = 3;
  return kSteps * std::max(length(plane.e1), length(plane.e2));
}

namespace {

void join_touching(SectionGraph& graph, std::uint32_t p, double tolerance) {
  std::vector<WallEnds> ends;
  const double snapping = snapping_tolerance(graph.planes[p]);
  const std::vector<Touch> touches = find_touches(graph, p, snapping, std::max(snapping, tolerance));
  const std::vector<Wall> before = graph.walls[p];
  lead_through(graph, p, touches);
  const bool all_near =
      std::all_of(touches.begin(), touches.end(), [&](const Touch& t) { return t.distance <= snapping; });
  if (all_near || graph.locator(p, ends).conflicts().empty()) return;
  // Something finer lay between: then only what rounding has parted is joined.
  graph.walls[p] = before;
  lead_through(graph, p, find_touches(graph, p, snapping, snapping));
}

}  // namespace

bool join_touching(SectionGraph& graph, double tolerance, const Context& context) {
  return parallel_for(graph.planes.size(), context, "sections",
                      [&](std::size_t p) { join_touching(graph, static_cast<std::uint32_t>(p), tolerance); });
}

void move_onto_lines(SectionGraph& graph, const FramedSections& framed, LatticePointStore& store,
                     double tolerance, const Context& context) {
  const LatticeBox box = data_box(framed);
  std::vector<std::uint32_t> near;
  std::uint32_t base = 0;
  for (std::uint32_t i = 0; i < graph.planes.size() && !context.cancelled(); ++i) {
    const std::vector<Vec3>& inputs = framed.planes[i].input;
    const auto first = std::exchange(base, base + static_cast<std::uint32_t>(inputs.size()));
    std::vector<NearPlane> across;
    for (const std::uint32_t j : planes_across(graph, i))
      across.push_back({j, in_doubles(graph.planes[j]), length(graph.planes[j].normal)});
    if (across.empty()) continue;
    const ShortestEdges shortest(graph, i);
    for (std::uint32_t k = 0; k < inputs.size(); ++k) {
      const std::uint32_t v = first + k;
      if (shortest[v] == INFINITY) continue;
      const Vec3 at = framed.grid.scaled(inputs[k]);
      near.clear();
      for (const NearPlane& j : across)
        if (j.holds(at, tolerance)) near.push_back(j.plane);
      if (near.empty()) continue;
      const bool all_exact =
          std::all_of(near.begin(), near.end(), [&](auto j) { return graph.sign(v, j) == 0; });
      if (all_exact) ++graph.statistics.on_line;
      if (all_exact) continue;
      const auto point = target(graph, store, i, v, near, shortest[v] / 4);
      if (point && is_within(box, *point)) {
        graph.move(v, *point);
        ++graph.statistics.on_line;
      }
    }
  }
}

}  // namespace crossloft::section_steps
