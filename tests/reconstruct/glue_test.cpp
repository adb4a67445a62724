// The boundary of any set of tetrahedra is a closed oriented 2-manifold by index.
#include "reconstruct/glue.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "geom/parallel.h"

namespace {

using namespace crossloft;
using Tet = std::array<std::uint32_t, 4>;
using Point = std::array<std::int64_t, 3>;

std::int64_t det(const Point& a, const Point& b, const Point& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// Six times the signed volume.
std::int64_t volume(const std::vector<Point>& p, const Tet& t) {
  return det(minus(p[t[1]], p[t[0]]), minus(p[t[2]], p[t[0]]), minus(p[t[3]], p[t[0]]));
}

std::int64_t volume(const std::vector<Point>& p, const std::vector<Tet>& tets) {
  std::int64_t sum = 0;
  for (const Tet& t : tets) sum += volume(p, t);
  return sum;
}

/// Of the body that the surface bounds. Coordinates are doubled so that midpoints are integral, hence the 8.
std::int64_t volume_8(const std::vector<Point>& p, const GluedSurface& surface) {
  const auto place = [&](std::uint32_t v) {
    const SurfaceVertex& origin = surface.vertices[v];
    const Point& a = p[origin.a];
    const Point& b = origin.is_midpoint() ? p[origin.b] : a;
    return Point{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
  };
  std::int64_t sum = 0;
  for (const auto& t : surface.triangles) sum += det(place(t[0]), place(t[1]), place(t[2]));
  return sum;
}

/// Points of an n x n x n grid in lexicographic order and its cubes cut into six tetrahedra each (Kuhn).
struct Grid {
  std::vector<Point> points;
  std::vector<Tet> tets;

  explicit Grid(std::uint32_t n) {
    for (std::uint32_t i = 0; i < n * n * n; ++i) points.push_back({i / (n * n), i / n % n, i % n});
    std::array<std::uint32_t, 3> step{n * n, n, 1};
    do {
      for (std::uint32_t i = 0; i < n * n * n; ++i) {
        if (points[i][0] + 1 < n && points[i][1] + 1 < n && points[i][2] + 1 < n) add_path(i, step);
      }
    } while (std::next_permutation(step.begin(), step.end(), std::greater<>()));
  }

  void add_path(std::uint32_t i, const std::array<std::uint32_t, 3>& step) {
    Tet t{i, i + step[0], i + step[0] + step[1], i + step[0] + step[1] + step[2]};
    if (volume(points, t) < 0) std::swap(t[2], t[3]);
    tets.push_back(t);
  }
};

GluedSurface checked(const std::vector<Tet>& tets) {
  const auto result = glue(tets);
  REQUIRE(result.ok());
  CHECK(verify_surface(static_cast<std::uint32_t>(result->vertices.size()), result->triangles));
  CHECK(std::is_sorted(result->vertices.begin(), result->vertices.end(),
                       [](const SurfaceVertex& p, const SurfaceVertex& q) {
                         return p.is_midpoint() != q.is_midpoint() ? q.is_midpoint() : p < q;
                       }));
  const std::set<SurfaceVertex> points(result->vertices.begin(), result->vertices.end());
  CHECK(result->copies == result->vertices.size() - points.size());
  return *result;
}

bool same(const GluedSurface& p, const GluedSurface& q) {
  return p.vertices == q.vertices && p.triangles == q.triangles && p.split_edges == q.split_edges;
}

int euler(const GluedSurface& s) {
  return static_cast<int>(s.vertices.size()) - static_cast<int>(s.triangles.size() / 2);
}

}  // namespace

TEST_CASE("nothing glues to nothing") {
  const GluedSurface surface = checked({});
  CHECK(surface.vertices.empty());
  CHECK(surface.triangles.empty());
}

TEST_CASE("one tetrahedron gives its four facets, outward") {
  const GluedSurface surface = checked({{0, 1, 2, 3}});
  CHECK(surface.triangles ==
        std::vector<std::array<std::uint32_t, 3>>{{0, 1, 3}, {0, 2, 1}, {0, 3, 2}, {1, 2, 3}});
  CHECK(surface.copies == 0);
}

TEST_CASE("two tetrahedra with a common facet lose it") {
  const GluedSurface surface = checked({{0, 1, 2, 3}, {1, 2, 3, 4}});
  CHECK(surface.triangles.size() == 6);
  CHECK(surface.vertices.size() == 5);
}

TEST_CASE("two tetrahedra with a common vertex come apart there") {
  const GluedSurface surface = checked({{0, 1, 2, 3}, {3, 4, 5, 6}});
  CHECK(surface.vertices.size() == 8);
  CHECK(surface.pinched_vertices == 1);
  CHECK(surface.copies == 1);
  CHECK(surface.pinched_edges == 0);
  CHECK(euler(surface) == 4);
}

TEST_CASE("two tetrahedra with a common edge come apart along it") {
  const GluedSurface surface = checked({{0, 1, 2, 3}, {0, 1, 4, 5}});
  CHECK(surface.vertices.size() == 8);
  CHECK(surface.pinched_vertices == 2);
  CHECK(surface.pinched_edges == 1);
  CHECK(surface.split_edges == 0);
  CHECK(euler(surface) == 4);
}

// Every other tetrahedron around the edge 0-1 is missing, but 0 and 1 are wrapped up all around: one umbrella
// each. The edges 3-4, 5-6, 7-2 of the missing ones are between two wedges too, one at 0 and one at 1.
TEST_CASE("wedges that share both ends of their edge get a midpoint each") {
  std::vector<Tet> tets;
  const std::uint32_t around_0 = 8, around_1 = 9;
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t a = 2 + i, b = 2 + (i + 1) % 6;
    if (i % 2 == 0) tets.push_back({0, 1, a, b});
    tets.push_back({around_0, 0, a, b});
    tets.push_back({1, around_1, a, b});
  }
  const GluedSurface surface = checked(tets);
  CHECK(surface.pinched_edges == 4);
  CHECK(surface.pinched_vertices == 0);
  CHECK(surface.split_edges == 3 + 3 * 2);
  CHECK(surface.copies == 2 + 3 * 1);  // of midpoints
  CHECK(std::count(surface.vertices.begin(), surface.vertices.end(), SurfaceVertex{0, 1}) == 3);
  CHECK(std::count(surface.vertices.begin(), surface.vertices.end(), SurfaceVertex{3, 4}) == 2);
}

TEST_CASE("overlapping tetrahedra are refused") {
  CHECK_FALSE(glue(std::vector<Tet>{{0, 1, 2, 3}, {0, 1, 2, 4}}).ok());
  CHECK_FALSE(glue(std::vector<Tet>{{0, 1, 2, 3}, {1, 2, 3, 4}, {1, 2, 3, 5}}).ok());
  CHECK(glue(std::vector<Tet>{{0, 1, 2, 3}, {0, 1, 2, 4}}).error().code == ErrorCode::internal);
}

TEST_CASE("what is known of the facets does not change the surface") {
  const Grid grid(5);
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::vector<Tet> tets;
    for (const Tet& t : grid.tets)
      if (random() % 10 < 6) tets.push_back(t);
    KnownFacets known{UnsetVector<std::uint32_t>(4 * tets.size(), kNone), {}};
    std::vector<std::uint8_t> loose;
    for (std::uint32_t t = 0; t < tets.size(); ++t) {
      loose.push_back(random() % 10 < seed % 4 ? 1 : 0);
      if (loose[t] != 0) known.loose.push_back(t);
    }
    std::map<std::set<std::uint32_t>, std::uint32_t> first;
    for (std::uint32_t f = 0; f < 4 * tets.size(); ++f) {
      std::set<std::uint32_t> facet(tets[f / 4].begin(), tets[f / 4].end());
      facet.erase(tets[f / 4][f % 4]);
      const auto [other, is_new] = first.emplace(facet, f);
      if (is_new || loose[f / 4] != 0 || loose[other->second / 4] != 0) continue;
      known.partner[f] = other->second;
      known.partner[other->second] = f;
    }
    const auto surface = glue(tets, known);
    REQUIRE(surface.ok());
    CHECK(same(*surface, checked(tets)));
  }
}

TEST_CASE("random subsets of a grid: manifold, right volume, no dependence on the order") {
  const Grid grid(5);
  std::uint64_t split_edges = 0, pinched_edges = 0;
  for (std::uint32_t seed = 0; seed < 120; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const std::uint32_t share = 50 + seed % 9 * 100;  // of 1000
    std::vector<Tet> tets;
    for (const Tet& t : grid.tets) {
      if (random() % 1000 < share) tets.push_back(t);
    }
    const GluedSurface surface = checked(tets);
    CHECK(volume_8(grid.points, surface) == 8 * volume(grid.points, tets));
    split_edges += surface.split_edges;
    pinched_edges += surface.pinched_edges;

    std::shuffle(tets.begin(), tets.end(), random);
    for (Tet& t : tets) {
      std::swap(t[0], t[1]);
      std::swap(t[random() % 2], t[2 + random() % 2]);
      CHECK(volume(grid.points, t) > 0);
    }
    CHECK(same(surface, checked(tets)));
  }
  CHECK(pinched_edges > 0);
  CHECK(split_edges > 0);
}

TEST_CASE("the whole grid is a ball") {
  const GluedSurface surface = checked(Grid(6).tets);
  CHECK(euler(surface) == 2);
  CHECK(surface.copies == 0);
}

TEST_CASE("verify_surface names what is no closed oriented manifold") {
  const GluedSurface ball = checked(Grid(2).tets);
  const auto count = static_cast<std::uint32_t>(ball.vertices.size());
  auto triangles = ball.triangles;
  CHECK(verify_surface(count, triangles));
  CHECK_FALSE(verify_surface(count + 1, triangles));  // a vertex without a triangle
  CHECK_FALSE(verify_surface(count - 1, triangles));  // an index out of range
  std::swap(triangles[0][0], triangles[0][1]);
  CHECK_FALSE(verify_surface(count, triangles));  // one turned
  triangles.erase(triangles.begin());
  CHECK_FALSE(verify_surface(count, triangles));  // open
  // Two tetrahedra that share vertex 3 by index.
  CHECK_FALSE(verify_surface(
      7, std::vector<std::array<std::uint32_t, 3>>{
             {0, 1, 3}, {0, 2, 1}, {0, 3, 2}, {1, 2, 3}, {3, 4, 6}, {3, 5, 4}, {3, 6, 5}, {4, 5, 6}}));
  CHECK_FALSE(verify_surface(3, std::vector<std::array<std::uint32_t, 3>>{{0, 0, 1}, {0, 1, 0}}));
}

TEST_CASE("a boundary of many blocks is the same with any number of threads") {
  const Grid grid(20);
  std::mt19937 random(1);
  std::vector<Tet> tets;
  for (const Tet& t : grid.tets)
    if (random() % 10 < 4) tets.push_back(t);
  const GluedSurface surface = checked(tets);
  REQUIRE(surface.triangles.size() > 4 * kBlock);
  CHECK(surface.split_edges > 0);
  CHECK(volume_8(grid.points, surface) == 8 * volume(grid.points, tets));
  for (const unsigned threads : {2u, 7u}) {
    Context context;
    context.threads = threads;
    const auto other = glue(tets, context);
    REQUIRE(other.ok());
    CHECK(same(surface, *other));
    CHECK(other->pinched_edges == surface.pinched_edges);
    CHECK(other->pinched_vertices == surface.pinched_vertices);
    CHECK(other->copies == surface.copies);
  }
}

TEST_CASE("a cancelled glue is no surface") {
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  const auto surface = glue(Grid(3).tets, context);
  REQUIRE_FALSE(surface.ok());
  CHECK(surface.error().code == ErrorCode::cancelled);
}
