// Cells whose diagrams are known otherwise, ties, and what must not matter.

#include <set>

#include "../../delaunay/delaunay2.h"
#include "../delaunay/point_sets.h"
#include "face_cells.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

double length(Vec2 v) { return std::sqrt(dot(v, v)); }

Vec2 circumcentre(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 u = b - a, v = c - a;
  const Vec2 w = dot(u, u) * v - dot(v, v) * u;
  return a + (0.5 / cross(u, v)) * Vec2{w.y, -w.x};
}

bool same_bits(const FaceArc& a, const FaceArc& b) {
  const auto as_tuple = [](const FaceArc& arc) {
    return std::tuple(arc.sites, arc.curve.is_line, arc.curve.centre, arc.curve.radius, arc.curve.direction,
                      arc.from, arc.to, arc.clockwise, arc.over_half, arc.whole, arc.from_infinite,
                      arc.to_infinite);
  };
  return as_tuple(a) == as_tuple(b);
}

bool same_bits(const Diagrams& a, const Diagrams& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(),
                      [](const FaceArc& p, const FaceArc& q) { return same_bits(p, q); });
  });
}

void check_ties(const Cell& cell, double reach) {
  const Diagrams arcs = all_arcs(cell);
  for (std::uint32_t f = 0; f < cell.planes.size(); ++f) {
    CAPTURE(f);
    CHECK(check_by_scan(arcs[f], sites_of(cell, f), square(reach), 101, reach * 1e-6) > 100);
  }
}

}  // namespace

TEST_CASE("two parallel planes: the Voronoi diagram of the other section's vertices") {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    CAPTURE(seed);
    Cell cell = cell_of({make_axis_plane(2, -300), make_axis_plane(2, 500)});
    scatter(cell, 80, 1000, seed);
    cell.finish();
    const Diagrams arcs = all_arcs(cell);
    for (std::uint32_t f = 0; f < 2; ++f) {
      const std::vector<FaceSite> sites = sites_of(cell, f);
      std::vector<std::uint32_t> vertex;
      std::vector<LatticePoint> points;
      for (std::uint32_t v = 0; v < sites.size(); ++v)
        if (sites[v].height > 0) vertex.push_back(v), points.push_back(cell.points[v]);
      const LatticePredicates2 predicates(cell.planes[1 - f], points);
      Delaunay2 triangulation(predicates);
      triangulation.build();
      const TriMesh mesh = triangulation.tri_mesh();
      std::set<std::array<std::uint32_t, 2>> edges;
      std::vector<Vec2> centres;
      for (const auto& t : mesh.vertices) {
        for (std::size_t k = 0; k < 3; ++k) {
          const std::uint32_t a = vertex[t[k]], b = vertex[t[(k + 1) % 3]];
          edges.insert({std::min(a, b), std::max(a, b)});
        }
        centres.push_back(
            circumcentre(sites[vertex[t[0]]].foot, sites[vertex[t[1]]].foot, sites[vertex[t[2]]].foot));
      }
      CHECK(arcs[f].size() == edges.size());
      for (const FaceArc& arc : arcs[f]) {
        CHECK(arc.curve.is_line);
        CHECK(edges.count(arc.sites) == 1);
        const auto is_centre = [&](Vec2 p) {
          return std::any_of(centres.begin(), centres.end(),
                             [&](Vec2 c) { return length(p - c) <= 1e-9 * (1000 + length(c)); });
        };
        CHECK((arc.from_infinite || is_centre(arc.from)));
        CHECK((arc.to_infinite || is_centre(arc.to)));
      }
    }
  }
}

TEST_CASE("two other planes: hyperbolic, all circles are centred on the common line") {
  const LatticePlane a = make_lattice_plane({0, 0, -1000}, {3, 1, 0}, {1, 2, 1});
  const LatticePlane b = make_lattice_plane({0, 0, 1500}, {2, -1, 1}, {1, 3, 0});
  Cell cell = cell_of({a, b});
  scatter(cell, 150, 1000, 7);
  cell.finish();
  const Diagrams arcs = all_arcs(cell);
  std::size_t circles = 0;
  for (std::uint32_t f = 0; f < 2; ++f)
    for (const FaceArc& arc : arcs[f]) {
      if (arc.curve.is_line) continue;
      ++circles;
      const Vec3 centre = cell.frames[f].to_space(arc.curve.centre);
      const LatticePlane& other = cell.planes[1 - f];
      const Vec3 normal = real(make_point(other.normal));
      const double distance = dot(normal, centre - real(make_point(other.origin))) / norm(normal);
      CHECK(std::abs(distance) <= 1e-9 * (arc.curve.radius + 1e4));
    }
  CHECK(circles > 200);
}

TEST_CASE("a low site among high ones has a whole circle around it") {
  Cell cell = box_cell(1000);
  for (const LatticeVector& v : {LatticeVector{-1000, 0, -990},
                                 {1000, -900, 400},
                                 {1000, 900, 500},
                                 {-900, 1000, 600},
                                 {800, -1000, 550},
                                 {100, 200, 1000}})
    cell.add(make_point(v));
  cell.finish();
  const std::vector<FaceArc> bottom = all_arcs(cell)[4];
  std::size_t whole = 0;
  for (const FaceArc& arc : bottom) {
    if (!arc.whole) continue;
    ++whole;
    CHECK(arc.sites[0] == 0);
    CHECK(!arc.clockwise);
    CHECK(length(arc.from - arc.curve.centre) == doctest::Approx(arc.curve.radius));
  }
  CHECK(whole == 1);
}

TEST_CASE("two sites that are the highest: a whole line") {
  Cell cell = cell_of({make_axis_plane(2, -100), make_axis_plane(2, 100)});
  for (const LatticeVector& v : {LatticeVector{-50, 3, 100}, {50, -4, 100}, {0, 60, -100}, {0, -60, -100}})
    cell.add(make_point(v));
  cell.finish();
  const Diagrams arcs = all_arcs(cell);
  for (std::uint32_t f = 0; f < 2; ++f) {
    REQUIRE(arcs[f].size() == 1);
    CHECK(arcs[f][0].curve.is_line);
    CHECK(arcs[f][0].from_infinite);
    CHECK(arcs[f][0].to_infinite);
  }
  const Vec2 d = arcs[0][0].curve.direction;
  CHECK(check_by_scan(arcs[0], sites_of(cell, 0), square(500), 50, 1) == 100);
  CHECK(std::abs(dot(d, sites_of(cell, 0)[1].foot - sites_of(cell, 0)[0].foot)) < 1e-9);
}

TEST_CASE("one site off the plane has no arc") {
  Cell cell = cell_of({make_axis_plane(2, -1)});
  for (const LatticeVector& v : {LatticeVector{0, 0, 5}, {9, 0, -1}, {0, 9, -1}, {-9, -7, -1}})
    cell.add(make_point(v));
  cell.finish();
  CHECK(all_arcs(cell)[0].empty());
}

TEST_CASE("no tetrahedra, no arcs") {
  Cell cell = box_cell(10);
  CHECK(all_arcs(cell).size() == 6);
  cell.add(make_point({1, 2, 10}));
  cell.finish();
  for (const auto& arcs : all_arcs(cell)) CHECK(arcs.empty());
}

TEST_CASE("ties: grids on the faces of a cube") {
  Cell cell = box_cell(600);
  cell.points = point_sets::on_cube_faces(600, 200, 0, 1);
  cell.finish();
  check_ties(cell, 600);
}

TEST_CASE("ties: coaxial circles of 12 points") {
  Cell cell = cell_of({make_axis_plane(2, -70), make_axis_plane(2, 70)});
  for (const std::int64_t z : {-70, 70})
    for (const auto& [x, y] : {std::array<std::int64_t, 2>{50, 0}, {40, 30}, {30, 40}})
      for (const LatticeVector& v : {LatticeVector{x, y, z}, {-y, x, z}, {-x, -y, z}, {y, -x, z}})
        cell.add(make_point(v));
  cell.finish();
  check_ties(cell, 40);
}

TEST_CASE("coordinates up to 2^49") {
  const std::int64_t half = std::int64_t{1} << 49;
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    Cell cell = box_cell(half);
    scatter(cell, 60, half, seed);
    cell.finish();
    check_ties(cell, static_cast<double>(half));
  }
}

TEST_CASE("more than 64 faces") {
  Cell cell = random_cell(80, 1000000, 3);
  scatter(cell, 6, 9000, 3);
  cell.finish();
  const Diagrams arcs = all_arcs(cell);
  for (const std::uint32_t f : {0u, 63u, 64u, 79u})
    CHECK(check_by_scan(arcs[f], sites_of(cell, f), square(5e5), 40, 0.1) > 100);
}

TEST_CASE("parallel faces further than 64 faces apart in the list") {
  constexpr std::int64_t kStep = 1 << 20;
  const LatticeVector e1{kStep + 7, 3 * kStep / 5, kStep / 3 + 1}, e2{-kStep / 2 - 3, kStep + 11, kStep / 7};
  const LatticePlane bottom = make_lattice_plane({0, 0, -40000000}, e1, e2),
                     top = make_lattice_plane({5, 3, 60000000}, e1, e2);
  std::vector<LatticePlane> sides;
  for (int i = 0; i < 70; ++i) {
    const double a = 6.283185307179586 * (i + 0.3) / 70, x = std::cos(a), y = std::sin(a);
    sides.push_back(make_lattice_plane({std::llround(3e8 * x), std::llround(3e8 * y), 0},
                                       {std::llround(-kStep * y), std::llround(kStep * x), 0},
                                       {3 * (i % 5) - 5, i % 7 - 3, kStep}));
  }
  // On the top explicit points, and rational ones whose height rounds differently.
  LatticePointStore store;
  std::vector<LatticePoint> points(24);
  for (std::size_t i = 0; i < 24; ++i)
    REQUIRE(store.meet(top, sides[3 * i], sides[(3 * i + 1) % 70], points[i]));
  for (std::int64_t i = -5; i <= 5; ++i)
    for (const auto& [plane, u, v] :
         {std::tuple(top, 45 + i, 9 * i), {top, 9 * i, i * i}, {bottom, 9 * i, i * i}}) {
      LatticeVector p = plane.origin;
      for (std::size_t k = 0; k < 3; ++k) p[k] += u * e1[k] + v * e2[k];
      points.push_back(make_point(p));
    }
  const auto arcs_of = [&](std::vector<LatticePlane> planes) {
    Cell cell = cell_of(std::move(planes));
    for (const LatticePoint& p : points)
      if (cell.contains(p)) cell.add(p);
    cell.finish();
    return all_arcs(cell)[0];
  };
  std::vector<LatticePlane> near{bottom, top}, far{bottom};
  near.insert(near.end(), sides.begin(), sides.end());
  far.insert(far.end(), sides.begin(), sides.end());
  far.push_back(top);
  const std::vector<FaceArc> arcs = arcs_of(far);
  CHECK(std::all_of(arcs.begin(), arcs.end(), [](const FaceArc& arc) { return arc.curve.is_line; }));
  CHECK(arcs.size() > 60);
  CHECK(same_bits(Diagrams{arcs}, Diagrams{arcs_of(near)}));
}

TEST_CASE("the order of the tetrahedra does not matter") {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Cell cell = box_cell(600);
    cell.points = point_sets::on_cube_faces(600, 300, 60, seed);
    cell.points.erase(std::unique(cell.points.begin(), cell.points.end(),
                                  [](const auto& a, const auto& b) { return equal(a, b); }),
                      cell.points.end());
    cell.finish();
    const Diagrams arcs = all_arcs(cell);
    // The same triangulation, built from the points in another order.
    std::vector<std::uint32_t> number(cell.points.size());
    for (std::uint32_t v = 0; v < number.size(); ++v) number[v] = v;
    std::shuffle(number.begin(), number.end(), std::mt19937_64(seed));
    std::vector<LatticePoint> moved;
    for (const std::uint32_t v : number) moved.push_back(cell.points[v]);
    const LatticePredicates3 predicates(moved);
    Delaunay3 triangulation(predicates);
    triangulation.build();
    TetMesh mesh = triangulation.tet_mesh();
    for (auto& tet : mesh.vertices)
      for (std::uint32_t& v : tet) v = number[v];
    cell.mesh = mesh;
    CHECK(same_bits(all_arcs(cell), arcs));
  }
}

TEST_CASE("ties: all sites on one sphere that is tangent to the faces") {
  constexpr std::int64_t kUnit = 1000003;
  Cell cell = box_cell(9 * kUnit);
  cell.planes.push_back(make_lattice_plane({3 * kUnit, 6 * kUnit, 6 * kUnit}, {2, -1, 0}, {0, 1, -1}));
  cell = cell_of(cell.planes);
  cell.points = point_sets::sphere(81);
  for (LatticePoint& p : cell.points) p.x *= kUnit, p.y *= kUnit, p.z *= kUnit;
  cell.finish();
  check_ties(cell, 2e7);
}
