// The same triangulations as CGAL's, which breaks ties by the same perturbation: degenerate sets included.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <doctest/doctest.h>

#include <map>

#include "../../delaunay/delaunay2.h"
#include "../../delaunay/delaunay3.h"
#include "../../delaunay/lattice_predicates.h"
#include "point_sets.h"

using namespace crossloft;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

namespace {

using Key = std::array<double, 3>;

std::map<Key, std::uint32_t> rank_by_coordinates(const std::vector<LatticePoint>& points) {
  std::map<Key, std::uint32_t> rank;
  for (const LatticePoint& p : points) rank[{p.x, p.y, p.z}] = 0;
  std::uint32_t next = 0;
  for (auto& [key, r] : rank) r = next++;
  return rank;
}

template <std::size_t N>
std::vector<std::array<std::uint32_t, N>> sorted(std::vector<std::array<std::uint32_t, N>> simplices) {
  for (auto& s : simplices) std::sort(s.begin(), s.end());
  std::sort(simplices.begin(), simplices.end());
  return simplices;
}

std::vector<std::array<std::uint32_t, 4>> cgal_tets(const std::vector<LatticePoint>& points) {
  CGAL::Delaunay_triangulation_3<Kernel> triangulation;
  for (const LatticePoint& p : points) triangulation.insert(Kernel::Point_3(p.x, p.y, p.z));
  auto rank = rank_by_coordinates(points);
  std::vector<std::array<std::uint32_t, 4>> tets;
  for (const auto cell : triangulation.finite_cell_handles()) {
    auto& tet = tets.emplace_back();
    for (int k = 0; k < 4; ++k) {
      const Kernel::Point_3& p = cell->vertex(k)->point();
      tet[static_cast<std::size_t>(k)] = rank.at({p.x(), p.y(), p.z()});
    }
  }
  return sorted(tets);
}

std::vector<std::array<std::uint32_t, 3>> cgal_triangles(const std::vector<LatticePoint>& points) {
  CGAL::Delaunay_triangulation_2<Kernel> triangulation;
  for (const LatticePoint& p : points) triangulation.insert(Kernel::Point_2(p.x, p.y));
  auto rank = rank_by_coordinates(points);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const auto face : triangulation.finite_face_handles()) {
    auto& triangle = triangles.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const Kernel::Point_2& p = face->vertex(k)->point();
      triangle[static_cast<std::size_t>(k)] = rank.at({p.x(), p.y(), 0});
    }
  }
  return sorted(triangles);
}

void check_tets(const std::vector<LatticePoint>& points) {
  const LatticePredicates3 predicates(points);
  Delaunay3 triangulation(predicates);
  triangulation.build();
  CHECK(triangulation.verify() == "");
  CHECK(point_sets::by_rank(triangulation.tet_mesh().vertices, point_sets::ranks(points)) ==
        cgal_tets(points));
}

void check_triangles(std::vector<LatticePoint> points) {
  for (LatticePoint& p : points) p.z = 0;
  const LatticePlane floor = make_axis_plane(2, 0);
  const LatticePredicates2 predicates(floor, points);
  Delaunay2 triangulation(predicates);
  triangulation.build();
  CHECK(triangulation.verify() == "");
  CHECK(point_sets::by_rank(triangulation.tri_mesh().vertices, point_sets::ranks(points)) ==
        cgal_triangles(points));
}

}  // namespace

TEST_CASE("tetrahedra equal CGAL's on random points") {
  check_tets(point_sets::random_cube(3000, std::int64_t{1} << 50, 1));
  check_tets(point_sets::random_cube(1000, 1000, 2));
}

TEST_CASE("tetrahedra equal CGAL's on degenerate points") {
  check_tets(point_sets::grid(7, 6, 5));
  check_tets(point_sets::sphere(81));
  check_tets(point_sets::random_cube(500, 7, 3));
  check_tets(point_sets::on_planes(5, 200, 1000, 300, 4));
  check_tets(point_sets::on_planes(3, 100, 8, 3, 5));
  check_tets(point_sets::on_cube_faces(6, 1, 100, 6));
}

TEST_CASE("triangles equal CGAL's") {
  check_triangles(point_sets::random_cube(3000, std::int64_t{1} << 50, 7));
  check_triangles(point_sets::random_cube(2000, 40, 8));
  check_triangles(point_sets::grid(30, 20, 1));
}
