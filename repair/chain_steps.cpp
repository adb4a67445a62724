/// Second step: contours that close, without vertices in one place and without spikes.

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "../geom/disjoint_sets.h"
#include "repair_steps.h"
#include "section_edit.h"
#include "segment_distance.h"

namespace crossloft::repair_steps {
namespace {

/// The walls at each vertex of a section, by position: equal coordinates are one vertex.
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

/// Ends of edges that are short become the vertex of least coordinates among them.
void merge_repeated(Work& work, WorkPlane& plane) {
  PlaneSection& p = plane.section;
  const double tolerance = work.options.repeated * work.diagonal;
  DisjointSets parts(p.vertices.size());
  std::map<std::uint32_t, Tally> tallies;
  for (const ContourEdge& e : p.edges) {
    const double length = norm(p.vertices[e.a] - p.vertices[e.b]);
    if (length > tolerance || (e.a != e.b && parts.find(e.a) == parts.find(e.b))) continue;
    parts.join(e.a, e.b);
    tallies[e.contour].add(e.b, length);
  }
  if (tallies.empty()) return;
  std::vector<std::uint32_t> least(p.vertices.size(), kNone);
  for (std::uint32_t v = 0; v < p.vertices.size(); ++v) {
    std::uint32_t& l = least[parts.find(v)];
    if (l == kNone || p.vertices[v] < p.vertices[l]) l = v;
  }
  for (ContourEdge& e : p.edges) e.a = least[parts.find(e.a)], e.b = least[parts.find(e.b)];
  drop_dead(p);
  tell(work, plane, RepairKind::repeated_vertices, tallies, " in the place of their neighbours");
}

/// Width of the spike u v w, infinite if there is none.
double spike_width(const PlaneSection& p, std::uint32_t u, std::uint32_t v, std::uint32_t w) {
  const Vec3 a = p.vertices[u], b = p.vertices[v], c = p.vertices[w];
  if (!(dot(a - b, c - b) > 0)) return HUGE_VAL;
  return std::min(distance_to_segment(b, a, c), distance_to_segment(b, c, a));
}

bool remove_spikes(Work& work, WorkPlane& plane) {
  PlaneSection& p = plane.section;
  const double tolerance = work.options.spike * work.diagonal;
  WallFans fans(p);
  std::map<std::uint32_t, Tally> tallies;
  std::vector<std::uint32_t> due;
  for (std::uint32_t v = 0; v < fans.size(); ++v) due.push_back(v);
  const auto less = [&](std::uint32_t v, std::uint32_t w) { return p.vertices[v] > p.vertices[w]; };
  std::sort(due.begin(), due.end(), less);
  while (!due.empty()) {
    const std::uint32_t v = due.back();
    due.pop_back();
    if (fans.at(v).size() != 2) continue;
    const std::uint32_t u = fans.other_end(fans.at(v)[0], v), w = fans.other_end(fans.at(v)[1], v);
    const double width = spike_width(p, u, v, w);
    if (width > tolerance) continue;
    tallies[p.edges[fans.at(v)[0]].contour].add(v, width);
    fans.bypass(v);
    due.insert(due.end(), {u, w});
  }
  drop_dead(p);
  tell(work, plane, RepairKind::spikes, tallies, " where the contour turned back on itself");
  return !tallies.empty();
}

struct Gap {
  double length = 0;
  std::uint32_t a = 0, b = 0;
};

/// Vertices with an odd number of walls, in lexicographic order.
std::vector<std::uint32_t> open_ends(PlaneSection& p) {
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
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = i + 1; j < ends.size(); ++j)
      if (const double d = norm(p.vertices[ends[i]] - p.vertices[ends[j]]); d <= widest)
        gaps.push_back({d, ends[i], ends[j]});
  std::stable_sort(gaps.begin(), gaps.end(), [](const Gap& x, const Gap& y) { return x.length < y.length; });
  return gaps;
}

const ContourEdge& wall_at(const PlaneSection& p, std::uint32_t v) {
  return *std::find_if(p.edges.begin(), p.edges.end(),
                       [&](const ContourEdge& e) { return is_wall(e) && (e.a == v || e.b == v); });
}

void close_gap(Work& work, WorkPlane& plane, const Gap& gap) {
  PlaneSection& p = plane.section;
  ContourEdge edge = wall_at(p, gap.a);
  edge.a = gap.a, edge.b = gap.b;
  p.edges.push_back(edge);
  plane.edited = true;
  work.note({RepairKind::contour_closed, plane.source, edge.contour, gap.a, 1, gap.length, p.vertices[gap.a],
             "its ends were joined, vertices " + std::to_string(gap.a) + " and " + std::to_string(gap.b)});
}

/// Takes out the connected walls around each end.
void leave_out(Work& work, WorkPlane& plane, const std::vector<std::uint32_t>& ends) {
  PlaneSection& p = plane.section;
  DisjointSets parts(p.vertices.size());
  for (const ContourEdge& e : p.edges)
    if (is_wall(e)) parts.join(e.a, e.b);
  std::map<std::uint32_t, std::uint32_t> open;  // part -> number of edges taken out
  std::map<std::uint32_t, std::uint32_t> first_end, contour;
  for (const std::uint32_t v : ends) {
    open[parts.find(v)] = 0;
    first_end.try_emplace(parts.find(v), v);
    contour.try_emplace(parts.find(v), wall_at(p, v).contour);
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
  std::vector<std::uint32_t> ends = open_ends(plane.section);
  const double widest = std::min(work.options.close_gap, work.options.limit) * work.diagonal;
  for (const Gap& gap : gaps_between(plane.section, ends, widest)) {
    const auto a = std::find(ends.begin(), ends.end(), gap.a), b = std::find(ends.begin(), ends.end(), gap.b);
    if (a == ends.end() || b == ends.end()) continue;
    close_gap(work, plane, gap);
    ends.erase(b), ends.erase(std::find(ends.begin(), ends.end(), gap.a));
  }
  if (!ends.empty()) leave_out(work, plane, ends);
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
