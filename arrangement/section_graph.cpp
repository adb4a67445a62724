#include "section_graph.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "../geom/parallel.h"
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

bool SectionGraph::share_line(std::uint32_t u, std::uint32_t v) const {
  bool one = false;
  for (std::uint32_t w = 0; w < words; ++w) {
    const std::uint64_t common = zero_of(u)[w] & zero_of(v)[w];
    if (common == 0) continue;
    if (one || (common & (common - 1)) != 0) return true;
    one = true;
  }
  return false;
}

std::uint32_t SectionGraph::add(const LatticePoint& point) {
  points.push_back(point);
  positive.resize(positive.size() + words);
  zero.resize(zero.size() + words);
  move(size() - 1, point);
  return size() - 1;
}

void SectionGraph::add_on_plane(std::uint32_t p, std::span<const LatticePoint> list,
                                std::span<const std::uint32_t> across) {
  if (list.empty()) return;
  const std::uint32_t first = add(list[0]);
  for (const LatticePoint& point : list.subspan(1)) {
    const std::uint32_t v = size();
    points.push_back(point);
    for (auto* rows : {&positive, &zero}) {
      rows->resize(rows->size() + words);
      std::copy_n(rows->begin() + std::ptrdiff_t{first} * words, words, rows->end() - words);
    }
    for (const std::uint32_t q : across) set_sign(v, q, side_of_plane(planes[q], point));
    set_sign(v, p, side_of_plane(planes[p], point));
  }
}

void SectionGraph::share_rows() {
  std::array<std::vector<std::uint32_t>, 4> row_in;  // by dimension and element
  std::vector<std::uint32_t> rows(size());
  std::vector<std::uint64_t> kept_positive, kept_zero;
  std::uint32_t count = 0;
  for (std::uint32_t v = 0; v < size(); ++v) {
    std::vector<std::uint32_t>& known = row_in[locations[v].dimension];
    if (locations[v].index >= known.size()) known.resize(locations[v].index + std::size_t{1}, kNone);
    std::uint32_t& row = known[locations[v].index];
    if (row == kNone) {
      row = count++;
      kept_positive.insert(kept_positive.end(), positive_of(v).begin(), positive_of(v).end());
      kept_zero.insert(kept_zero.end(), zero_of(v).begin(), zero_of(v).end());
    }
    rows[v] = row;
  }
  positive = std::move(kept_positive);
  zero = std::move(kept_zero);
  row_of = std::move(rows);
}

void SectionGraph::move(std::uint32_t v, const LatticePoint& point) {
  points[v] = point;
  for (std::uint32_t p = 0; p < planes.size(); ++p) set_sign(v, p, side_of_plane(planes[p], point));
}

void SectionGraph::set_sign(std::uint32_t v, std::uint32_t p, int side) {
  assert(row_of.empty());
  const std::uint64_t bit = std::uint64_t{1} << (p % 64);
  std::uint64_t &pos = positive[std::size_t{v} * words + p / 64], &on = zero[std::size_t{v} * words + p / 64];
  pos = side > 0 ? pos | bit : pos & ~bit;
  on = side == 0 ? on | bit : on & ~bit;
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

/// Orients the walls of a plane; the first conflict in file order is the error.
Result<Done> orient_walls(SectionGraph& graph, std::uint32_t p) {
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
  return Done{};
}

Result<Done> orient_walls(SectionGraph& graph, const Context& context) {
  return for_all(graph.planes.size(), context, "sections",
                 [&](std::size_t p) { return orient_walls(graph, static_cast<std::uint32_t>(p)); });
}

/// Where vertices and walls are. A wall that crosses no plane is in the face that one of its ends is in.
Result<Done> locate_all(SectionGraph& graph, const Arrangement& arrangement) {
  for (std::uint32_t v = 0; v < graph.size(); ++v) {
    graph.locations.push_back(arrangement.locate({graph.positive_of(v), graph.zero_of(v)}));
    if (!graph.locations.back().found())
      return make_error(ErrorCode::internal, "a section vertex is outside of the arrangement");
  }
  const auto locate = [&](const Wall& w) {
    for (const std::uint32_t v : {w.a, w.b})
      if (graph.locations[v].dimension == 2 && !section_steps::crosses_a_plane(graph, w))
        return graph.locations[v];
    return section_steps::wall_location(graph, arrangement, w);
  };
  for (const auto& walls : graph.walls) {
    std::vector<Location>& list = graph.wall_locations.emplace_back();
    for (const Wall& w : walls) {
      list.push_back(locate(w));
      if (!list.back().found())
        return Error{ErrorCode::internal,
                     "a contour edge crosses a plane uncut",
                     {},
                     w.line,
                     w.source_plane,
                     w.contour};
    }
  }
  return Done{};
}

}  // namespace

Result<SectionGraph> build_section_graph(const FramedSections& framed, const Arrangement& arrangement,
                                         LatticePointStore& store, const CrossingTolerances& tolerances,
                                         const Context& context) {
  namespace steps = section_steps;
  SectionGraph graph = steps::start(framed);
  if (!steps::join_touching(graph, tolerances.on, context))
    return make_error(ErrorCode::cancelled, "cancelled");
  steps::move_onto_lines(graph, framed, store, tolerances.on);
  if (context.cancelled()) return make_error(ErrorCode::cancelled, "cancelled");
  if (!steps::cut_at_planes(graph, store, tolerances.on))
    return make_error(ErrorCode::internal, "a contour could not be cut at the planes");
  steps::match_crossings(graph, arrangement, store, tolerances.match);
  if (context.cancelled()) return make_error(ErrorCode::cancelled, "cancelled");
  steps::merge_collinear_runs(graph);
  if (!steps::unify(graph, arrangement, context)) return make_error(ErrorCode::cancelled, "cancelled");
  if (auto oriented = orient_walls(graph, context); !oriented) return oriented.error();
  if (tolerances.simplify > 0) steps::simplify_contours(graph, tolerances.simplify);
  if (context.cancelled()) return make_error(ErrorCode::cancelled, "cancelled");
  const bool more = steps::add_arrangement_vertices(graph, arrangement);
  if (more || tolerances.simplify > 0)  // both bring new walls
    if (auto oriented = orient_walls(graph, context); !oriented) return oriented.error();
  if (auto located = locate_all(graph, arrangement); !located) return located.error();
  graph.share_rows();
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
    for (std::size_t i = 0; i < graph.walls[p].size(); ++i) {
      const Wall& w = graph.walls[p][i];
      if (graph.sign(w.a, p) != 0 || graph.sign(w.b, p) != 0) return "a wall off its plane";
      const Location at = section_steps::wall_location(graph, arrangement, w);
      if (!at.found() || at.dimension == 0 || at.dimension == 3) return "a wall that crosses a plane";
      const Location told = graph.wall_locations[p][i];
      if (told.dimension != at.dimension || told.index != at.index) return "a wall in the wrong place";
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
