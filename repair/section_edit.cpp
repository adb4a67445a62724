#include "section_edit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "../geom/disjoint_sets.h"
#include "segment_distance.h"

namespace crossloft {
namespace {

/// Input coordinates of grid points: fixed corners first, then vertices, of several the smallest.
class Places {
 public:
  Places(const PlaneChart& chart, PlaneSection& section) : chart_(chart), section_(section) {}

  void add_fixed(PlanarPoint at, Vec3 p) { keep_smallest(fixed_, at, p); }
  void add_vertex(PlanarPoint at, Vec3 p) { keep_smallest(vertices_, at, p); }

  Vec3 position(PlanarPoint at) const {
    if (const auto f = fixed_.find(at); f != fixed_.end()) return f->second;
    if (const auto v = vertices_.find(at); v != vertices_.end()) return v->second;
    return chart_.to_space(at);
  }

  /// `wish` if that vertex is where it should be and none is there yet, else the vertex for this point.
  std::uint32_t vertex(PlanarPoint at, std::uint32_t wish) {
    const Vec3 p = position(at);
    if (wish != kNone && section_.vertices[wish] == p) return made_.try_emplace(at, wish).first->second;
    const auto [entry, fresh] = made_.try_emplace(at, static_cast<std::uint32_t>(section_.vertices.size()));
    if (fresh) section_.vertices.push_back(p);
    return entry->second;
  }
  /// A vertex of the section that stays may be named by other edges.
  void offer(PlanarPoint at, std::uint32_t vertex) {
    if (section_.vertices[vertex] == position(at)) made_.try_emplace(at, vertex);
  }

 private:
  using Map = std::map<PlanarPoint, Vec3>;
  static void keep_smallest(Map& map, PlanarPoint at, Vec3 p) {
    const auto [entry, fresh] = map.try_emplace(at, p);
    if (!fresh && p < entry->second) entry->second = p;
  }

  const PlaneChart& chart_;
  PlaneSection& section_;
  Map fixed_, vertices_;
  std::map<PlanarPoint, std::uint32_t> made_;
};

/// What goes into the overlay, and the edges it came from (null for patches).
struct Layers {
  std::vector<OverlaySegment> segments;
  std::vector<const ContourEdge*> origin;
  std::vector<LayerKind> kinds;
};

void add_section(Layers& layers, const PlaneSection& section, const PlaneChart& chart, Places& places) {
  const auto layer = static_cast<std::uint32_t>(layers.kinds.size());
  layers.kinds.push_back(LayerKind::section);
  for (const ContourEdge& e : section.edges) {
    if (!is_wall(e)) continue;
    const Vec3 p = section.vertices[e.a], q = section.vertices[e.b];
    layers.segments.push_back({chart.to_grid(p), chart.to_grid(q), layer});
    layers.origin.push_back(&e);
    places.add_vertex(layers.segments.back().a, p);
    places.add_vertex(layers.segments.back().b, q);
  }
}

void add_patch(Layers& layers, const Patch& patch, const PlaneChart& chart, Places& places) {
  const auto layer = static_cast<std::uint32_t>(layers.kinds.size());
  layers.kinds.push_back(patch.kind);
  for (std::size_t c = 0; c < patch.corners.size(); ++c) {
    const PlanarPoint at = chart.to_grid(patch.corners[c]);
    const PlanarPoint next = chart.to_grid(patch.corners[(c + 1) % patch.corners.size()]);
    if (patch.fixed[c]) places.add_fixed(at, patch.corners[c]);
    layers.segments.push_back({at, next, layer});
    layers.origin.push_back(nullptr);
  }
}

/// The material that a new edge bounds: that of the nearest wall.
std::int32_t material_at(const PlaneSection& section, Vec3 p) {
  std::int32_t material = 1;
  double least = HUGE_VAL;
  for (const ContourEdge& e : section.edges) {
    if (!is_wall(e)) continue;
    const double d = distance_to_segment(section.vertices[e.a], section.vertices[e.b], p);
    const std::int32_t m = e.material_a + e.material_b;
    if (d < least || (d == least && m < material)) least = d, material = m;
  }
  return material;
}

std::set<std::int32_t> materials_of(const PlaneSection& section) {
  std::set<std::int32_t> materials;
  for (const ContourEdge& e : section.edges)
    if (is_wall(e)) materials.insert(e.material_a + e.material_b);
  return materials;
}

/// Borders between materials that still end at other edges on both ends. Returns how many were left out.
std::uint32_t keep_borders(const std::vector<ContourEdge>& before, std::vector<ContourEdge>& edges) {
  std::vector<ContourEdge> borders;
  std::map<std::uint32_t, std::uint32_t> degree;
  for (const ContourEdge& e : edges) ++degree[e.a], ++degree[e.b];
  for (const ContourEdge& e : before)
    if (!is_wall(e) && e.material_a != e.material_b) borders.push_back(e), ++degree[e.a], ++degree[e.b];
  const std::size_t all = borders.size();
  const auto loose = [&](const ContourEdge& e) {
    if (degree[e.a] > 1 && degree[e.b] > 1) return false;
    --degree[e.a], --degree[e.b];
    return true;
  };
  while (std::erase_if(borders, loose) != 0) {
  }
  edges.insert(edges.end(), borders.begin(), borders.end());
  return static_cast<std::uint32_t>(all - borders.size());
}

/// Of the first section's edges, those that stay whole and with their ends where they were.
std::vector<bool> untouched_edges(const Layers& layers, const std::vector<OverlayEdge>& edges,
                                  const PlaneSection& section, const Places& places) {
  std::vector<bool> whole(layers.segments.size(), false);
  for (const OverlayEdge& e : edges) {
    const ContourEdge* origin = layers.origin[e.segment];
    if (layers.segments[e.segment].layer != 0 || origin == nullptr) continue;
    whole[e.segment] = e.a == layers.segments[e.segment].a && e.b == layers.segments[e.segment].b &&
                       places.position(e.a) == section.vertices[origin->a] &&
                       places.position(e.b) == section.vertices[origin->b];
  }
  return whole;
}

void note_changes(const Layers& layers, const std::vector<OverlayEdge>& edges, const std::vector<bool>& whole,
                  const PlaneSection& section, const PlaneChart& chart, SectionEdit& edit) {
  std::set<std::uint32_t> contours;
  for (std::size_t s = 0; s < whole.size() && layers.segments[s].layer == 0; ++s) {
    if (whole[s]) continue;
    if (contours.empty()) edit.point = section.vertices[layers.origin[s]->a];
    contours.insert(layers.origin[s]->contour);
  }
  edit.contours.assign(contours.begin(), contours.end());
  edit.changed = !contours.empty();
  for (const OverlayEdge& e : edges) {
    if (layers.segments[e.segment].layer == 0) continue;
    if (!edit.changed) edit.point = chart.to_space(e.a);
    edit.changed = true;
  }
}

std::vector<ContourEdge> rebuilt_edges(const Layers& layers, const std::vector<OverlayEdge>& edges,
                                       const std::vector<bool>& whole, const PlaneSection& section,
                                       Places& places) {
  const std::set<std::int32_t> materials = materials_of(section);
  const bool alike = materials.size() <= 1;
  const std::int32_t first = materials.empty() ? 1 : *materials.begin();
  for (const OverlayEdge& e : edges)
    if (whole[e.segment]) {
      places.offer(e.a, layers.origin[e.segment]->a);
      places.offer(e.b, layers.origin[e.segment]->b);
    }
  std::vector<ContourEdge> rebuilt;
  for (const OverlayEdge& e : edges) {
    const ContourEdge* origin = layers.origin[e.segment];
    ContourEdge edge = origin ? *origin : ContourEdge{0, 0, 1, 0, kNone, 0};
    if (!origin) edge.material_a = alike ? first : material_at(section, places.position(e.a));
    if (!whole[e.segment]) {
      const bool own = origin && layers.segments[e.segment].layer == 0;
      const OverlaySegment& s = layers.segments[e.segment];
      edge.a = places.vertex(e.a, own && e.a == s.a ? origin->a : kNone);
      edge.b = places.vertex(e.b, own && e.b == s.b ? origin->b : kNone);
    }
    if (edge.a != edge.b) rebuilt.push_back(edge);
  }
  return rebuilt;
}

}  // namespace

std::vector<std::vector<std::uint32_t>> edges_by_vertex(const PlaneSection& section) {
  std::vector<std::vector<std::uint32_t>> edges(section.vertices.size());
  for (std::uint32_t e = 0; e < section.edges.size(); ++e) {
    edges[section.edges[e].a].push_back(e);
    edges[section.edges[e].b].push_back(e);
  }
  return edges;
}

void join_equal_vertices(PlaneSection& section) {
  std::map<Vec3, std::uint32_t> first;
  std::vector<std::uint32_t> same;
  for (std::uint32_t v = 0; v < section.vertices.size(); ++v)
    same.push_back(first.try_emplace(section.vertices[v], v).first->second);
  for (ContourEdge& e : section.edges) e.a = same[e.a], e.b = same[e.b];
}

SectionEdit edit_section(PlaneSection& section, const PlaneChart& chart, std::span<const Patch> patches,
                         std::span<const PlaneSection* const> others, const Context& context) {
  Places places(chart, section);
  Layers layers;
  add_section(layers, section, chart, places);
  for (const PlaneSection* other : others) add_section(layers, *other, chart, places);
  for (const Patch& patch : patches) add_patch(layers, patch, chart, places);
  const std::vector<OverlayEdge> edges = overlay(layers.segments, layers.kinds, context);
  if (context.cancelled()) return {};
  const std::vector<bool> whole = untouched_edges(layers, edges, section, places);
  SectionEdit edit;
  note_changes(layers, edges, whole, section, chart, edit);
  if (!edit.changed) return edit;
  std::vector<ContourEdge> rebuilt = rebuilt_edges(layers, edges, whole, section, places);
  edit.borders = keep_borders(section.edges, rebuilt);
  section.edges = std::move(rebuilt);
  return edit;
}

void tidy_section(PlaneSection& section) {
  std::vector<std::uint32_t> index(section.vertices.size(), kNone);
  for (const ContourEdge& e : section.edges) index[e.a] = index[e.b] = 0;
  std::vector<Vec3> kept;
  for (std::size_t v = 0; v < index.size(); ++v) {
    if (index[v] == kNone) continue;
    index[v] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(section.vertices[v]);
  }
  section.vertices = std::move(kept);
  DisjointSets parts(section.vertices.size());
  for (ContourEdge& e : section.edges) {
    e.a = index[e.a], e.b = index[e.b];
    parts.join(e.a, e.b);
  }
  std::map<std::uint32_t, std::uint32_t> number;
  for (ContourEdge& e : section.edges)
    e.contour = number.try_emplace(parts.find(e.a), static_cast<std::uint32_t>(number.size())).first->second;
}

}  // namespace crossloft
