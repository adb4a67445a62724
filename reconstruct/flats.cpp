#include "flats.h"

#include <algorithm>
#include <numeric>

namespace crossloft {
namespace {

/// A flat triangle's edge by final vertex numbers.
struct FlatEdge {
  std::uint32_t a, b, plane, triangle;
  bool same_edge(const FlatEdge& o) const { return a == o.a && b == o.b && plane == o.plane; }
};

std::uint32_t count_regions(std::vector<FlatEdge> edges, std::uint32_t triangles) {
  std::sort(edges.begin(), edges.end(), [](const FlatEdge& x, const FlatEdge& y) {
    return std::tie(x.plane, x.a, x.b, x.triangle) < std::tie(y.plane, y.a, y.b, y.triangle);
  });
  std::vector<std::uint32_t> parent(triangles);
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t t) {
    while (parent[t] != t) t = parent[t] = parent[parent[t]];
    return t;
  };
  std::uint32_t regions = triangles;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (!edges[i].same_edge(edges[i - 1])) continue;
    const std::uint32_t s = root(edges[i].triangle), t = root(edges[i - 1].triangle);
    if (s != t) --regions;
    parent[s] = t;
  }
  return regions;
}

}  // namespace

Flats measure_flats(std::span<const FaceTriangulation> faces, const Numbering& numbering,
                    const WorldGrid& grid, std::size_t plane_count) {
  Flats flats;
  flats.planes.resize(plane_count);
  std::vector<FlatEdge> edges;
  std::uint32_t triangles = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const FaceTriangulation& face = faces[f];
    for (std::size_t t = 0; t < face.triangles.size(); ++t) {
      if (face.internal[t] == 0) continue;
      std::array<std::uint32_t, 3> v;
      for (std::size_t i = 0; i < 3; ++i) v[i] = numbering.of_face[f][face.triangles[t][i]];
      const Vec3 p = grid.from_lattice(numbering.points[v[0]]);
      const double area = norm(cross(grid.from_lattice(numbering.points[v[1]]) - p,
                                     grid.from_lattice(numbering.points[v[2]]) - p)) /
                          2;
      flats.planes[face.plane].section += area;
      if (face.covered[0][t] != 0 || face.covered[1][t] != 0) continue;
      flats.planes[face.plane].flat += area;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [a, b] = std::minmax(v[i], v[(i + 1) % 3]);
        edges.push_back({a, b, face.plane, triangles});
      }
      ++triangles;
    }
  }
  flats.regions = count_regions(std::move(edges), triangles);
  return flats;
}

}  // namespace crossloft
