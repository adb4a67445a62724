/// Third, fourth and last step: contours that do not cross, of a size that means something, without bends by
/// a hair.

#include <algorithm>
#include <cmath>
#include <map>

#include "../geom/bounds.h"
#include "../geom/disjoint_sets.h"
#include "repair_steps.h"
#include "section_edit.h"

namespace crossloft::repair_steps {
namespace {

/// Nearer to the line of its neighbours a vertex is on it, up to rounding.
constexpr double kOnLine = 1e-14;

/// What remains of the connected walls of a section: their box.
struct Loop {
  Bounds box;
  std::uint32_t contour = kNone, vertex = kNone, edges = 0;
};

/// The loops of a section by the part of `parts` that each is.
std::map<std::uint32_t, Loop> loops_of(const PlaneSection& p, DisjointSets& parts) {
  for (const ContourEdge& e : p.edges) parts.join(e.a, e.b);
  std::map<std::uint32_t, Loop> loops;
  for (const ContourEdge& e : p.edges) {
    Loop& l = loops[parts.find(e.a)];
    l.box.add(p.vertices[e.a]), l.box.add(p.vertices[e.b]);
    l.contour = std::min(l.contour, e.contour);
    l.vertex = std::min({l.vertex, e.a, e.b});
    ++l.edges;
  }
  return loops;
}

bool is_tiny(const Work& work, const Loop& loop) {
  return loop.box.diagonal() <= work.capped(work.options.tiny_loop * work.diagonal);
}

/// True iff the section has a loop that means something.
bool has_large_loop(const Work& work, const WorkPlane& plane) {
  DisjointSets parts(plane.section.vertices.size());
  const auto loops = loops_of(plane.section, parts);
  return std::any_of(loops.begin(), loops.end(),
                     [&](const auto& entry) { return !is_tiny(work, entry.second); });
}

/// What is done to a loop that is tiny, or is not done.
void tell_tiny(Work& work, const WorkPlane& plane, const Loop& l, RepairKind kind, const char* what) {
  work.note({kind, plane.source, l.contour, l.vertex, l.edges, l.box.diagonal(),
             plane.section.vertices[l.vertex], "a loop of " + count_of(l.edges, "edge", "edges") + what});
}

void drop_tiny_loops(Work& work, WorkPlane& plane) {
  PlaneSection& p = plane.section;
  DisjointSets parts(p.vertices.size());
  auto loops = loops_of(p, parts);
  std::erase_if(loops, [&](const auto& entry) { return !is_tiny(work, entry.second); });
  for (const auto& [part, l] : loops) tell_tiny(work, plane, l, RepairKind::tiny_loop, " was left out");
  std::erase_if(p.edges, [&](const ContourEdge& e) { return loops.contains(parts.find(e.a)); });
  plane.edited |= !loops.empty();
}

void tell_all_tiny(Work& work, const WorkPlane& plane) {
  DisjointSets parts(plane.section.vertices.size());
  for (const auto& [part, l] : loops_of(plane.section, parts))
    tell_tiny(work, plane, l, RepairKind::left_as_it_is, " is tiny beside the distances, as are all others");
}

/// How far b is off the segment ac; infinite if it is not between its ends.
double bend(Vec3 a, Vec3 b, Vec3 c) {
  if (c < a) std::swap(a, c);
  const Vec3 d = c - a, e = b - a;
  const double along = dot(e, d), length2 = dot(d, d);
  return along > 0 && along < length2 ? norm(cross(e, d)) / std::sqrt(length2) : HUGE_VAL;
}

/// True iff one of these edges of v leads to w.
bool leads_to(const PlaneSection& p, const std::vector<std::uint32_t>& edges, std::uint32_t v,
              std::uint32_t w) {
  return std::any_of(edges.begin(), edges.end(), [&](std::uint32_t e) {
    return (p.edges[e].a == v && p.edges[e].b == w) || (p.edges[e].a == w && p.edges[e].b == v);
  });
}

/// Vertices that bend a straight run by a hair, taken out in lexicographic order, never two neighbours in one
/// pass: the run moves by less than the tolerance. Not of a triangle, which would be gone.
bool straighten_once(Work& work, WorkPlane& plane, std::map<std::uint32_t, RepairChange>& changes) {
  PlaneSection& p = plane.section;
  const auto walls = edges_by_vertex(p);
  std::vector<std::uint32_t> order;
  for (std::uint32_t v = 0; v < p.vertices.size(); ++v)
    if (walls[v].size() == 2 && is_wall(p.edges[walls[v][0]]) && is_wall(p.edges[walls[v][1]]))
      order.push_back(v);
  std::sort(order.begin(), order.end(), [&](auto v, auto w) { return p.vertices[v] < p.vertices[w]; });
  std::vector<bool> settled(p.vertices.size(), false);
  const double most = work.capped(work.options.collinear * work.diagonal);
  bool any = false;
  for (const std::uint32_t v : order) {
    ContourEdge &e = p.edges[walls[v][0]], &f = p.edges[walls[v][1]];
    const std::uint32_t u = e.a == v ? e.b : e.a, w = f.a == v ? f.b : f.a;
    if (settled[v] || settled[u] || settled[w] || u == w || leads_to(p, walls[u], u, w)) continue;
    const double off = bend(p.vertices[u], p.vertices[v], p.vertices[w]);
    if (off <= kOnLine * work.diagonal || off > most) continue;
    if (on_another_plane(work, plane, p.vertices[v])) continue;
    settled[u] = settled[v] = settled[w] = any = true;
    RepairChange& change = changes[e.contour];
    change.count = change.vertex == kNone ? 1 : change.count + 1;
    change.vertex = std::min(change.vertex, v);
    change.distance = std::max(change.distance, off);
    e.a = u, e.b = w;
    f.a = f.b = v;
  }
  std::erase_if(p.edges, [](const ContourEdge& e) { return e.a == e.b; });
  return any;
}

void straighten(Work& work, WorkPlane& plane) {
  std::map<std::uint32_t, RepairChange> changes;
  while (!work.context.cancelled() && straighten_once(work, plane, changes)) plane.edited = true;
  for (auto& [contour, change] : changes) {
    change.kind = RepairKind::nearly_straight;
    change.plane = plane.source;
    change.contour = contour;
    change.point = plane.section.vertices[change.vertex];
    change.text = count_of(change.count, "vertex", "vertices") + " that bent a straight run by a hair";
    work.note(change);
  }
}

/// `contours` in ascending order.
void drop_flat(Work& work, WorkPlane& plane, const std::vector<std::uint32_t>& contours) {
  struct Flat {
    std::uint32_t vertex = kNone, edges = 0;
  };
  PlaneSection& p = plane.section;
  std::map<std::uint32_t, Flat> flat;
  std::erase_if(p.edges, [&](const ContourEdge& e) {
    if (!std::binary_search(contours.begin(), contours.end(), e.contour)) return false;
    Flat& f = flat[e.contour];
    f.vertex = std::min({f.vertex, e.a, e.b});
    ++f.edges;
    return true;
  });
  for (const auto& [contour, f] : flat)
    work.note({RepairKind::no_area, plane.source, contour, f.vertex, f.edges, 0, p.vertices[f.vertex],
               "left out, it encloses no area"});
  plane.edited |= !flat.empty();
}

}  // namespace

void drop_flat_contours(Work& work, const std::vector<std::vector<std::uint32_t>>& flat) {
  for (std::size_t p = 0; p < flat.size(); ++p) drop_flat(work, work.planes[p], flat[p]);
}

void repair_crossings(Work& work) {
  for (WorkPlane& plane : work.planes) {
    const PlaneChart chart = work.chart(plane);
    const SectionEdit edit = edit_section(plane.section, chart, {}, {}, work.context);
    if (!edit.changed) continue;
    plane.edited = true;
    for (const std::uint32_t contour : edit.contours)
      work.note({RepairKind::crossings, plane.source, contour, kNone, 1, chart.step(), edit.point,
                 "the contour crosses or touches itself or another: read by even-odd"});
    if (edit.borders != 0)
      work.note({RepairKind::borders_left_out, plane.source, kNone, kNone, edit.borders, 0, edit.point,
                 count_of(edit.borders, "edge", "edges") + " between two materials left out"});
  }
}

void repair_loops(Work& work) {
  // Far from each other all may be tiny. Then it is not their size that is wrong.
  const bool some = std::any_of(work.planes.begin(), work.planes.end(),
                                [&](const WorkPlane& plane) { return has_large_loop(work, plane); });
  for (WorkPlane& plane : work.planes) {
    if (work.context.cancelled()) return;
    some ? drop_tiny_loops(work, plane) : tell_all_tiny(work, plane);
  }
}

void straighten_runs(Work& work) {
  for (WorkPlane& plane : work.planes) straighten(work, plane);
}

}  // namespace crossloft::repair_steps
