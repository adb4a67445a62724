#include <doctest/doctest.h>

#include <set>

#include "../../delaunay/delaunay3.h"
#include "../../delaunay/lattice_predicates.h"
#include "../../delaunay/regular3.h"
#include "../../delaunay/triangulation.h"
#include "../../delaunay/weighted_predicates.h"
#include "brute_force.h"
#include "point_sets.h"
#include "site_sets.h"

using namespace crossloft;
using Sites = std::vector<WeightedPoint>;

namespace {

/// What a triangulation says, by the ranks of places: the simplices of its dimension and the vertices.
struct Outcome {
  int dimension = -1;
  std::vector<std::array<std::uint32_t, 4>> tets;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> chain;
  std::set<std::uint32_t> vertices;
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

/// kept(i) is the lowest index of the vertex's equals, or kNone for others.
template <class T>
void check_kept(const T& triangulation, const Sites& sites) {
  for (std::uint32_t i = 0; i < sites.size(); ++i) {
    const std::uint32_t k = triangulation.kept(i);
    if (k == kNone) continue;
    CHECK(k <= i);
    CHECK(triangulation.is_vertex(k));
    CHECK(sites[k].position == sites[i].position);
    CHECK(sites[k].weight == sites[i].weight);
  }
}

/// The one call says the same in the same numbers.
void check_one_call(const Regular3<WeightedPredicates3>& triangulation, const Sites& sites) {
  const Triangulation result = regular_triangulation(sites);
  CHECK(result.dimension == triangulation.dimension());
  REQUIRE(result.kept.size() == sites.size());
  std::vector<std::uint32_t> identity(sites.size());
  for (std::uint32_t i = 0; i < sites.size(); ++i) {
    CHECK(result.kept[i] == triangulation.kept(i));
    identity[i] = i;
  }
  CHECK(point_sets::by_rank(result.tets.vertices, identity) ==
        point_sets::by_rank(triangulation.tet_mesh().vertices, identity));
  CHECK(point_sets::by_rank(result.triangles.vertices, identity) ==
        point_sets::by_rank(triangulation.tri_mesh().vertices, identity));
  CHECK(result.chain == triangulation.chain());
}

Outcome triangulate(const Sites& sites) {
  const WeightedPredicates3 predicates(sites);
  Regular3 triangulation(predicates);
  triangulation.build();
  CHECK(triangulation.verify() == "");
  check_kept(triangulation, sites);
  check_one_call(triangulation, sites);
  const auto rank = point_sets::ranks(site_sets::positions(sites));
  Outcome outcome{triangulation.dimension(),
                  point_sets::by_rank(triangulation.tet_mesh().vertices, rank),
                  point_sets::by_rank(triangulation.tri_mesh().vertices, rank),
                  triangulation.chain(),
                  {}};
  for (std::uint32_t& i : outcome.chain) i = rank[i];
  for (std::uint32_t i = 0; i < sites.size(); ++i) {
    if (!triangulation.is_vertex(i)) continue;
    CHECK_MESSAGE(outcome.vertices.insert(rank[i]).second, "two vertices in one place");
  }
  return outcome;
}

template <std::size_t N>
std::set<std::uint32_t> vertices_of(const std::vector<std::array<std::uint32_t, N>>& simplices) {
  std::set<std::uint32_t> vertices;
  for (const auto& s : simplices) vertices.insert(s.begin(), s.end());
  return vertices;
}

void check_against_definition(const Sites& sites) {
  const Sites sorted = site_sets::sorted_heaviest(sites);
  const auto expected =
      brute_force::Lifted<3>(site_sets::positions(sorted), site_sets::weights(sorted)).triangulate();
  const Outcome outcome = triangulate(sites);
  CHECK(outcome.tets == expected);
  CHECK(outcome.vertices == vertices_of(expected));
}

/// In the plane z = 0, which the definition sees as a plane, and moved to where three axes are alike.
void check_plane_against_definition(Sites sites) {
  for (WeightedPoint& s : sites) s.position.z = 0;
  const Sites sorted = site_sets::sorted_heaviest(sites);
  const auto expected =
      brute_force::Lifted<2>(site_sets::positions(sorted), site_sets::weights(sorted)).triangulate();
  const Outcome outcome = triangulate(sites);
  REQUIRE(outcome.dimension == 2);
  CHECK(outcome.triangles == expected);
  CHECK(outcome.vertices == vertices_of(expected));
  // |(x, y, x + y)|^2 - w' = |(x, y)|^2 - w: the same heights over a slanted plane.
  for (WeightedPoint& s : sites) {
    s.position.z = s.position.x + s.position.y;
    s.weight += s.position.z * s.position.z;
  }
  CHECK(triangulate(sites) == outcome);
}

void check_order_independent(Sites sites) {
  const Outcome outcome = triangulate(sites);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    std::mt19937_64 random(seed);
    std::shuffle(sites.begin(), sites.end(), random);
    CHECK(triangulate(sites) == outcome);
  }
}

/// Equal weights at all points: the Delaunay triangulation.
void check_equal_weights(const std::vector<LatticePoint>& points, double weight) {
  Sites sites = site_sets::weighted(points, 1, 0);
  for (WeightedPoint& s : sites) s.weight = weight;
  const LatticePredicates3 predicates(points);
  Delaunay3 delaunay(predicates);
  delaunay.build();
  CHECK(triangulate(sites).tets ==
        point_sets::by_rank(delaunay.tet_mesh().vertices, point_sets::ranks(points)));
}

}  // namespace

TEST_CASE("tetrahedra are those of the perturbed lower hull") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    check_against_definition(site_sets::weighted(point_sets::random_cube(12, 1000, seed), 200000, seed));
    check_against_definition(site_sets::weighted(point_sets::random_cube(12, 3, seed), 4, seed));
    check_against_definition(site_sets::weighted(point_sets::random_cube(12, 4, seed), 3, seed));
    check_against_definition(site_sets::weighted(point_sets::on_planes(2, 6, 4, 3, seed), 5, seed));
    check_against_definition(site_sets::weighted(point_sets::grid(2, 2, 3), 3, seed));
    check_against_definition(site_sets::weighted(point_sets::sphere(2), 2, seed));
    check_against_definition(site_sets::weighted(point_sets::sphere(3), 8, seed));
  }
}

TEST_CASE("sites exactly on the lower hull are vertices, whatever the order") {
  // Weights |x|^2: all lifted sites on one hyperplane.
  Sites sites = site_sets::weighted(point_sets::grid(2, 3, 2), 1, 0);
  for (WeightedPoint& s : sites) s.weight = dot(s.position, s.position);
  check_against_definition(sites);
  Sites many = site_sets::weighted(point_sets::grid(4, 4, 5), 1, 0);
  for (WeightedPoint& s : many) s.weight = dot(s.position, s.position) + 3 * s.position.x;
  CHECK(triangulate(many).vertices.size() == many.size());
  check_order_independent(many);
}

TEST_CASE("coplanar sites get the triangles of the perturbed lower hull") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    check_plane_against_definition(
        site_sets::weighted(point_sets::random_cube(14, 1000, seed), 100000, seed));
    check_plane_against_definition(site_sets::weighted(point_sets::random_cube(14, 4, seed), 3, seed));
    check_plane_against_definition(site_sets::weighted(point_sets::grid(4, 4, 1), 3, seed));
  }
}

TEST_CASE("planes along every axis") {
  const Sites flat = site_sets::weighted(point_sets::grid(6, 7, 1), 4, 3);
  const Outcome outcome = triangulate(flat);
  REQUIRE(outcome.dimension == 2);
  for (int axis = 0; axis < 2; ++axis) {
    Sites turned = flat;
    for (WeightedPoint& s : turned) {
      const Vec3 p = s.position;  // ranks stay as they are
      s.position = axis == 0 ? Vec3{0, p.x, p.y} : Vec3{p.x, 0, p.y};
    }
    CHECK(triangulate(turned) == outcome);
  }
}

TEST_CASE("collinear sites become a convex chain") {
  // Along x with weights w: heights x^2 - w.
  const auto chain = [](const std::vector<double>& heights, Vec3 step) {
    Sites sites;
    for (std::size_t k = 0; k < heights.size(); ++k) {
      const Vec3 p = static_cast<double>(k) * step;
      sites.push_back({p, dot(p, p) - heights[k]});
    }
    const Outcome outcome = triangulate(sites);
    CHECK(outcome.dimension == 1);
    return outcome.chain;
  };
  using Chain = std::vector<std::uint32_t>;
  CHECK(chain({0, 1}, {1, 2, 3}) == Chain{0, 1});
  CHECK(chain({0, 1, 0}, {1, 2, 3}) == Chain{0, 2});
  CHECK(chain({0, 0, 0}, {1, 2, 3}) == Chain{0, 1, 2});  // on the hull
  CHECK(chain({0, -1, 0}, {0, 0, 3}) == Chain{0, 1, 2});
  CHECK(chain({0, 5, 5, 5, 4, 5, 0}, {0, 2, -1}) == Chain{0, 6});
  CHECK(chain({9, 4, 3, 0, 3, 4, 9}, {1, 0, 0}) == Chain{0, 1, 3, 5, 6});
}

TEST_CASE("a chain equals the definition, duplicates and all") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    Sites sites;
    for (int k = 0; k < 20; ++k) {
      const auto t = static_cast<double>(random() % 12);
      sites.push_back({{t, -2 * t, t}, static_cast<double>(random() % 8)});
    }
    const Outcome outcome = triangulate(sites);
    Sites on_axis = site_sets::sorted_heaviest(sites);
    for (WeightedPoint& s : on_axis) {
      s.weight -= 5 * s.position.x * s.position.x;
      s.position.y = s.position.z = 0;
    }
    const auto expected =
        brute_force::Lifted<1>(site_sets::positions(on_axis), site_sets::weights(on_axis)).triangulate();
    CHECK(outcome.vertices == vertices_of(expected));
    CHECK(outcome.chain.size() == expected.size() + 1);
    check_order_independent(sites);
  }
}

TEST_CASE("with a site of a chain its equals are hidden") {
  const Sites sites = {{{0, 0, 0}, 0}, {{1, 0, 0}, -10}, {{1, 0, 0}, -10}, {{2, 0, 0}, 0}};
  const Outcome outcome = triangulate(sites);
  CHECK(outcome.chain == std::vector<std::uint32_t>{0, 2});
  CHECK(regular_triangulation(sites).kept == std::vector<std::uint32_t>{0, kNone, kNone, 3});
  std::vector<std::uint32_t> kept;
  const WeightedPredicates3 predicates(sites);
  const std::vector<std::uint32_t> chain = detail::lower_chain(predicates, kept);
  CHECK(detail::verify_chain(predicates, chain, kept) == "");
  kept[2] = 1;
  CHECK(detail::verify_chain(predicates, chain, kept) == "a site stands for a hidden one");
}

TEST_CASE("one place, no place") {
  CHECK(triangulate({}).dimension == -1);
  CHECK(triangulate({{{1, 2, 3}, -5}}).chain == std::vector<std::uint32_t>{0});
  const Sites sites = {{{1, 2, 3}, 1}, {{1, 2, 3}, 7}, {{1, 2, 3}, 7}, {{1, 2, 3}, 2}};
  const WeightedPredicates3 predicates(sites);
  Regular3 triangulation(predicates);
  triangulation.build();
  CHECK(triangulation.dimension() == 0);
  CHECK(triangulation.kept(0) == kNone);
  CHECK(triangulation.kept(1) == 1);
  CHECK(triangulation.kept(2) == 1);
  CHECK(triangulation.kept(3) == kNone);
  CHECK(triangulation.verify() == "");
}

TEST_CASE("the triangulation is a function of the set of sites") {
  check_order_independent(site_sets::weighted(point_sets::random_cube(400, 1000, 1), 30000, 1));
  check_order_independent(site_sets::weighted(point_sets::random_cube(300, 6, 2), 4, 2));
  check_order_independent(site_sets::weighted(point_sets::random_cube(1000, 6, 3), 40, 3));
  check_order_independent(site_sets::weighted(point_sets::grid(5, 6, 4), 2, 4));
  check_order_independent(site_sets::weighted(point_sets::grid(5, 6, 4), 20, 4));
  check_order_independent(site_sets::weighted(point_sets::sphere(81), 9, 5));
  check_order_independent(site_sets::weighted(point_sets::on_planes(4, 80, 30, 7, 6), 50, 6));
  check_order_independent(site_sets::weighted(point_sets::on_cube_faces(6, 3, 60, 7), 6, 7));
  check_order_independent(site_sets::weighted(point_sets::grid(9, 8, 1), 5, 8));
}

TEST_CASE("equal weights give the Delaunay triangulation") {
  check_equal_weights(point_sets::random_cube(300, 1000, 1), 0);
  check_equal_weights(point_sets::random_cube(300, 1000, 1), -1e9);
  check_equal_weights(point_sets::grid(5, 4, 6), 7);
  check_equal_weights(point_sets::sphere(81), 1);
  check_equal_weights(point_sets::random_cube(500, 5, 2), 3);
}

TEST_CASE("one heavy site hides all inside the hull, heavy corners even those on it") {
  Sites sites = site_sets::weighted(point_sets::grid(6, 6, 6), 1, 0);
  sites.push_back({{2, 3, 3}, 1e6});
  const Outcome outcome = triangulate(sites);
  CHECK(outcome.vertices.size() == 216 - 64 + 1);  // the grid's surface and the heavy site
  CHECK(outcome.tets.size() == 6 * 25 * 2);
  // Last of all, it hides 64 vertices at once.
  const WeightedPredicates3 predicates(sites);
  Regular3 in_order(predicates);
  in_order.build_in_given_order();
  CHECK(in_order.verify() == "");
  CHECK(point_sets::by_rank(in_order.tet_mesh().vertices, point_sets::ranks(site_sets::positions(sites))) ==
        outcome.tets);
  check_order_independent(sites);
  for (WeightedPoint& s : sites) s.weight = 0;
  for (const double x : {0, 5})
    for (const double y : {0, 5})
      for (const double z : {0, 5}) sites.push_back({{x, y, z}, 1000});
  CHECK(triangulate(sites).vertices.size() == 8);
  check_order_independent(sites);
}

TEST_CASE("of sites in one place the heaviest is the vertex, of equal ones the lowest index") {
  const auto points = point_sets::random_cube(600, 5, 6);
  const Sites sites = site_sets::weighted(points, 3, 6);
  const WeightedPredicates3 predicates(sites);
  Regular3 triangulation(predicates);
  triangulation.build();
  REQUIRE(triangulation.verify() == "");
  std::size_t hidden = 0;
  for (std::uint32_t i = 0; i < sites.size(); ++i) {
    std::uint32_t best = i;
    for (std::uint32_t j = 0; j < sites.size(); ++j)
      if (sites[j].position == sites[i].position &&
          (sites[j].weight > sites[best].weight || (sites[j].weight == sites[best].weight && j < best)))
        best = j;
    const std::uint32_t k = triangulation.kept(i);
    hidden += k == kNone;
    if (k != kNone) CHECK(k == best);
    if (sites[best].weight > sites[i].weight) CHECK(k == kNone);
    CHECK((k == kNone) == (sites[best].weight > sites[i].weight || !triangulation.is_vertex(best)));
  }
  CHECK(hidden > 100);
}

TEST_CASE("weights and coordinates at the ends of the doubles") {
  // Times 2^-500, the weights times 2^-1000: the filter gives up, the integers don't.
  const Sites sites = site_sets::weighted(point_sets::random_cube(60, 20, 9), 60, 9);
  const Outcome outcome = triangulate(sites);
  for (const double scale : {0x1p-500, 0x1p+500}) {
    Sites scaled = sites;
    for (WeightedPoint& s : scaled) s = {scale * s.position, scale * scale * s.weight};
    const WeightedPredicates3 predicates(scaled);
    Regular3 triangulation(predicates);
    triangulation.build();
    CHECK(triangulation.verify() == "");
    CHECK(point_sets::by_rank(triangulation.tet_mesh().vertices,
                              point_sets::ranks(site_sets::positions(sites))) == outcome.tets);
  }
}
