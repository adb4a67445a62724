// The same tetrahedra and hidden sites as CGAL's regular triangulation.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <doctest/doctest.h>

#include <map>
#include <set>

#include "../../delaunay/regular3.h"
#include "../../delaunay/weighted_predicates.h"
#include "point_sets.h"
#include "site_sets.h"

using namespace crossloft;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Sites = std::vector<WeightedPoint>;
using Tets = std::vector<std::array<std::uint32_t, 4>>;
using Places = std::map<std::array<double, 3>, std::uint32_t>;

namespace {

std::array<double, 3> place(const Vec3& p) { return {p.x, p.y, p.z}; }

Tets sorted(Tets tets) {
  for (auto& t : tets) std::sort(t.begin(), t.end());
  std::sort(tets.begin(), tets.end());
  return tets;
}

struct Outcome {
  Tets tets;
  std::set<std::uint32_t> vertices;
};

Outcome cgal_outcome(const Sites& sites, const Places& rank) {
  CGAL::Regular_triangulation_3<Kernel> triangulation;
  for (const WeightedPoint& s : sites) {
    const Kernel::Point_3 position(s.position.x, s.position.y, s.position.z);
    triangulation.insert(Kernel::Weighted_point_3(position, s.weight));
  }
  Outcome outcome;
  const auto rank_of = [&](const auto vertex) {
    const auto& p = vertex->point();
    return rank.at({p.x(), p.y(), p.z()});
  };
  for (const auto cell : triangulation.finite_cell_handles()) {
    auto& tet = outcome.tets.emplace_back();
    for (int k = 0; k < 4; ++k) tet[static_cast<std::size_t>(k)] = rank_of(cell->vertex(k));
  }
  for (const auto vertex : triangulation.finite_vertex_handles()) outcome.vertices.insert(rank_of(vertex));
  outcome.tets = sorted(outcome.tets);
  return outcome;
}

/// Returns the number of hidden sites.
std::size_t check(const Sites& sites) {
  Places rank;
  for (const WeightedPoint& s : sites) rank[place(s.position)] = 0;
  std::uint32_t next = 0;
  for (auto& [key, r] : rank) r = next++;
  const Outcome expected = cgal_outcome(sites, rank);

  const WeightedPredicates3 predicates(sites);
  Regular3 triangulation(predicates);
  triangulation.build();
  CHECK(triangulation.verify() == "");
  Tets tets = triangulation.tet_mesh().vertices;
  for (auto& tet : tets)
    for (auto& v : tet) v = rank.at(place(sites[v].position));
  std::set<std::uint32_t> vertices;
  for (std::uint32_t i = 0; i < sites.size(); ++i)
    if (triangulation.is_vertex(i)) vertices.insert(rank.at(place(sites[i].position)));
  CHECK(sorted(tets) == expected.tets);
  CHECK(vertices == expected.vertices);
  return rank.size() - vertices.size();
}

/// n sites in the unit cube, weights in [0, heaviest).
Sites random_sites(std::size_t n, double heaviest, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto draw = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  Sites sites;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = draw(), y = draw(), z = draw();
    sites.push_back({{x, y, z}, heaviest * draw()});
  }
  return sites;
}

}  // namespace

TEST_CASE("random sites, from none hidden to most") {
  CHECK(check(random_sites(5000, 1e-6, 1)) < 10);
  CHECK(check(random_sites(3000, 0.005, 2)) > 100);
  CHECK(check(random_sites(3000, 0.05, 3)) > 1000);
  CHECK(check(random_sites(3000, 1, 4)) > 2500);
}

TEST_CASE("sites with ties: grids, spheres, planes, repeated places") {
  check(site_sets::weighted(point_sets::grid(7, 6, 5), 1, 1));
  check(site_sets::weighted(point_sets::grid(7, 6, 5), 2, 1));
  check(site_sets::weighted(point_sets::sphere(81), 10, 2));
  check(site_sets::weighted(point_sets::random_cube(800, 7, 3), 6, 3));
  check(site_sets::weighted(point_sets::on_planes(5, 200, 1000, 300, 4), 3000, 4));
  check(site_sets::weighted(point_sets::on_cube_faces(6, 1, 100, 6), 4, 6));
}
