/// Second step: contours that close, without vertices in one place and without spikes.

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "../geom/disjoint_sets.h"
#include "repair_steps.h"
#include "section_edit.h"
#include "segment_distance.h"

namespace crossloft::repair_steps {
namespace {

/// The walls at each vertex of a section.
class WallFans {
 public:
  explicit WallFans(PlaneSection& section) : section_(section), fans_(section.vertices.size()) {
    for (std::uint32_t e = 0; e < section.edges.size(); ++e)
      if (is_wall(section.edges[e])) {
        fans_[section.edges[e].a].push_back(e);
        fans_[section.edges[e].b].push_back(e);
      }
  }

  std::uint32_t size() const { return static_cast<std::uint32_t>(fans_.size()); }
  const std::vector<std::uint32_t>& at(std::uint32_t v) const { return fans_[v]; }
  std::uint32_t other_end(std::uint32_t edge, std::uint32_t v) const {
    const ContourEdge& e = section_.edges[edge];
    return e.a == v ? e.b : e.a;
  }
  /// The first of two walls of v takes the place of both; it vanishes if they lead to one vertex.
  void bypass(std::uint32_t v) {
    const std::uint32_t e = fans_[v][0], f = fans_[v][1];
    const std::uint32_t u = other_end(e, v), w = other_end(f, v);
    std::erase(fans_[w], f);
    section_.edges[f] = dead();
    fans_[v].clear();
    if (u == w) {
      std::erase(fans_[u], e);
      section_.edges[e] = dead();
      return;
    }
    section_.edges[e].a = u, section_.edges[e].b = w;
    fans_[w].push_back(e);
  }
  static ContourEdge dead() { return {0, 0, 0, 0, kNone, 0}; }

 private:
  PlaneSection& section_;
  std::vector<std::vector<std::uint32_t>> fans_;
};

void drop_dead(PlaneSection& section) {
  std::erase_if(section.edges, [](const ContourEdge& e) { return e.a == e.b; });
}

struct Tally {
  std::uint32_t count = 0, first = kNone;
  double distance = 0;
  void add(std::uint32_t vertex, double d) {
    ++count;
    first = std::min(first, vertex);
    distance = std::max(distance, d);
  }
};

void tell(Work& work, WorkPlane& plane, RepairKind kind, const std::map<std::uint32_t, Tally>& tallies,
          const char* what) {
  for (const auto& [contour, t] : tallies)
    work.note({kind, plane.source, contour, t.first, t.count, t.distance, plane.section.vertices[t.first],
               count_of(t.count, "vertex", "vertices") + what});
  plane.edited |= !tallies.empty();
}

bool has_short_edge(const PlaneSection& p, double tolerance) {
  return std::any_of(p.edges.begin(), p.edges.end(), [&](const ContourEdge& e) {
    return norm(p.vertices[e.a] - p.vertices[e.b]) <= tolerance;
  });
}

/// Vertices on their way into one of their neighbours.
class Merging {
 public:
  Merging(const Work& work, PlaneSection& section)
      : section_(section),
        tolerance_(work.capped(work.options.repeated * work.diagonal)),
        limit_(work.options.limit * work.diagonal),
        reach_(section.vertices.size(), 0) {}

  /// In lexicographic order, each vertex takes those that it is connected with through what it has taken, and
  /// that are no further from itself than the tolerance: so a run of short edges does not become a point.
  bool pass() {
    if (!has_short_edge(section_, tolerance_)) return false;
    const auto edges = edges_by_vertex(section_);
    std::vector<std::uint32_t> order, into(section_.vertices.size(), kNone);
    for (std::uint32_t v = 0; v < edges.size(); ++v)
      if (!edges[v].empty()) order.push_back(v);
    std::sort(order.begin(), order.end(),
              [&](auto v, auto w) { return section_.vertices[v] < section_.vertices[w]; });
    bool any = false;
    for (const std::uint32_t v : order)
      if (into[v] == kNone) any |= take_neighbours(v, edges, into);
    for (ContourEdge& e : section_.edges) e.a = into[e.a], e.b = into[e.b];
    drop_dead(section_);
    return any;
  }
  /// By contour.
  std::map<std::uint32_t, Tally> tallies;

 private:
  bool take_neighbours(std::uint32_t v, const std::vector<std::vector<std::uint32_t>>& edges,
                       std::vector<std::uint32_t>& into) {
    into[v] = v;
    std::vector<std::uint32_t> taken{v};
    for (std::size_t k = 0; k < taken.size(); ++k)
      for (const std::uint32_t e : edges[taken[k]])
        for (const std::uint32_t w : {section_.edges[e].a, section_.edges[e].b}) {
          const double way = norm(section_.vertices[w] - section_.vertices[v]);
          if (into[w] != kNone || way > tolerance_ || reach_[w] + way > limit_) continue;
          into[w] = v;
          reach_[v] = std::max(reach_[v], reach_[w] + way);
          tallies[section_.edges[e].contour].add(w, reach_[w] + way);
          taken.push_back(w);
        }
    return taken.size() > 1;
  }

  PlaneSection& section_;
  double tolerance_, limit_;
  std::vector<double> reach_;  ///< [vertex] how far from it are those that it has taken, at most
};

std::set<std::uint32_t> contours_of(const PlaneSection& p) {
  std::set<std::uint32_t> contours;
  for (const ContourEdge& e : p.edges) contours.insert(e.contour);
  return contours;
}

/// Contours whose vertices have all become one.
void tell_vanished(Work& work, const WorkPlane& plane, const std::set<std::uint32_t>& before,
                   const std::map<std::uint32_t, Tally>& tallies) {
  const std::set<std::uint32_t> after = contours_of(plane.section);
  for (const auto& [contour, t] : tallies) {
    if (after.contains(contour) || !before.contains(contour)) continue;
    const bool tiny = 2 * t.distance <= work.options.tiny_loop * work.diagonal;
    work.note({tiny ? RepairKind::tiny_loop : RepairKind::contour_left_out, plane.source, contour, t.first,
               t.count, t.distance, plane.section.vertices[t.first],
               "its vertices are one: the contour was left out"});
  }
}

void merge_repeated(Work& work, WorkPlane& plane) {
  PlaneSection& p = plane.section;
  Merging merging(work, p);
  for (const ContourEdge& e : p.edges)
    if (e.a == e.b) merging.tallies[e.contour].add(e.a, 0);
  drop_dead(p);
  const std::set<std::uint32_t> before = contours_of(p);
  while (merging.pass()) {
  }
  tell(work, plane, RepairKind::repeated_vertices, merging.tallies, " in the place of their neighbours");
  tell_vanished(work, plane, before, merging.tallies);
}

/// Width of the spike u v w, infinite if there is none.
double spike_width(const PlaneSection& p, std::uint32_t u, std::uint32_t v, std::uint32_t w) {
  const Vec3 a = p.vertices[u], b = p.vertices[v], c = p.vertices[w];
  if (!(dot(a - b, c - b) > 0)) return HUGE_VAL;
  return std::min(distance_to_segment(b, a, c), distance_to_segment(b, c, a));
}

bool remove_spikes(Work& work, WorkPlane& plane) {
  PlaneSection& p = plane.section;
  const double tolerance = work.capped(work.options.spike * work.diagonal);
  WallFans fans(p);
  std::map<std::uint32_t, Tally> tallies;
  // By coordinates, so that what is left does not depend on the order of the file.
  std::set<std::pair<Vec3, std::uint32_t>> due;
  for (std::uint32_t v = 0; v < fans.size(); ++v)
    if (fans.at(v).size() == 2) due.emplace(p.vertices[v], v);
  while (!due.empty()) {
    const std::uint32_t v = due.begin()->second;
    due.erase(due.begin());
    if (fans.at(v).size() != 2) continue;
    const std::uint32_t u = fans.other_end(fans.at(v)[0], v), w = fans.other_end(fans.at(v)[1], v);
    const double width = spike_width(p, u, v, w);
    if (width > tolerance) continue;
    tallies[p.edges[fans.at(v)[0]].contour].add(v, width);
    fans.bypass(v);
    for (const std::uint32_t next : {u, w}) due.emplace(p.vertices[next], next);
  }
  drop_dead(p);
  tell(work, plane, RepairKind::spikes, tallies, " where the contour turned back on itself");
  return !tallies.empty();
}

/// Between two ends, by their numbers in the list of ends.
struct Gap {
  double length = 0;
  std::uint32_t a = 0, b = 0;
};

/// Vertices with an odd number of walls, in lexicographic order.
std::vector<std::uint32_t> open_ends(const PlaneSection& p) {
  std::map<Vec3, std::pair<std::uint32_t, std::uint32_t>> degree;  // a vertex, and how many walls
  for (const ContourEdge& e : p.edges)
    if (is_wall(e))
      for (const std::uint32_t v : {e.a, e.b}) {
        auto& [vertex, count] = degree.try_emplace(p.vertices[v], v, 0).first->second;
        vertex = std::min(vertex, v);
        ++count;
      }
  std::vector<std::uint32_t> ends;
  for (const auto& [position, entry] : degree)
    if (entry.second % 2 != 0) ends.push_back(entry.first);
  return ends;
}

/// Pairs of ends that are near, the nearest first.
std::vector<Gap> gaps_between(const PlaneSection& p, const std::vector<std::uint32_t>& ends, double widest) {
  std::vector<Gap> gaps;
  if (!(widest > 0)) return gaps;
  std::map<Vec3, std::vector<std::uint32_t>> cells;  // a bit wider: a quotient may be rounded up
  const auto cell = [size = 1.5 * widest](Vec3 v) {
    return Vec3{std::floor(v.x / size), std::floor(v.y / size), std::floor(v.z / size)};
  };
  for (std::uint32_t i = 0; i < ends.size(); ++i) {
    const Vec3 v = p.vertices[ends[i]], at = cell(v);
    for (int k = 0; k < 27; ++k) {
      const Vec3 aside{k % 3 - 1.0, k / 3 % 3 - 1.0, k / 9 - 1.0};
      const auto near = cells.find(at + aside);
      if (near == cells.end()) continue;
      for (const std::uint32_t j : near->second)
        if (const double d = norm(p.vertices[ends[j]] - v); d <= widest) gaps.push_back({d, j, i});
    }
    cells[at].push_back(i);
  }
  std::sort(gaps.begin(), gaps.end(), [](const Gap& x, const Gap& y) {
    return std::tie(x.length, x.a, x.b) < std::tie(y.length, y.a, y.b);
  });
  return gaps;
}

/// By vertex: the first of its walls.
std::vector<std::uint32_t> first_walls(const PlaneSection& p) {
  std::vector<std::uint32_t> first(p.vertices.size(), kNone);
  for (std::uint32_t e = 0; e < p.edges.size(); ++e)
    if (is_wall(p.edges[e]))
      for (const std::uint32_t v : {p.edges[e].a, p.edges[e].b}) first[v] = std::min(first[v], e);
  return first;
}

/// `wall` is one at a.
void close_gap(Work& work, WorkPlane& plane, std::uint32_t a, std::uint32_t b, const ContourEdge& wall,
               double length) {
  PlaneSection& p = plane.section;
  ContourEdge edge = wall;
  edge.a = a, edge.b = b;
  p.edges.push_back(edge);
  plane.edited = true;
  work.note({RepairKind::contour_closed, plane.source, edge.contour, a, 1, length, p.vertices[a],
             "its ends were joined, vertices " + std::to_string(a) + " and " + std::to_string(b)});
}

/// Takes out the connected walls around each end.
void leave_out(Work& work, WorkPlane& plane, const std::vector<std::uint32_t>& ends) {
  PlaneSection& p = plane.section;
  const std::vector<std::uint32_t> walls = first_walls(p);
  DisjointSets parts(p.vertices.size());
  for (const ContourEdge& e : p.edges)
    if (is_wall(e)) parts.join(e.a, e.b);
  std::map<std::uint32_t, std::uint32_t> open;  // part -> number of edges taken out
  std::map<std::uint32_t, std::uint32_t> first_end, contour;
  for (const std::uint32_t v : ends) {
    open[parts.find(v)] = 0;
    first_end.try_emplace(parts.find(v), v);
    contour.try_emplace(parts.find(v), p.edges[walls[v]].contour);
  }
  std::erase_if(p.edges, [&](const ContourEdge& e) {
    const auto part = is_wall(e) ? open.find(parts.find(e.a)) : open.end();
    if (part == open.end()) return false;
    ++part->second;
    return true;
  });
  plane.edited = true;
  for (const auto& [part, count] : open)
    work.note({RepairKind::contour_left_out, plane.source, contour[part], first_end[part], count, 0,
               p.vertices[first_end[part]],
               "the chain of " + count_of(count, "edge", "edges") + " does not close and was left out"});
}

void close_chains(Work& work, WorkPlane& plane) {
  const PlaneSection& p = plane.section;
  const std::vector<std::uint32_t> ends = open_ends(p), walls = first_walls(p);
  std::vector<bool> joined(ends.size(), false);
  for (const Gap& gap : gaps_between(p, ends, work.capped(work.options.close_gap * work.diagonal))) {
    if (joined[gap.a] || joined[gap.b]) continue;
    joined[gap.a] = joined[gap.b] = true;
    const ContourEdge wall = p.edges[walls[ends[gap.a]]];
    close_gap(work, plane, ends[gap.a], ends[gap.b], wall, gap.length);
  }
  std::vector<std::uint32_t> open;
  for (std::size_t k = 0; k < ends.size(); ++k)
    if (!joined[k]) open.push_back(ends[k]);
  if (!open.empty()) leave_out(work, plane, open);
}

}  // namespace

bool remove_new_spikes(Work& work) {
  bool any = false;
  for (WorkPlane& plane : work.planes)
    if (plane.edited && !work.context.cancelled() && remove_spikes(work, plane)) any = true;
  return any;
}

void repair_chains(Work& work) {
  for (WorkPlane& plane : work.planes) {
    if (work.context.cancelled()) return;
    merge_repeated(work, plane);
    remove_spikes(work, plane);
    close_chains(work, plane);
  }
}

}  // namespace crossloft::repair_steps
