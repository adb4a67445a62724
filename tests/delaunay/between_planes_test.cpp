#include "../../delaunay/between_planes.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "../../delaunay/delaunay2.h"
#include "../../delaunay/delaunay3.h"
#include "../../delaunay/lattice_predicates.h"
#include "point_sets.h"

using namespace crossloft;
using Tets = std::vector<std::array<std::uint32_t, 4>>;
using Coefficients = std::vector<std::array<std::int64_t, 2>>;

namespace {

/// The points of one plane, triangulated.
struct Plane {
  std::vector<std::array<std::uint32_t, 3>> triangles, sides;
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> edges;  ///< by ends among all points
  std::vector<std::uint32_t> numbers;
};

struct Scene {
  std::vector<LatticePoint> points;  ///< of both planes, lexicographic
  std::array<Plane, 2> planes;
  std::array<PlaneSide, 2> sides;
};

Plane triangulated(const LatticePlane& plane, const std::vector<LatticePoint>& points,
                   const std::vector<std::uint32_t>& numbers) {
  const LatticePredicates2 predicates(plane, points);
  Delaunay2 triangulation(predicates);
  triangulation.build();
  Plane result;
  result.triangles = triangulation.tri_mesh().vertices;
  result.numbers = numbers;
  for (const auto& t : result.triangles) {
    auto& sides = result.sides.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      std::array ends{numbers[t[(i + 1) % 3]], numbers[t[(i + 2) % 3]]};
      if (ends[0] > ends[1]) std::swap(ends[0], ends[1]);
      sides[i] = result.edges.try_emplace(ends, static_cast<std::uint32_t>(result.edges.size())).first->second;
    }
  }
  return result;
}

std::vector<LatticePoint> points_of(const LatticePlane& plane, Coefficients coefficients) {
  std::sort(coefficients.begin(), coefficients.end());
  coefficients.erase(std::unique(coefficients.begin(), coefficients.end()), coefficients.end());
  std::vector<LatticePoint> points;
  for (const auto& [u, v] : coefficients) {
    LatticeVector p = plane.origin;
    for (std::size_t k = 0; k < 3; ++k) p[k] += u * plane.e1[k] + v * plane.e2[k];
    points.push_back(make_point(p));
  }
  return points;
}

Scene scene(const std::array<LatticePlane, 2>& planes, const std::array<Coefficients, 2>& coefficients) {
  Scene s;
  std::array<std::vector<LatticePoint>, 2> points;
  for (std::size_t k = 0; k < 2; ++k) {
    points[k] = points_of(planes[k], coefficients[k]);
    s.points.insert(s.points.end(), points[k].begin(), points[k].end());
  }
  const auto less = [](const auto& a, const auto& b) { return compare_lex(a, b) < 0; };
  std::sort(s.points.begin(), s.points.end(), less);
  for (std::size_t k = 0; k < 2; ++k) {
    std::vector<std::uint32_t> numbers;
    for (const LatticePoint& p : points[k])
      numbers.push_back(static_cast<std::uint32_t>(
          std::lower_bound(s.points.begin(), s.points.end(), p, less) - s.points.begin()));
    s.planes[k] = triangulated(planes[k], points[k], numbers);
  }
  for (std::size_t k = 0; k < 2; ++k) {
    const Plane& plane = s.planes[k];
    REQUIRE(!plane.triangles.empty());
    const auto at = [&](std::size_t i) { return s.points[plane.numbers[plane.triangles[0][i]]]; };
    const int side = orient3d(at(0), at(1), at(2), s.points[s.planes[1 - k].numbers[0]]);
    REQUIRE(side != 0);
    s.sides[k] = {plane.triangles, plane.sides, static_cast<std::uint32_t>(plane.edges.size()), plane.numbers,
                  side < 0};
  }
  return s;
}

Tets named(const TetMesh& mesh) {
  Tets tets = mesh.vertices;
  for (auto& tet : tets) std::sort(tet.begin(), tet.end());
  std::sort(tets.begin(), tets.end());
  return tets;
}

void check_neighbours(const TetMesh& mesh, const std::vector<LatticePoint>& points) {
  std::map<std::array<std::uint32_t, 3>, std::vector<std::array<std::uint32_t, 2>>> facets;
  for (std::uint32_t t = 0; t < mesh.size(); ++t) {
    const auto& v = mesh.vertices[t];
    CHECK(orient3d(points[v[0]], points[v[1]], points[v[2]], points[v[3]]) > 0);
    for (std::uint32_t i = 0; i < 4; ++i) {
      std::array facet{v[kFacetSlots[i][0]], v[kFacetSlots[i][1]], v[kFacetSlots[i][2]]};
      std::sort(facet.begin(), facet.end());
      facets[facet].push_back({t, i});
    }
  }
  for (const auto& [facet, places] : facets) {
    REQUIRE(places.size() <= 2);
    for (std::size_t k = 0; k < places.size(); ++k) {
      const std::uint32_t expected = places.size() == 1 ? kNone : places[1 - k][0];
      CHECK(mesh.neighbours[places[k][0]][places[k][1]] == expected);
    }
  }
}

/// Order and edges as promised.
void check_layout(const Scene& s, const BetweenPlanes& found) {
  std::size_t t = 0;
  for (const PlaneSide& side : s.sides)
    for (const auto& corners : side.triangles) {
      const auto number = [&](std::size_t i) { return side.numbers[corners[i]]; };
      const auto& v = found.mesh.vertices[t++];
      CHECK(v[0] == number(0));
      CHECK(v[1] == number(side.clockwise ? 2 : 1));
      CHECK(v[2] == number(side.clockwise ? 1 : 2));
    }
  REQUIRE(found.mesh.size() == t + found.edges.size());
  for (std::size_t k = 0; k < found.edges.size(); ++k)
    for (std::size_t i = 0; i < 2; ++i) {
      const auto& v = found.mesh.vertices[t + k];
      const std::array ends{std::min(v[2 * i], v[2 * i + 1]), std::max(v[2 * i], v[2 * i + 1])};
      CHECK(s.planes[i].edges.at(ends) == found.edges[k][i]);
    }
}

void check_scene(const Scene& s) {
  const LatticePredicates3 predicates(s.points);
  Delaunay3 triangulation(predicates);
  triangulation.build();
  for (const bool swapped : {false, true}) {
    Scene turned = s;
    if (swapped) std::swap(turned.planes[0], turned.planes[1]), std::swap(turned.sides[0], turned.sides[1]);
    BetweenPlanes found;
    REQUIRE(delaunay_between_planes(s.points, turned.sides, found));
    CHECK(named(found.mesh) == named(triangulation.tet_mesh()));
    check_neighbours(found.mesh, s.points);
    check_layout(turned, found);
  }
}

Coefficients random_square(std::size_t n, std::int64_t range, std::uint64_t seed) {
  Coefficients list;
  for (const LatticePoint& p : point_sets::random_cube(n, range, seed))
    list.push_back({static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y)});
  return list;
}

Coefficients grid(std::int64_t n, std::int64_t step, std::int64_t from) {
  Coefficients list;
  for (std::int64_t u = 0; u < n; ++u)
    for (std::int64_t v = 0; v < n; ++v) list.push_back({from + u * step, from + v * step});
  return list;
}

Coefficients circle(std::size_t n, double radius, double x, double y) {
  Coefficients list;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(n);
    list.push_back({std::llround(x + radius * std::cos(angle)), std::llround(y + radius * std::sin(angle))});
  }
  return list;
}

const std::array<LatticePlane, 2> kParallel{make_axis_plane(2, 0), make_axis_plane(2, 7)};
const std::array<LatticePlane, 2> kOblique{make_lattice_plane({0, 0, 0}, {3, 1, 2}, {-1, 2, 5}),
                                           make_lattice_plane({100, 200, -900}, {-1, 2, 5}, {3, 1, 2})};

}  // namespace

TEST_CASE("two planes: random points, from many ties to none") {
  for (const auto& planes : {kParallel, kOblique})
    for (const std::int64_t range : {3, 6, 20, 1000, 1000000})
      for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        CAPTURE(range);
        CAPTURE(seed);
        const std::size_t n = range == 3 ? 40 : seed % 2 == 0 ? 25 : 200;
        check_scene(scene(planes, {random_square(n, range, seed), random_square(n + 5, range, seed + 100)}));
      }
}

TEST_CASE("two planes that meet beyond the points") {
  const std::array<LatticePlane, 2> planes{make_axis_plane(2, 0),
                                           make_lattice_plane({0, 0, 50}, {1, 0, 1}, {0, 1, 0})};
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    check_scene(scene(planes, {random_square(80, seed < 6 ? 8 : 900, seed), random_square(90, 40, seed + 9)}));
}

TEST_CASE("two planes: grids over each other, one triangle, one side far away") {
  for (const auto& planes : {kParallel, kOblique}) {
    check_scene(scene(planes, {grid(6, 2, 0), grid(6, 2, 0)}));
    check_scene(scene(planes, {grid(6, 2, 0), grid(7, 2, 1)}));
    check_scene(scene(planes, {grid(2, 1, 0), grid(9, 3, -4)}));
    check_scene(scene(planes, {Coefficients{{0, 0}, {1, 0}, {0, 1}}, grid(5, 1, 0)}));
    check_scene(scene(planes, {Coefficients{{0, 0}, {1, 0}, {0, 1}}, Coefficients{{0, 0}, {1, 0}, {0, 1}}}));
    check_scene(scene(planes, {grid(5, 1, 0), grid(5, 1, 1000)}));
    check_scene(scene(planes, {random_square(50, 10, 1), random_square(50, 1000000, 2)}));
  }
}

TEST_CASE("two planes: contours as circles, whose centres have many neighbours") {
  Coefficients hub = circle(300, 1e6, 0, 0), two = circle(200, 3e5, -4e5, 0);
  hub.push_back({0, 0});
  const Coefficients other = circle(150, 4e5, 5e5, 3e5);
  two.insert(two.end(), other.begin(), other.end());
  for (const auto& planes : {kParallel, kOblique}) {
    check_scene(scene(planes, {hub, two}));
    check_scene(scene(planes, {hub, circle(300, 1e6, 0, 0)}));
    check_scene(scene(planes, {two, circle(100, 9e5, 1e5, 0)}));
  }
}

TEST_CASE("two planes: a sector over a sector, with its hub first or last") {
  for (const double turn : {1.0, -1.0}) {
    Coefficients sector{{0, 0}};
    for (int i = 0; i <= 3000; ++i) {
      const double angle = 2.4 * i / 3000 - 1.2;
      sector.push_back({std::llround(turn * 1e8 * std::cos(angle)), std::llround(1e8 * std::sin(angle))});
    }
    check_scene(scene({make_axis_plane(2, 0), make_axis_plane(2, 10000000)}, {sector, sector}));
  }
}

TEST_CASE("two planes: a hub that is turned around for each of many triangles is left to insertion") {
  // All triangles of a cluster have the hub over them as apex. They are visited one beside the other, and
  // their edges look into all directions.
  Coefficients hub = circle(2000, 1e8, 0, 0);
  hub.push_back({0, 0});
  const Scene s = scene(kParallel, {random_square(1500, 1000, 1), hub});
  BetweenPlanes found;
  CHECK_FALSE(delaunay_between_planes(s.points, s.sides, found));
  check_scene(scene(kParallel, {random_square(100, 1000, 1), hub}));  // few of them are in time
}

TEST_CASE("two planes: triangulations that do not fit are refused") {
  Scene s = scene(kParallel, {random_square(60, 1000, 1), random_square(60, 1000, 2)});
  BetweenPlanes found;
  CHECK(delaunay_between_planes(s.points, s.sides, found));
  s.sides[1].clockwise = !s.sides[1].clockwise;
  CHECK_FALSE(delaunay_between_planes(s.points, s.sides, found));
}
