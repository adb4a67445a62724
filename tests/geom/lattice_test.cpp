#include "../../geom/lattice.h"

#include <doctest/doctest.h>

using namespace crossloft;

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
