#include "assemble.h"

#include <algorithm>

#include "lists.h"

namespace crossloft {
namespace {

/// An even permutation with the smallest vertex first and the second smallest of the rest next. Without
/// branches: which ones they are can't be predicted.
std::array<std::uint32_t, 4> canonical(const std::array<std::uint32_t, 4>& t) {
  constexpr std::uint8_t kEven[4][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};
  constexpr std::uint8_t kTurned[3][3] = {{1, 2, 3}, {2, 3, 1}, {3, 1, 2}};
  const std::uint32_t low = std::min(std::min(t[0], t[1]), std::min(t[2], t[3]));
  const auto& even = kEven[(t[1] == low ? 1 : 0) + (t[2] == low ? 2 : 0) + (t[3] == low ? 3 : 0)];
  const std::array<std::uint32_t, 4> r{low, t[even[1]], t[even[2]], t[even[3]]};
  const std::uint32_t next = std::min(std::min(r[1], r[2]), r[3]);
  const auto& turned = kTurned[(r[2] == next ? 1 : 0) + (r[3] == next ? 2 : 0)];
  return {low, next, r[turned[1]], r[turned[2]]};
}

Vec3 unit_normal(const LatticeVector& n) {
  const Vec3 v{static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2])};
  return (1 / norm(v)) * v;
}

}  // namespace

Solid assemble_solid(std::vector<std::array<std::uint32_t, 4>>& tets, const Numbering& numbering,
                     const WorldGrid& grid) {
  for (auto& t : tets) t = canonical(t);
  sort_by_vertex(tets, [](const auto& t) { return t[0]; });
  std::vector<std::uint32_t> number(numbering.points.size(), kNone);
  for (const auto& t : tets)
    for (const std::uint32_t v : t) number[v] = 0;
  Solid solid;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == kNone) continue;
    number[v] = static_cast<std::uint32_t>(solid.points.size());
    solid.points.push_back(grid.from_lattice(numbering.points[v]));
  }
  solid.tets.reserve(tets.size());
  for (const auto& t : tets) solid.tets.push_back({number[t[0]], number[t[1]], number[t[2]], number[t[3]]});
  return solid;
}

Surface assemble_surface(const GluedSurface& glued, const Numbering& numbering, const WorldGrid& grid) {
  Surface surface;
  surface.points.reserve(glued.vertices.size());
  for (const SurfaceVertex& v : glued.vertices) {
    const Vec3 a = grid.from_lattice(numbering.points[v.a]);
    surface.points.push_back(v.is_midpoint() ? 0.5 * (a + grid.from_lattice(numbering.points[v.b])) : a);
  }
  surface.triangles = glued.triangles;
  return surface;
}

Sections assemble_sections(const FramedSections& framed, const SectionGraph& graph,
                           std::span<const FaceTriangulation> faces, const Numbering& numbering) {
  struct Piece {
    std::uint32_t a, b;
    const Wall* wall;
  };
  std::vector<std::vector<Piece>> pieces(graph.planes.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (const Wall& w : faces[f].walls)
      pieces[faces[f].plane].push_back({numbering.of_face[f][w.a], numbering.of_face[f][w.b], &w});
  for (std::size_t p = 0; p < graph.planes.size(); ++p)
    for (std::size_t i = 0; i < graph.walls[p].size(); ++i)
      if (const Wall& w = graph.walls[p][i]; graph.wall_locations[p][i].dimension == 1)
        pieces[p].push_back({numbering.of_graph[w.a], numbering.of_graph[w.b], &w});
  Sections sections;
  for (std::size_t p = 0; p < graph.planes.size(); ++p) {
    PlaneSection plane;
    plane.normal = unit_normal(graph.planes[p].normal);
    plane.offset = -dot(plane.normal, framed.grid.from_lattice(make_point(graph.planes[p].origin)));
    std::vector<std::uint32_t> used;
    for (Piece& piece : pieces[p]) {
      if (piece.a > piece.b) std::swap(piece.a, piece.b);
      used.insert(used.end(), {piece.a, piece.b});
    }
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    for (const std::uint32_t v : used)
      plane.vertices.push_back(framed.grid.from_lattice(numbering.points[v]));
    std::sort(pieces[p].begin(), pieces[p].end(),
              [](const Piece& x, const Piece& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
    const auto local = [&](std::uint32_t v) {
      return static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
    };
    for (const Piece& piece : pieces[p])
      plane.edges.push_back({local(piece.a), local(piece.b), 1, 0, piece.wall->contour, 0});
    sections.planes.push_back(std::move(plane));
  }
  return sections;
}

double enclosed_volume(const Surface& surface) {
  double sum = 0;
  for (const auto& t : surface.triangles) {
    const Vec3 o = surface.points[0];
    sum += dot(surface.points[t[0]] - o, cross(surface.points[t[1]] - o, surface.points[t[2]] - o));
  }
  return sum / 6;
}

}  // namespace crossloft
