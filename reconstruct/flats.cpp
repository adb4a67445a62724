#include "flats.h"

#include <algorithm>

#include "../geom/disjoint_sets.h"
#include "../geom/parallel.h"

namespace crossloft {
namespace {

/// Faces with triangles by plane, ascending.
std::vector<std::vector<std::uint32_t>> faces_of_planes(std::span<const FaceTriangulation> faces,
                                                        std::size_t plane_count) {
  std::vector<std::vector<std::uint32_t>> of_plane(plane_count);
  for (std::uint32_t f = 0; f < faces.size(); ++f)
    if (!faces[f].triangles.empty()) of_plane[faces[f].plane].push_back(f);
  return of_plane;
}

/// A flat triangle's edge by final vertex numbers.
struct FlatEdge {
  std::uint32_t a, b, triangle;
  bool same_edge(const FlatEdge& o) const { return a == o.a && b == o.b; }
};

/// One region less for each two that an edge connects.
std::uint32_t connect(std::vector<FlatEdge> edges, std::uint32_t triangles) {
  std::sort(edges.begin(), edges.end(), [](const FlatEdge& x, const FlatEdge& y) {
    return std::tie(x.a, x.b, x.triangle) < std::tie(y.a, y.b, y.triangle);
  });
  DisjointSets sets(triangles);
  std::uint32_t regions = triangles;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (!edges[i].same_edge(edges[i - 1])) continue;
    if (sets.find(edges[i].triangle) == sets.find(edges[i - 1].triangle)) continue;
    sets.join(edges[i].triangle, edges[i - 1].triangle);
    --regions;
  }
  return regions;
}

std::array<std::uint32_t, 3> numbers_of(const FaceTriangulation& face,
                                        const std::vector<std::uint32_t>& number, std::size_t t) {
  const auto& v = face.triangles[t];
  return {number[v[0]], number[v[1]], number[v[2]]};
}

std::uint32_t count_regions_of_plane(std::span<const FaceTriangulation> faces, const Numbering& numbering,
                                     std::span<const std::uint32_t> of_plane, const TriangleFilter& counts) {
  std::vector<FlatEdge> edges;
  std::uint32_t triangles = 0;
  for (const std::uint32_t f : of_plane)
    for (std::size_t t = 0; t < faces[f].triangles.size(); ++t) {
      if (faces[f].internal[t] == 0 || !counts(f, t)) continue;
      const auto v = numbers_of(faces[f], numbering.of_face[f], t);
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [a, b] = std::minmax(v[i], v[(i + 1) % 3]);
        edges.push_back({a, b, triangles});
      }
      ++triangles;
    }
  return connect(std::move(edges), triangles);
}

PlaneAreas measure_plane(std::span<const FaceTriangulation> faces, const Numbering& numbering,
                         const WorldGrid& grid, std::span<const std::uint32_t> of_plane) {
  PlaneAreas areas;
  for (const std::uint32_t f : of_plane) {
    const FaceTriangulation& face = faces[f];
    for (std::size_t t = 0; t < face.triangles.size(); ++t) {
      if (face.internal[t] == 0) continue;
      const auto v = numbers_of(face, numbering.of_face[f], t);
      const Vec3 p = grid.from_lattice(numbering.points[v[0]]);
      const double area = norm(cross(grid.from_lattice(numbering.points[v[1]]) - p,
                                     grid.from_lattice(numbering.points[v[2]]) - p)) /
                          2;
      areas.section += area;
      if (face.is_flat(t)) areas.flat += area;
    }
  }
  return areas;
}

}  // namespace

std::vector<std::uint32_t> count_regions(std::span<const FaceTriangulation> faces, const Numbering& numbering,
                                         std::size_t plane_count, const TriangleFilter& counts,
                                         const Context& context) {
  const auto of_plane = faces_of_planes(faces, plane_count);
  std::vector<std::uint32_t> regions(plane_count, 0);
  parallel_for(plane_count, context, "flats", [&](std::size_t p) {
    regions[p] = count_regions_of_plane(faces, numbering, of_plane[p], counts);
  });
  return regions;
}

std::vector<PlaneAreas> measure_flats(std::span<const FaceTriangulation> faces, const Numbering& numbering,
                                      const WorldGrid& grid, std::size_t plane_count,
                                      const Context& context) {
  const auto of_plane = faces_of_planes(faces, plane_count);
  std::vector<PlaneAreas> planes(plane_count);
  parallel_for(plane_count, context, "flats",
               [&](std::size_t p) { planes[p] = measure_plane(faces, numbering, grid, of_plane[p]); });
  return planes;
}

}  // namespace crossloft
