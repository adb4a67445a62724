#include "flats.h"

#include <algorithm>

#include "../geom/disjoint_sets.h"

namespace crossloft {
namespace {

/// A flat triangle's edge by final vertex numbers.
struct FlatEdge {
  std::uint32_t a, b, plane, triangle;
  bool same_edge(const FlatEdge& o) const { return a == o.a && b == o.b && plane == o.plane; }
};

/// One region less of a plane for each two that an edge connects.
void connect(std::vector<FlatEdge> edges, std::uint32_t triangles, std::vector<std::uint32_t>& regions) {
  std::sort(edges.begin(), edges.end(), [](const FlatEdge& x, const FlatEdge& y) {
    return std::tie(x.plane, x.a, x.b, x.triangle) < std::tie(y.plane, y.a, y.b, y.triangle);
  });
  DisjointSets sets(triangles);
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (!edges[i].same_edge(edges[i - 1])) continue;
    if (sets.find(edges[i].triangle) == sets.find(edges[i - 1].triangle)) continue;
    sets.join(edges[i].triangle, edges[i - 1].triangle);
    --regions[edges[i].plane];
  }
}

std::array<std::uint32_t, 3> numbers_of(const FaceTriangulation& face,
                                        const std::vector<std::uint32_t>& number, std::size_t t) {
  const auto& v = face.triangles[t];
  return {number[v[0]], number[v[1]], number[v[2]]};
}

}  // namespace

std::vector<std::uint32_t> count_regions(std::span<const FaceTriangulation> faces, const Numbering& numbering,
                                         std::size_t plane_count, const TriangleFilter& counts) {
  std::vector<std::uint32_t> regions(plane_count, 0);
  std::vector<FlatEdge> edges;
  std::uint32_t triangles = 0;
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (std::size_t t = 0; t < faces[f].triangles.size(); ++t) {
      if (faces[f].internal[t] == 0 || !counts(f, t)) continue;
      const auto v = numbers_of(faces[f], numbering.of_face[f], t);
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [a, b] = std::minmax(v[i], v[(i + 1) % 3]);
        edges.push_back({a, b, faces[f].plane, triangles});
      }
      ++triangles;
      ++regions[faces[f].plane];
    }
  connect(std::move(edges), triangles, regions);
  return regions;
}

std::vector<PlaneAreas> measure_flats(std::span<const FaceTriangulation> faces, const Numbering& numbering,
                                      const WorldGrid& grid, std::size_t plane_count) {
  std::vector<PlaneAreas> planes(plane_count);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const FaceTriangulation& face = faces[f];
    for (std::size_t t = 0; t < face.triangles.size(); ++t) {
      if (face.internal[t] == 0) continue;
      const auto v = numbers_of(face, numbering.of_face[f], t);
      const Vec3 p = grid.from_lattice(numbering.points[v[0]]);
      const double area = norm(cross(grid.from_lattice(numbering.points[v[1]]) - p,
                                     grid.from_lattice(numbering.points[v[2]]) - p)) /
                          2;
      planes[face.plane].section += area;
      if (face.is_flat(t)) planes[face.plane].flat += area;
    }
  }
  return planes;
}

}  // namespace crossloft
