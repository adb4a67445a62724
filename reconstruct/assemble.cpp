#include "assemble.h"

#include <algorithm>
#include <atomic>

#include "../geom/parallel.h"
#include "resize.h"
#include "sort_quadruples.h"

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

using Tet = std::array<std::uint32_t, 4>;

}  // namespace

void sort_tets(std::span<Tet> tets, std::size_t vertices, const Context& context) {
  for_blocks(tets.size(), context, "gluing", [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) tets[t] = canonical(tets[t]);
  });
  sort_quadruples(tets, vertices, context);
}

Solid assemble_solid(std::vector<Tet> tets, const Numbering& numbering, const WorldGrid& grid,
                     const Context& context) {
  std::vector<std::uint32_t> number(numbering.points.size(), kNone);
  for_blocks(tets.size(), context, "gluing", [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t)
      for (const std::uint32_t v : tets[t])
        if (const std::atomic_ref use(number[v]); use.load(std::memory_order_relaxed) == kNone)
          use.store(0, std::memory_order_relaxed);
  });
  Solid solid;
  number_kept(
      number.size(), context, "gluing", [&](std::size_t v) { return number[v] != kNone; },
      [&](std::size_t used) { resize(solid.points, used, context); },
      [&](std::size_t v, std::size_t n) {
        number[v] = static_cast<std::uint32_t>(n);
        solid.points[n] = grid.from_lattice(numbering.points[v]);
      });
  solid.tets = std::move(tets);
  for_blocks(solid.tets.size(), context, "gluing", [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      for (std::uint32_t& v : solid.tets[i]) v = number[v];
  });
  return solid;
}

Surface assemble_surface(GluedSurface& glued, const Numbering& numbering, const WorldGrid& grid,
                         const Context& context) {
  Surface surface;
  resize(surface.points, glued.vertices.size(), context);
  for_blocks(surface.points.size(), context, "gluing", [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const SurfaceVertex& v = glued.vertices[i];
      const Vec3 a = grid.from_lattice(numbering.points[v.a]);
      surface.points[i] = v.is_midpoint() ? 0.5 * (a + grid.from_lattice(numbering.points[v.b])) : a;
    }
  });
  if (glued.copies == 0)
    surface.triangles = std::move(glued.triangles);
  else
    surface.triangles = glued.triangles;
  return surface;
}

namespace {

/// A contour edge of the result by the numbers of its ends, the smaller first.
struct Piece {
  std::uint32_t a, b, contour;
};

/// What is left of the contours of one plane: pieces within faces, and walls on lines.
std::vector<Piece> pieces_of_plane(std::uint32_t p, const SectionGraph& graph,
                                   std::span<const FaceTriangulation> faces,
                                   std::span<const std::uint32_t> of_plane, const Numbering& numbering) {
  std::vector<Piece> pieces;
  const auto add = [&](std::uint32_t a, std::uint32_t b, const Wall& w) {
    pieces.push_back({std::min(a, b), std::max(a, b), w.contour});
  };
  pieces.reserve(graph.walls[p].size() + graph.walls[p].size() / 8);
  for (const std::uint32_t f : of_plane)
    for (const Wall& w : faces[f].walls) add(numbering.of_face[f][w.a], numbering.of_face[f][w.b], w);
  for (std::size_t i = 0; i < graph.walls[p].size(); ++i)
    if (const Wall& w = graph.walls[p][i]; graph.wall_locations[p][i].dimension == 1)
      add(numbering.of_graph[w.a], numbering.of_graph[w.b], w);
  std::sort(pieces.begin(), pieces.end(),
            [](const Piece& x, const Piece& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
  return pieces;
}

/// REQUIRES: pieces sorted.
void fill_section(PlaneSection& plane, const std::vector<Piece>& pieces, const Numbering& numbering,
                  const WorldGrid& grid) {
  std::vector<std::uint32_t> used;
  used.reserve(2 * pieces.size());
  for (const Piece& piece : pieces) used.insert(used.end(), {piece.a, piece.b});
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  plane.vertices.reserve(used.size());
  for (const std::uint32_t v : used) plane.vertices.push_back(grid.from_lattice(numbering.points[v]));
  const auto local = [&](std::uint32_t v) {
    return static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
  };
  plane.edges.reserve(pieces.size());
  for (const Piece& piece : pieces)
    plane.edges.push_back({local(piece.a), local(piece.b), 1, 0, piece.contour, 0});
}

}  // namespace

Sections assemble_sections(const FramedSections& framed, const SectionGraph& graph,
                           std::span<const FaceTriangulation> faces, const Numbering& numbering,
                           const Context& context) {
  std::vector<std::vector<std::uint32_t>> of_plane(graph.planes.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    if (!faces[f].walls.empty()) of_plane[faces[f].plane].push_back(f);
  Sections sections;
  sections.planes.resize(graph.planes.size());
  parallel_for(graph.planes.size(), context, "sections", [&](std::size_t k) {
    const auto p = static_cast<std::uint32_t>(k);
    PlaneSection& plane = sections.planes[p];
    plane = plane_in_input(graph.planes[p], framed.grid);
    fill_section(plane, pieces_of_plane(p, graph, faces, of_plane[p], numbering), numbering, framed.grid);
  });
  return sections;
}

/// Summed one by one, so that the sum does not depend on the threads; what is summed takes the time.
double enclosed_volume(const Surface& surface, const Context& context) {
  const std::vector<Vec3>& points = surface.points;
  const auto& triangles = surface.triangles;
  constexpr std::size_t kAtOnce = 32 * kBlock;
  std::vector<double> parts(std::min(triangles.size(), kAtOnce));
  double sum = 0;
  for (std::size_t begin = 0; begin < triangles.size() && !context.cancelled(); begin += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, triangles.size() - begin);
    for_blocks(count, context, "gluing", [&](std::size_t first, std::size_t last) {
      const Vec3 o = points[0];
      for (std::size_t i = first; i < last; ++i) {
        const auto& t = triangles[begin + i];
        parts[i] = dot(points[t[0]] - o, cross(points[t[1]] - o, points[t[2]] - o));
      }
    });
    for (std::size_t i = 0; i < count; ++i) sum += parts[i];
  }
  return sum / 6;
}

}  // namespace crossloft
