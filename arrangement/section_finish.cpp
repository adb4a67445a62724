/// Last steps of the section graph: collinear runs, one vertex a point, canonical order, arrangement
/// vertices.

#include <algorithm>
#include <atomic>
#include <numeric>

#include "../geom/parallel.h"
#include "../geom/parallel_sort.h"
#include "contour_chains.h"
#include "section_steps.h"

namespace crossloft::section_steps {
namespace {

Vec3 position(const LatticePoint& p) { return {p.x, p.y, p.z}; }

/// Removes vertices of the contours of one plane that snapping has bent by a hair: one that dips to the inner
/// side makes an external sliver with its neighbours where no other vertex is near, and with it go the
/// tetrahedra on it. Exactly collinear vertices do no such harm and stay: they are the sampling of the
/// contour.
class RunMerger {
 public:
  RunMerger(SectionGraph& graph, std::uint32_t plane, ContourPlaces& places)
      : graph_(graph),
        plane_(graph.planes[plane]),
        walls_(graph.walls[plane]),
        chains_(graph.walls[plane], places),
        vertices_(places.vertices()) {
    tolerance_ = snapping_tolerance(plane_);
  }
  void run();

 private:
  std::vector<std::uint32_t> candidates() const;
  bool near_segment(std::uint32_t u, std::uint32_t w, std::uint32_t v, double margin) const;
  bool all_near(std::uint32_t u, std::uint32_t w, std::uint32_t v,
                const std::vector<std::uint32_t>& hull) const;
  std::vector<std::uint32_t> hull_without(std::uint32_t v) const;
  void try_remove(std::uint32_t v);

  SectionGraph& graph_;
  LatticePlane plane_;
  const std::vector<Wall>& walls_;
  ContourChains chains_;
  const std::vector<std::uint32_t>& vertices_;  ///< of the plane
  double tolerance_ = 0;
  std::vector<std::vector<std::uint32_t>>
      hulls_;  ///< by wall, once a vertex is removed: of those it replaced
};

/// v projects into the open segment uw and is within tolerance of it, all that with a margin. Differences of
/// explicit points are exact, the products are good to 2^-4 lattice units.
bool RunMerger::near_segment(std::uint32_t u, std::uint32_t w, std::uint32_t v, double margin) const {
  const Vec3 a = position(graph_.points[u]), d = position(graph_.points[w]) - a,
             p = position(graph_.points[v]) - a;
  const double along = dot(p, d), length2 = dot(d, d), length = std::sqrt(length2);
  return along > margin * length && along < length2 - margin * length &&
         norm(cross(p, d)) <= (tolerance_ - margin) * length;
}

/// Whether near_segment() holds for v and all that its walls have replaced, whose convex hull is given. Where
/// a straight side is sampled finely one wall grows along it, and asking all that it has replaced again each
/// time would be quadratic. What is near is convex: if the corners of the hull are by more than twice the
/// rounding, each point in it is, as rounded. Only where a corner is nearer to the limit all are asked.
bool RunMerger::all_near(std::uint32_t u, std::uint32_t w, std::uint32_t v,
                         const std::vector<std::uint32_t>& hull) const {
  constexpr double kMargin = 0.25;
  const auto near = [&](double margin) {
    return [this, u, w, margin](std::uint32_t p) { return near_segment(u, w, p, margin); };
  };
  if (std::all_of(hull.begin(), hull.end(), near(kMargin))) return true;
  return std::all_of(hull.begin(), hull.end(), near(0)) && chains_.all_replaced_without(v, near(0));
}

/// The corners of the convex hull of v and all that its walls have replaced. All are vertices as framing left
/// them, whose numbers are in lexicographic order: along some direction of the plane.
std::vector<std::uint32_t> RunMerger::hull_without(std::uint32_t v) const {
  std::vector<std::uint32_t> all{v}, hull;
  if (!hulls_.empty())
    for (const std::uint32_t wall : chains_.walls_at(v))
      all.insert(all.end(), hulls_[wall].begin(), hulls_[wall].end());
  if (all.size() < 3) return all;
  std::sort(all.begin(), all.end());
  const auto turn = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return orient2d(plane_, graph_.points[a], graph_.points[b], graph_.points[c]);
  };
  for (const int way : {1, -1}) {
    const std::size_t first = hull.size();
    for (const std::uint32_t p : all) {
      while (hull.size() >= first + 2 && way * turn(hull[hull.size() - 2], hull.back(), p) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
  }
  std::sort(hull.begin(), hull.end());
  hull.erase(std::unique(hull.begin(), hull.end()), hull.end());
  return hull;
}

void RunMerger::try_remove(std::uint32_t v) {
  const auto [u, w] = chains_.neighbours(v);
  if (u == w || chains_.joined(u, w) || !near_segment(u, w, v, 0)) return;
  if (orient2d(plane_, graph_.points[u], graph_.points[w], graph_.points[v]) == 0) return;
  std::vector<std::uint32_t> hull = hull_without(v);
  if (!all_near(u, w, v, hull)) return;
  const auto [stays, goes] = chains_.walls_at(v);
  if (hulls_.empty()) hulls_.resize(walls_.size());
  hulls_[stays] = std::move(hull);
  hulls_[goes] = {};
  chains_.remove(v);
  ++graph_.statistics.merged_collinear;
}

/// Vertices of degree 2 in the interior of a face, by coordinates: by number, as framing left them, since all
/// that were moved or added since lie on lines.
std::vector<std::uint32_t> RunMerger::candidates() const {
  std::vector<std::uint32_t> found;
  for (const std::uint32_t v : vertices_)
    if (chains_.degree(v) == 2 && !graph_.on_line(v)) found.push_back(v);
  std::sort(found.begin(), found.end());
  return found;
}

void RunMerger::run() {
  for (const std::uint32_t v : candidates()) try_remove(v);
  chains_.finish();
}

/// True iff the vertices are in strictly lexicographic order and all in use.
bool is_in_order(const SectionGraph& graph, const std::vector<std::uint8_t>& used, const Context& context) {
  std::atomic<bool> good{true};
  for_blocks(graph.size(), context, "sections", [&](std::size_t first, std::size_t last) {
    for (std::size_t v = first; v < last && good.load(std::memory_order_relaxed); ++v)
      if (used[v] == 0 || (v > 0 && compare_lex(graph.points[v - 1], graph.points[v]) >= 0))
        good.store(false, std::memory_order_relaxed);
  });
  return good;
}

/// A vertex with what mostly decides its place, so that sorting need not look at the points.
struct Ordered {
  double x = 0;
  std::uint32_t number = 0;
};

/// The vertices in use in lexicographic order, equal ones by number.
std::vector<Ordered> in_order(const SectionGraph& graph, const std::vector<std::uint8_t>& used,
                              const Context& context) {
  std::vector<Ordered> list;
  list.reserve(graph.size());
  for (std::uint32_t v = 0; v < graph.size(); ++v)
    if (used[v] != 0) list.push_back({graph.points[v].x, v});
  sort_in_parallel(list, context, "sections", [&](const Ordered& a, const Ordered& b) {
    if (a.x != b.x) return a.x < b.x;  // rounding is monotone
    const int s = compare_lex(graph.points[a.number], graph.points[b.number]);
    return s != 0 ? s < 0 : a.number < b.number;
  });
  return list;
}

void cancel_all_pairs(SectionGraph& graph, const Context& context) {
  parallel_for(graph.walls.size(), context, "sections", [&](std::size_t p) { cancel_pairs(graph.walls[p]); });
}

/// Puts vertices into that order, equal ones into one; returns their new numbers.
std::vector<std::uint32_t> reorder(SectionGraph& graph, const std::vector<Ordered>& ordered,
                                   const Context& context) {
  std::vector<std::uint32_t> number(graph.size(), kNone), rows;
  std::vector<LatticePoint> points;
  const auto is_new = [&](std::size_t k) {
    return k == 0 || ordered[k - 1].x != ordered[k].x ||
           !equal(graph.points[ordered[k - 1].number], graph.points[ordered[k].number]);
  };
  number_kept(
      ordered.size(), context, "sections", is_new,
      [&](std::size_t count) { points.resize(count), rows.resize(count); },
      [&](std::size_t k, std::size_t n) {
        const std::uint32_t v = ordered[k].number;
        number[v] = static_cast<std::uint32_t>(n);
        points[n] = graph.points[v];
        rows[n] = graph.row_of[v];
      });
  for (std::size_t k = 1; k < ordered.size(); ++k)
    if (!is_new(k)) number[ordered[k].number] = number[ordered[k - 1].number];
  graph.points = std::move(points);
  graph.row_of = std::move(rows);
  return number;
}

/// Vertices into lexicographic order, equal ones into one, those without a wall out unless `kept`.
void renumber(SectionGraph& graph, const std::vector<std::uint8_t>& kept, const Context& context) {
  std::vector<std::uint8_t> used = kept;
  const auto use = [&](std::uint32_t v) { std::atomic_ref(used[v]).store(1, std::memory_order_relaxed); };
  parallel_for(graph.walls.size(), context, "sections", [&](std::size_t p) {
    for (const Wall& w : graph.walls[p]) use(w.a), use(w.b);
  });
  if (is_in_order(graph, used, context)) return cancel_all_pairs(graph, context);
  const std::vector<std::uint32_t> number = reorder(graph, in_order(graph, used, context), context);
  if (context.cancelled()) return;
  parallel_for(graph.walls.size(), context, "sections", [&](std::size_t p) {
    for (Wall& w : graph.walls[p]) w.a = number[w.a], w.b = number[w.b];
    cancel_pairs(graph.walls[p]);
  });
}

/// Replaces wall w of plane p by pieces through `between`, which lie on it.
void cut_wall(SectionGraph& graph, std::uint32_t p, std::uint32_t w, std::vector<std::uint32_t> between) {
  const Wall wall = graph.walls[p][w];  // vertices are in lexicographic order, so along the wall too
  std::sort(between.begin(), between.end());
  between.erase(std::unique(between.begin(), between.end()), between.end());
  std::uint32_t from = wall.a;
  for (const std::uint32_t v : between) {
    Wall piece = wall;
    piece.a = from, piece.b = v;
    graph.walls[p].push_back(piece);
    from = v;
  }
  graph.walls[p][w].a = from;
}

bool strictly_on(const SectionGraph& graph, std::uint32_t p, const Wall& wall, std::uint32_t v) {
  return v > wall.a && v < wall.b &&
         orient2d(graph.planes[p], graph.points[wall.a], graph.points[wall.b], graph.points[v]) == 0;
}

/// Contours of one plane that touch: a vertex inside another wall cuts it; what then runs double cancels.
/// Without conflicts the walls stay as they are, but for their numbers, and are oriented while there is a
/// locator.
SoundPlane cut_touching(SectionGraph& graph, const Arrangement& arrangement, std::uint32_t p) {
  std::vector<WallEnds> ends;
  const SectionLocator locator = graph.locator(p, ends);
  const auto conflicts = locator.conflicts();
  if (conflicts.empty()) return {true, orient_walls(graph, arrangement, p, locator)};
  std::vector<std::vector<std::uint32_t>> touching(graph.walls[p].size());
  bool any = false;
  for (const auto& [v, w] : conflicts)
    for (const auto& [cut, by] : {std::pair{v, w}, std::pair{w, v}})
      for (const std::uint32_t end : {ends[by].a, ends[by].b})
        if (strictly_on(graph, p, graph.walls[p][cut], end)) {
          touching[cut].push_back(end);
          any = true;
        }
  for (std::uint32_t w = 0; w < touching.size(); ++w)
    if (!touching[w].empty()) cut_wall(graph, p, w, touching[w]);
  if (any) cancel_pairs(graph.walls[p]);
  return {};
}

/// Walls along an arrangement edge are cut at every section vertex there, of any plane; that plane is to be
/// looked at again.
void cut_along_edges(SectionGraph& graph, const Arrangement& arrangement, std::vector<SoundPlane>& planes) {
  std::vector<std::array<std::uint32_t, 2>> on_edge;  // edge, vertex
  RowLocations location(graph, arrangement);
  for (std::uint32_t v = 0; v < graph.size(); ++v) {
    if (!graph.on_line(v)) continue;
    const Location at = location.of(v);
    if (at.found() && at.dimension == 1) on_edge.push_back({at.index, v});
  }
  if (on_edge.empty()) return;
  std::sort(on_edge.begin(), on_edge.end());
  for (std::uint32_t p = 0; p < graph.planes.size(); ++p) {
    bool any = false;
    for (std::uint32_t w = static_cast<std::uint32_t>(graph.walls[p].size()); w-- > 0;) {
      const Wall wall = graph.walls[p][w];
      if (!graph.share_line(wall.a, wall.b)) continue;
      const Location at = wall_location(graph, arrangement, wall);
      if (!at.found() || at.dimension != 1) continue;
      std::vector<std::uint32_t> between;
      const auto begin = std::lower_bound(on_edge.begin(), on_edge.end(), std::array{at.index, wall.a + 1});
      for (auto it = begin; it != on_edge.end() && (*it)[0] == at.index && (*it)[1] < wall.b; ++it)
        between.push_back((*it)[1]);
      if (between.empty()) continue;
      cut_wall(graph, p, w, between);
      any = true;
    }
    if (!any) continue;
    cancel_pairs(graph.walls[p]);
    planes[p] = {};
  }
}

/// The arrangement vertices on a plane but not on the box.
std::vector<ArrVertexId> inner_vertices(const Arrangement& arrangement, PlaneId plane) {
  std::vector<ArrVertexId> list;
  for (std::uint32_t v = 0; v < arrangement.vertex_count(); ++v) {
    const ArrVertexId id{v};
    if (!arrangement.on_box(id) && has_bit(arrangement.signs(id).zero, plane)) list.push_back(id);
  }
  return list;
}

}  // namespace

void cancel_pairs(std::vector<Wall>& walls) {
  for (Wall& w : walls)
    if (w.a > w.b) std::swap(w.a, w.b);
  std::erase_if(walls, [](const Wall& w) { return w.a == w.b; });
  const auto before = [](const Wall& x, const Wall& y) {
    return std::tie(x.a, x.b, x.source_plane, x.contour, x.line) <
           std::tie(y.a, y.b, y.source_plane, y.contour, y.line);
  };
  if (!std::is_sorted(walls.begin(), walls.end(), before)) std::sort(walls.begin(), walls.end(), before);
  auto odd = walls.begin();  // the end of those that stay
  for (const Wall& w : walls) {
    if (odd != walls.begin() && odd[-1].a == w.a && odd[-1].b == w.b)
      --odd;
    else
      *odd++ = w;
  }
  walls.erase(odd, walls.end());
}

bool crosses_a_plane(const SectionGraph& graph, const Wall& wall) {
  if (graph.row_of[wall.a] == graph.row_of[wall.b]) return false;
  const SignView a = graph.signs_of(wall.a), b = graph.signs_of(wall.b);
  for (std::size_t w = 0; w < a.pos.size(); ++w)
    if (((a.pos[w] ^ b.pos[w]) & ~a.zero[w] & ~b.zero[w]) != 0) return true;
  return false;
}

Location wall_location(const SectionGraph& graph, const Arrangement& arrangement, const Wall& wall) {
  if (crosses_a_plane(graph, wall)) return {};
  const SignView a = graph.signs_of(wall.a), b = graph.signs_of(wall.b);
  std::vector<SignWord> positive(a.pos.size()), zero(a.pos.size());
  for (std::size_t w = 0; w < a.pos.size(); ++w) {
    positive[w] = a.pos[w] | b.pos[w];
    zero[w] = a.zero[w] & b.zero[w];
  }
  return arrangement.locate({positive, zero});
}

void merge_collinear_runs(SectionGraph& graph, const Context& context) {
  ContourPlaces places(graph.size());
  for (std::uint32_t p = 0; p < graph.planes.size() && !context.cancelled(); ++p)
    RunMerger(graph, p, places).run();
}

void drop_bare_vertices(SectionGraph& graph, const Context& context) {
  renumber(graph, std::vector<std::uint8_t>(graph.size(), 0), context);
}

bool unify(SectionGraph& graph, const Arrangement& arrangement, std::vector<SoundPlane>& planes,
           const Context& context) {
  drop_bare_vertices(graph, context);
  planes.assign(graph.planes.size(), {});
  const auto cut = [&](std::size_t p) {
    planes[p] = cut_touching(graph, arrangement, static_cast<std::uint32_t>(p));
  };
  if (!parallel_for(graph.planes.size(), context, "sections", cut)) return false;
  cut_along_edges(graph, arrangement, planes);
  drop_bare_vertices(graph, context);
  return !context.cancelled();
}

PlaneCorners orient_walls(SectionGraph& graph, const Arrangement& arrangement, std::uint32_t p,
                          const SectionLocator& locator) {
  std::vector<Wall>& walls = graph.walls[p];
  for (std::uint32_t w = 0; w < walls.size(); ++w) walls[w].inside_left = locator.inside_left(w);
  PlaneCorners corners;
  corners.vertices = inner_vertices(arrangement, PlaneId{p});
  for (const ArrVertexId v : corners.vertices)
    corners.outside.push_back(locator.locate(arrangement.point(v)) == SectionLocator::Place::outside ? 1 : 0);
  return corners;
}

void add_arrangement_vertices(SectionGraph& graph, const Arrangement& arrangement,
                              std::span<const SoundPlane> planes, const Context& context) {
  const std::uint32_t count = arrangement.vertex_count();
  std::vector<bool> in(count, false), out(count, false);
  for (const auto& [is_sound, corners] : planes)
    for (std::size_t k = 0; k < corners.vertices.size(); ++k)
      (corners.outside[k] != 0 ? out : in)[corners.vertices[k].value] = true;
  bool any = false;
  for (std::uint32_t v = 0; v < count; ++v) {
    if (in[v] && out[v]) ++graph.statistics.disagreeing;
    if (!in[v]) continue;
    graph.add(arrangement.point(ArrVertexId{v}));
    any = true;
  }
  if (any) renumber(graph, std::vector<std::uint8_t>(graph.size(), 1), context);
}

}  // namespace crossloft::section_steps
