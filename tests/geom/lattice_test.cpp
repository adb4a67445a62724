#include "../../geom/lattice.h"

#include <doctest/doctest.h>

#include <cmath>

#include "lattice_samples.h"
#include "rational_reference.h"

using namespace crossloft;
using reference::exact;
using samples::Generator;

TEST_CASE("three planes meet on all of them") {
  LatticePointStore store;
  LatticePoint p;
  const LatticePlane a = make_lattice_plane({0, 0, 0}, {1, 2, 3}, {3, -1, 7});
  const LatticePlane b = make_lattice_plane({5, 1, 2}, {1, 5, -3}, {2, 2, 9});
  const LatticePlane c = make_axis_plane(2, 11);
  REQUIRE(store.meet(a, b, c, p));
  CHECK(side_of_plane(a, p) == 0);
  CHECK(side_of_plane(b, p) == 0);
  CHECK(side_of_plane(c, p) == 0);
  CHECK(p.z == 11);
  CHECK_FALSE(p.is_explicit());
}

TEST_CASE("met points lie on their planes, rounded to nearest, in lowest terms") {
  Generator generator(20260606);
  LatticePointStore store;
  for (const std::int64_t normals : {std::int64_t{8}, std::int64_t{1} << 28, kNormalLimit})
    for (int round = 0; round < 200; ++round) {
      const auto plane = [&] { return generator.plane(normals, kLatticeLimit / 8); };
      const LatticePlane a = plane(), b = plane(), c = plane();
      LatticePoint p, again;
      if (!store.meet(a, b, c, p)) continue;
      const auto truth = exact(p);
      for (const LatticePlane* q : {&a, &b, &c}) CHECK(reference::side(*q, truth) == 0);
      for (int k = 0; k < 3; ++k) {
        const mpq_class& t = truth[static_cast<std::size_t>(k)];
        const mpq_class error = abs(mpq_class(mpq_class(p[k]) - t));
        CHECK(error <= abs(mpq_class(mpq_class(std::nextafter(p[k], 1e300)) - t)));
        CHECK(error <= abs(mpq_class(mpq_class(std::nextafter(p[k], -1e300)) - t)));
        CHECK(error <= mpq_class(1, 16));
      }
      REQUIRE(store.meet(c, a, b, again));
      CHECK(again.exact == p.exact);
      if (p.is_explicit()) continue;
      mpz_class common = reference::integer(p.exact->w);
      for (const auto* v : {&p.exact->x, &p.exact->y, &p.exact->z})
        common = gcd(common, reference::integer(*v));
      CHECK(common == 1);
    }
}

TEST_CASE("the largest weights and coordinates that the limits allow") {
  // Normals near (1,1,-1), (1,-1,1), (-1,1,1) times 2^40: the largest determinant, close to 4 * 2^120.
  const std::int64_t m = kNormalLimit, far = kLatticeLimit;
  std::array<LatticePlane, 3> p;
  p[0].normal = {m, m - 1, -m}, p[1].normal = {m, -m, m - 3}, p[2].normal = {5 - m, m, m};
  for (LatticePlane& plane : p) plane.origin = {far - 4, far - 4, 4 - far};
  p[0].origin[0] -= 1, p[1].origin[1] -= 1, p[2].origin[2] += 1;
  LatticePointStore store;
  LatticePoint v;
  REQUIRE(store.meet(p[0], p[1], p[2], v));
  CHECK_FALSE(v.is_explicit());
  CHECK(mpz_sizeinbase(reference::integer(v.exact->w).get_mpz_t(), 2) == 122);
  for (const LatticePlane& plane : p) CHECK(side_of_plane(plane, v) == 0);
  const LatticePoint a = make_point({-far, -far, far}), b = make_point({far, -far, far}),
                     c = make_point({-far, far, -far}), d = make_point({far, far, far});
  CHECK(orient3d(a, b, c, v) == reference::orient3d(exact(a), exact(b), exact(c), exact(v)));
  CHECK(insphere(a, b, c, d, v) == reference::insphere(exact(a), exact(b), exact(c), exact(d), exact(v)));
  CHECK(insphere(v, a, b, c, d) == reference::insphere(exact(v), exact(a), exact(b), exact(c), exact(d)));
}

TEST_CASE("no common point, one at the border, one beyond it") {
  LatticePointStore store;
  LatticePoint p;
  const LatticePlane x = make_axis_plane(0, kLatticeLimit), y = make_axis_plane(1, -kLatticeLimit);
  CHECK_FALSE(store.meet(x, y, make_axis_plane(0, 3), p));
  REQUIRE(store.meet(x, y, make_axis_plane(2, 7), p));
  CHECK(p.is_explicit());
  CHECK(equal(p, make_point({kLatticeLimit, -kLatticeLimit, 7})));
  // x + y + 2 z = 3 - 2^50: integral at odd x, half a unit off at even x.
  const LatticePlane tilted = make_lattice_plane({0, 3 - kLatticeLimit, 0}, {2, 0, -1}, {-1, 1, 0});
  REQUIRE(tilted.normal == LatticeVector{1, 1, 2});
  const auto at_x = [&](std::int64_t v) {
    return store.meet(make_axis_plane(0, v), make_axis_plane(1, 0), tilted, p);
  };
  CHECK(at_x(kLatticeLimit - 1));
  CHECK(p.is_explicit());
  CHECK(at_x(kLatticeLimit));
  CHECK_FALSE(p.is_explicit());
  const LatticePlane steep =
      make_lattice_plane({0, 0, kLatticeLimit}, {2, 0, 1}, {0, 1, 0});  // 2 z - x = 2^51
  CHECK_FALSE(store.meet(make_axis_plane(0, 1), make_axis_plane(1, 0), steep, p));
  CHECK(store.meet(make_axis_plane(0, 0), make_axis_plane(1, 0), steep, p));
  CHECK(store.meet(make_axis_plane(0, -1), make_axis_plane(1, 0), steep, p));
}

TEST_CASE("equality and order across kinds and stores") {
  LatticePointStore one, two;
  LatticePoint p, q;
  const LatticePlane half = make_lattice_plane({0, 0, 0}, {1, 1, 0}, {1, 0, 2});  // 2x - 2y - z = 0
  REQUIRE(one.meet(make_axis_plane(0, 0), make_axis_plane(2, 1), half, p));
  REQUIRE(two.meet(half, make_axis_plane(2, 1), make_axis_plane(0, 0), q));
  CHECK_FALSE(p.is_explicit());
  CHECK(p.exact != q.exact);
  CHECK(equal(p, q));
  CHECK(compare_lex(p, make_point({0, 0, 0})) == -1);
  CHECK(compare_lex(make_point({0, -1, 5}), p) == -1);
}
