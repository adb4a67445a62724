#include "section_graph.h"

#include <algorithm>
#include <bit>

#include "../geom/parallel.h"
#include "section_steps.h"

namespace crossloft {

std::uint32_t SectionGraph::common_planes(std::uint32_t u, std::uint32_t v) const {
  if (row_of[u] == row_of[v]) return rows.planes_through(row_of[u]);
  int count = 0;
  const auto zu = zero_of(u), zv = zero_of(v);
  for (std::size_t w = 0; w < zu.size(); ++w) count += std::popcount(zu[w] & zv[w]);
  return static_cast<std::uint32_t>(count);
}

std::uint32_t SectionGraph::add(const LatticePoint& point) {
  points.push_back(point);
  row_of.push_back(rows.of(point));
  return size() - 1;
}

void SectionGraph::add_on_plane(std::span<const LatticePoint> list, std::span<const std::uint32_t> across) {
  if (list.empty()) return;
  const std::uint32_t first = rows.of(list[0]);
  for (const LatticePoint& point : list)
    row_of.push_back(across.empty() ? first : rows.of(point, first, across));
  points.insert(points.end(), list.begin(), list.end());
}

void SectionGraph::take_back() {
  points.pop_back();
  row_of.pop_back();
}

void SectionGraph::move(std::uint32_t v, const LatticePoint& point) {
  points[v] = point;
  row_of[v] = rows.of(point);
}

SectionLocator SectionGraph::locator(std::uint32_t p, std::vector<WallEnds>& ends) const {
  ends.clear();
  for (const Wall& w : walls[p]) ends.push_back({w.a, w.b});
  return SectionLocator(planes[p], points, ends);
}

namespace {

Error self_crossing(const Wall& v, const Wall& w) {
  Error error{ErrorCode::self_crossing, "", "", v.line, v.source_plane, v.contour};
  error.message = v.contour == w.contour && v.source_plane == w.source_plane
                      ? "the contour crosses itself"
                      : "the contour crosses contour " + std::to_string(w.contour) + " of plane " +
                            std::to_string(w.source_plane);
  if (w.line != 0 && w.line != v.line) error.message += " (line " + std::to_string(w.line) + ")";
  return error;
}

/// The first conflict of a plane in file order is an error.
Result<Done> check_crossings(const SectionGraph& graph, std::uint32_t p) {
  std::vector<WallEnds> ends;
  const auto conflicts = graph.locator(p, ends).conflicts();
  if (conflicts.empty()) return Done{};
  const auto order = [&](const std::array<std::uint32_t, 2>& pair) {
    const Wall& w = graph.walls[p][pair[0]];
    return std::tie(w.source_plane, w.contour, w.line);
  };
  const auto first = *std::min_element(conflicts.begin(), conflicts.end(),
                                       [&](const auto& x, const auto& y) { return order(x) < order(y); });
  return self_crossing(graph.walls[p][first[0]], graph.walls[p][first[1]]);
}

Result<Done> check_crossings(const SectionGraph& graph, std::span<const section_steps::SoundPlane> planes,
                             const Context& context) {
  return for_all(graph.planes.size(), context, "sections", [&](std::size_t p) -> Result<Done> {
    return planes[p].is_sound ? Result<Done>(Done{}) : check_crossings(graph, static_cast<std::uint32_t>(p));
  });
}

/// Inner sides of the walls, and the arrangement vertices within the sections: of planes that were not sound
/// at first.
bool orient_walls(SectionGraph& graph, const Arrangement& arrangement,
                  std::vector<section_steps::SoundPlane>& planes, const Context& context) {
  const bool complete = parallel_for(graph.planes.size(), context, "sections", [&](std::size_t i) {
    if (planes[i].is_sound) return;
    const auto p = static_cast<std::uint32_t>(i);
    std::vector<WallEnds> ends;
    planes[i].corners = section_steps::orient_walls(graph, arrangement, p, graph.locator(p, ends));
  });
  if (complete) section_steps::add_arrangement_vertices(graph, arrangement, planes, context);
  return complete && !context.cancelled();
}

/// Where vertices and walls are. A wall that crosses no plane is in the face that one of its ends is in.
Result<Done> locate_all(SectionGraph& graph, const Arrangement& arrangement, const Context& context) {
  section_steps::RowLocations location(graph, arrangement);
  graph.locations.reserve(graph.size());
  for (std::uint32_t v = 0; v < graph.size(); ++v) {
    graph.locations.push_back(location.of(v));
    if (!graph.locations.back().found())
      return make_error(ErrorCode::internal, "a section vertex is outside of the arrangement");
  }
  const auto locate = [&](const Wall& w) {
    for (const std::uint32_t v : {w.a, w.b})
      if (graph.locations[v].dimension == 2 && !section_steps::crosses_a_plane(graph, w))
        return graph.locations[v];
    return section_steps::wall_location(graph, arrangement, w);
  };
  graph.wall_locations.resize(graph.walls.size());
  return for_all(graph.walls.size(), context, "sections", [&](std::size_t p) -> Result<Done> {
    std::vector<Location>& list = graph.wall_locations[p];
    list.reserve(graph.walls[p].size());
    for (const Wall& w : graph.walls[p]) {
      list.push_back(locate(w));
      if (!list.back().found())
        return Error{ErrorCode::internal,
                     "a contour edge crosses a plane uncut",
                     {},
                     w.line,
                     w.source_plane,
                     w.contour};
    }
    return Done{};
  });
}

}  // namespace

Result<SectionGraph> build_section_graph(const FramedSections& framed, const Arrangement& arrangement,
                                         LatticePointStore& store, const CrossingTolerances& tolerances,
                                         const Context& context) {
  namespace steps = section_steps;
  SectionGraph graph = steps::start(framed);
  if (!steps::join_touching(graph, tolerances.on, context))
    return make_error(ErrorCode::cancelled, "cancelled");
  steps::move_onto_lines(graph, framed, store, tolerances.on, context);
  if (!steps::cut_at_planes(graph, store, tolerances.on, context))
    return make_error(ErrorCode::internal, "a contour could not be cut at the planes");
  if (context.cancelled()) return make_error(ErrorCode::cancelled, "cancelled");
  steps::match_crossings(graph, arrangement, store, tolerances.match, context);
  if (context.cancelled()) return make_error(ErrorCode::cancelled, "cancelled");
  steps::merge_collinear_runs(graph, context);
  std::vector<steps::SoundPlane> planes;
  if (!steps::unify(graph, arrangement, planes, context))
    return make_error(ErrorCode::cancelled, "cancelled");
  if (auto checked = check_crossings(graph, planes, context); !checked) return checked.error();
  if (tolerances.simplify > 0) {
    steps::simplify_contours(graph, tolerances.simplify, context);
    if (context.cancelled()) return make_error(ErrorCode::cancelled, "cancelled");
    planes.assign(planes.size(), {});
    if (auto checked = check_crossings(graph, planes, context); !checked) return checked.error();
  }
  if (!orient_walls(graph, arrangement, planes, context))
    return make_error(ErrorCode::cancelled, "cancelled");
  if (auto located = locate_all(graph, arrangement, context); !located) return located.error();
  return graph;
}

namespace {

/// Vertices in the interior of arrangement edges: the edge, then the vertex, ascending.
std::vector<std::array<std::uint32_t, 2>> vertices_on_edges(const SectionGraph& graph) {
  std::vector<std::array<std::uint32_t, 2>> list;
  for (std::uint32_t v = 0; v < graph.size(); ++v)
    if (graph.locations[v].dimension == 1) list.push_back({graph.locations[v].index, v});
  std::sort(list.begin(), list.end());
  return list;
}

}  // namespace

std::string verify(const SectionGraph& graph, const Arrangement& arrangement) {
  for (std::uint32_t v = 0; v < graph.size(); ++v) {
    if (v > 0 && compare_lex(graph.points[v - 1], graph.points[v]) >= 0) return "vertices out of order";
    if (!graph.locations[v].found()) return "a vertex outside the arrangement";
    for (std::uint32_t p = 0; p < graph.planes.size(); ++p)
      if (graph.sign(v, p) != side_of_plane(graph.planes[p], graph.points[v])) return "a wrong sign";
  }
  const auto on_edges = vertices_on_edges(graph);
  const auto is_cut = [&](const Wall& w, const Location& at) {  // vertices are in order along the edge too
    const auto next = std::lower_bound(on_edges.begin(), on_edges.end(), std::array{at.index, w.a + 1});
    return next == on_edges.end() || (*next)[0] != at.index || (*next)[1] >= w.b;
  };
  for (std::uint32_t p = 0; p < graph.planes.size(); ++p) {
    std::vector<std::uint32_t> degree(graph.size(), 0);
    for (std::size_t i = 0; i < graph.walls[p].size(); ++i) {
      const Wall& w = graph.walls[p][i];
      if (graph.sign(w.a, p) != 0 || graph.sign(w.b, p) != 0) return "a wall off its plane";
      const Location at = section_steps::wall_location(graph, arrangement, w);
      if (!at.found() || at.dimension == 0 || at.dimension == 3) return "a wall that crosses a plane";
      const Location told = graph.wall_locations[p][i];
      if (told.dimension != at.dimension || told.index != at.index) return "a wall in the wrong place";
      if (at.dimension == 1 && !is_cut(w, at))
        return "a wall with a vertex of another section in its interior";
      ++degree[w.a], ++degree[w.b];
    }
    if (std::any_of(degree.begin(), degree.end(), [](auto d) { return d % 2 != 0; }))
      return "an open contour";
    std::vector<WallEnds> ends;
    const SectionLocator locator = graph.locator(p, ends);
    if (!locator.conflicts().empty()) return "contours that cross";
    for (std::uint32_t w = 0; w < ends.size(); ++w)
      if (locator.inside_left(w) != graph.walls[p][w].inside_left) return "a wall with its inner side wrong";
  }
  return {};
}

}  // namespace crossloft
