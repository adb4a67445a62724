#include "section_graph.h"

#include <algorithm>
#include <bit>

#include "section_steps.h"

namespace crossloft {

int SectionGraph::sign(std::uint32_t v, std::uint32_t p) const {
  return sign_at({positive_of(v), zero_of(v)}, PlaneId{p});
}

std::uint32_t SectionGraph::common_planes(std::uint32_t u, std::uint32_t v) const {
  int count = 0;
  for (std::uint32_t w = 0; w < words; ++w) count += std::popcount(zero_of(u)[w] & zero_of(v)[w]);
  return static_cast<std::uint32_t>(count);
}

std::uint32_t SectionGraph::add(const LatticePoint& point) {
  points.push_back(point);
  positive.resize(positive.size() + words);
  zero.resize(zero.size() + words);
  move(size() - 1, point);
  return size() - 1;
}

void SectionGraph::move(std::uint32_t v, const LatticePoint& point) {
  points[v] = point;
  const std::span<std::uint64_t> pos{positive.data() + std::size_t{v} * words, words};
  const std::span<std::uint64_t> on{zero.data() + std::size_t{v} * words, words};
  std::fill(pos.begin(), pos.end(), 0);
  std::fill(on.begin(), on.end(), 0);
  for (std::uint32_t p = 0; p < planes.size(); ++p) {
    const int side = side_of_plane(planes[p], point);
    if (side > 0) set_bit(pos, PlaneId{p});
    if (side == 0) set_bit(on, PlaneId{p});
  }
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

/// Orients the walls of each plane; the first conflict in file order is the error.
Result<Done> orient_walls(SectionGraph& graph) {
  for (std::uint32_t p = 0; p < graph.planes.size(); ++p) {
    std::vector<WallEnds> ends;
    const SectionLocator locator = graph.locator(p, ends);
    const auto conflicts = locator.conflicts();
    if (!conflicts.empty()) {
      const auto order = [&](const std::array<std::uint32_t, 2>& pair) {
        const Wall& w = graph.walls[p][pair[0]];
        return std::tie(w.source_plane, w.contour, w.line);
      };
      const auto first = *std::min_element(conflicts.begin(), conflicts.end(),
                                           [&](const auto& x, const auto& y) { return order(x) < order(y); });
      return self_crossing(graph.walls[p][first[0]], graph.walls[p][first[1]]);
    }
    for (std::uint32_t w = 0; w < ends.size(); ++w) graph.walls[p][w].inside_left = locator.inside_left(w);
  }
  return Done{};
}

}  // namespace

Result<SectionGraph> build_section_graph(const FramedSections& framed, const Arrangement& arrangement,
                                         LatticePointStore& store, const CrossingTolerances& tolerances,
                                         const Context& context) {
  namespace steps = section_steps;
  SectionGraph graph = steps::start(framed);
  steps::join_touching(graph, tolerances.on);
  steps::move_onto_lines(graph, framed, store, tolerances.on);
  if (context.cancelled()) return make_error(ErrorCode::cancelled, "cancelled");
  if (!steps::cut_at_planes(graph, store, tolerances.on))
    return make_error(ErrorCode::internal, "a contour could not be cut at the planes");
  steps::match_crossings(graph, arrangement, store, tolerances.match);
  if (context.cancelled()) return make_error(ErrorCode::cancelled, "cancelled");
  steps::merge_collinear_runs(graph);
  steps::unify(graph, arrangement);
  if (auto oriented = orient_walls(graph); !oriented) return oriented.error();
  if (tolerances.simplify > 0) steps::simplify_contours(graph, tolerances.simplify);
  if (context.cancelled()) return make_error(ErrorCode::cancelled, "cancelled");
  steps::add_arrangement_vertices(graph, arrangement);
  if (auto oriented = orient_walls(graph); !oriented) return oriented.error();
  for (const auto& walls : graph.walls)
    for (const Wall& w : walls)
      if (!steps::wall_location(graph, arrangement, w).found())
        return Error{ErrorCode::internal, "a contour edge crosses a plane uncut", {}, w.line, w.source_plane, w.contour};
  for (std::uint32_t v = 0; v < graph.size(); ++v)
    graph.locations.push_back(arrangement.locate({graph.positive_of(v), graph.zero_of(v)}));
  return graph;
}

std::string verify(const SectionGraph& graph, const Arrangement& arrangement) {
  for (std::uint32_t v = 0; v < graph.size(); ++v) {
    if (v > 0 && compare_lex(graph.points[v - 1], graph.points[v]) >= 0) return "vertices out of order";
    if (!graph.locations[v].found()) return "a vertex outside the arrangement";
    for (std::uint32_t p = 0; p < graph.planes.size(); ++p)
      if (graph.sign(v, p) != side_of_plane(graph.planes[p], graph.points[v])) return "a wrong sign";
  }
  for (std::uint32_t p = 0; p < graph.planes.size(); ++p) {
    std::vector<std::uint32_t> degree(graph.size(), 0);
    for (const Wall& w : graph.walls[p]) {
      if (graph.sign(w.a, p) != 0 || graph.sign(w.b, p) != 0) return "a wall off its plane";
      const Location at = section_steps::wall_location(graph, arrangement, w);
      if (!at.found() || at.dimension == 0 || at.dimension == 3) return "a wall that crosses a plane";
      ++degree[w.a], ++degree[w.b];
    }
    if (std::any_of(degree.begin(), degree.end(), [](auto d) { return d % 2 != 0; })) return "an open contour";
    std::vector<WallEnds> ends;
    if (!graph.locator(p, ends).conflicts().empty()) return "contours that cross";
  }
  return {};
}

}  // namespace crossloft
