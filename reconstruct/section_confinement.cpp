#include "section_confinement.h"

#include <algorithm>

namespace crossloft {
namespace {

/// By number: whether there are copies of the vertex, or a midpoint of an edge at it. Copies stand together.
std::vector<std::uint8_t> points_of_copies(const GluedSurface& surface, std::size_t points) {
  std::vector<std::uint8_t> is_one(points, 0);
  for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
    const SurfaceVertex& v = surface.vertices[i];
    if (v.is_midpoint()) is_one[v.a] = is_one[v.b] = 1;
    if (i > 0 && surface.vertices[i - 1] == v) is_one[v.a] = 1;
  }
  return is_one;
}

}  // namespace

SectionConfinement::SectionConfinement(const SectionGraph& graph, std::span<const FaceTriangulation> faces,
                                       const Numbering& numbering, const WorldGrid& grid,
                                       const GluedSurface& surface)
    : graph_(graph), numbering_(numbering), grid_(grid), surface_(surface) {
  const std::vector<std::uint8_t> is_copied = points_of_copies(surface, numbering.points.size());
  const auto add = [&](std::uint32_t a, std::uint32_t b) {
    if ((is_copied[a] | is_copied[b]) != 0) contour_edges_.push_back({std::min(a, b), std::max(a, b)});
  };
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (const Wall& w : faces[f].walls) add(numbering.of_face[f][w.a], numbering.of_face[f][w.b]);
  // Walls on lines are never split. Those within faces are here twice, or whole and in pieces: holding a copy
  // back for a whole one is needless at worst.
  for (const auto& walls : graph.walls)
    for (const Wall& w : walls) add(numbering.of_graph[w.a], numbering.of_graph[w.b]);
  std::sort(contour_edges_.begin(), contour_edges_.end());
}

int SectionConfinement::side(std::uint32_t plane, std::uint32_t number) const {
  const std::uint32_t v = numbering_.graph_vertex[number];
  return v != kNone ? graph_.sign(v, plane) : side_of_plane(graph_.planes[plane], numbering_.points[number]);
}

/// A midpoint lies between vertices of one closed cell, or in a plane with both.
int SectionConfinement::side_of_surface_vertex(std::uint32_t plane, std::uint32_t vertex) const {
  const SurfaceVertex& v = surface_.vertices[vertex];
  const int a = side(plane, v.a);
  return a != 0 || !v.is_midpoint() ? a : side(plane, v.b);
}

/// -1 or +1: all of the umbrella is on this closed side and no triangle in the plane; else 0.
int SectionConfinement::side_of_umbrella(std::uint32_t plane, const Umbrella& umbrella) const {
  int low = 0, high = 0;
  for (const std::uint32_t t : umbrella.triangles) {
    int found = 0;
    for (const std::uint32_t v : surface_.triangles[t]) {
      const int s = side_of_surface_vertex(plane, v);
      low = std::min(low, s), high = std::max(high, s);
      found |= s;
    }
    if (found == 0) return 0;
  }
  return low + high;
}

/// Also where an end is a midpoint, of a contour edge.
bool SectionConfinement::is_contour_edge(const SurfaceVertex& a, const SurfaceVertex& b) const {
  std::array<std::uint32_t, 4> ends{a.a, a.is_midpoint() ? a.b : a.a, b.a, b.is_midpoint() ? b.b : b.a};
  std::sort(ends.begin(), ends.end());
  if (std::unique(ends.begin(), ends.end()) - ends.begin() != 2) return false;
  return std::binary_search(contour_edges_.begin(), contour_edges_.end(),
                            std::array{std::min(ends[0], ends[1]), std::max(ends[0], ends[1])});
}

bool SectionConfinement::may_move(const Umbrella& umbrella) const {
  const SurfaceVertex& copy = surface_.vertices[umbrella.vertex];
  for (const std::uint32_t t : umbrella.triangles)
    for (const std::uint32_t v : surface_.triangles[t])
      if (v != umbrella.vertex && is_contour_edge(copy, surface_.vertices[v])) return false;
  for (std::uint32_t p = 0; p < graph_.planes.size(); ++p)
    if (side_of_umbrella(p, umbrella) == 0) return false;
  return true;
}

bool SectionConfinement::admit(const Umbrella& umbrella, Vec3& place) const {
  const LatticeVector lattice = grid_.to_lattice(place);
  const LatticePoint point = make_point(lattice);
  for (std::uint32_t p = 0; p < graph_.planes.size(); ++p)
    if (side_of_plane(graph_.planes[p], point) != side_of_umbrella(p, umbrella)) return false;
  place = grid_.from_lattice(point);
  return true;
}

}  // namespace crossloft
