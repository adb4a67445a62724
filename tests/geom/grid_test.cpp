#include "../../geom/grid.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace crossloft;

namespace {

LatticePoint at(const LatticeVector& v) { return make_point(v); }

}  // namespace

TEST_CASE("the grid brings the box to at most 2^48 and no less than a quarter of it") {
  for (const double size : {1e-300, 1e-12, 1.0, 3.0, 1e12, 1e300}) {
    CAPTURE(size);
    const WorldGrid grid({-size, 0, 0}, {size, size, 0});
    const LatticeVector low = grid.to_lattice({-size, 0, 0}), high = grid.to_lattice({size, size, 0});
    CHECK(high[0] <= std::int64_t{1} << 48);
    CHECK(high[0] > std::int64_t{1} << 46);
    CHECK(low[0] == -high[0]);
    CHECK(grid.exact());
  }
}

TEST_CASE("lattice points come back from input coordinates unchanged") {
  std::mt19937_64 random(7);
  for (const double centre : {0.0, 1.0, -20.0}) {
    const WorldGrid grid({centre - 1, -1, -1}, {centre + 1, 1, 1});
    REQUIRE(grid.exact());
    for (int i = 0; i < 1000; ++i) {
      LatticeVector v;
      for (auto& c : v) c = static_cast<std::int64_t>(random() >> 13) - (std::int64_t{1} << 50);
      CHECK(grid.to_lattice(grid.from_lattice(at(v))) == v);
    }
  }
}

TEST_CASE("dyadic input is on the lattice") {
  const WorldGrid grid({0, 0, 0}, {1, 1, 1});
  for (const Vec3 v : {Vec3{0.25, 0.5, 0.75}, Vec3{1, 0, 0.0009765625}})
    CHECK(grid.from_lattice(at(grid.to_lattice(v))) == v);
}

TEST_CASE("far from the origin the grid says that it rounds") {
  CHECK(WorldGrid({20, 0, 0}, {22, 2, 2}).exact());
  CHECK_FALSE(WorldGrid({1e6, 0, 0}, {1e6 + 1, 1, 1}).exact());
  const WorldGrid grid({1e12, 0, 0}, {1e12 + 1, 1, 1});
  CHECK(grid.from_lattice(at(grid.to_lattice({1e12 + 0.5, 0.5, 1}))) == Vec3{1e12 + 0.5, 0.5, 1});
}

TEST_CASE("the box may be a point") {
  const WorldGrid grid({3, 3, 3}, {3, 3, 3});
  CHECK(grid.to_lattice({3, 3, 3}) == LatticeVector{0, 0, 0});
}

TEST_CASE("a box of the smallest doubles has a grid finer than the doubles") {
  constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
  CHECK(WorldGrid({-kSmallest, 0, 0}, {kSmallest, 0, 0}).unit() == 0);
  CHECK(WorldGrid({0, 0, 0}, {kSmallest, 0, 0}).unit() == 0);
}

TEST_CASE("at the end of the doubles lattice points beyond the box have no coordinates") {
  const WorldGrid grid({-1e308, 0, 0}, {1e308, 1, 1});
  CHECK_FALSE(grid.exact());
  CHECK(grid.from_lattice(at(grid.to_lattice({1e308, 0, 0}))).x == doctest::Approx(1e308));
  CHECK(WorldGrid({-1e306, 0, 0}, {1e306, 1, 1}).exact());
}

TEST_CASE("halves are rounded upwards, and nothing else is") {
  const WorldGrid grid;
  CHECK(grid.to_lattice({0.49999999999999994, 0.5, -0.5}) == LatticeVector{0, 1, 0});
  CHECK(grid.to_lattice({-0.50000000000000011, 1.5, -1e-300}) == LatticeVector{-1, 2, 0});
}
