#include "../../reconstruct/roofs.h"

#include <doctest/doctest.h>

#include <random>

#include "../../geom/tetrahedron_meeting.h"
#include "../../reconstruct/glue.h"

using namespace crossloft;

namespace {

using Tet = std::array<std::uint32_t, 4>;

/// A fan of triangles around vertex 0 in the plane z = 0, in the cell above it.
struct Scene {
  std::vector<LatticePoint> points;
  std::vector<FlatTriangle> triangles;
  RoofSite site;

  explicit Scene(const std::vector<LatticeVector>& ring, std::int64_t height) {
    points.push_back(make_point({0, 0, 0}));
    for (const LatticeVector& p : ring) points.push_back(make_point(p));
    const auto n = static_cast<std::uint32_t>(ring.size());
    for (std::uint32_t i = 0; i < n; ++i) triangles.push_back({3, {0, 1 + i, 1 + (i + 1) % n}});
    site.height = static_cast<double>(height);
    site.sides = {{make_axis_plane(2, 0), 1}, {make_axis_plane(2, 1000), -1}};
  }
  CellRoofs build() {
    site.points = points, site.triangles = triangles;
    const CellRoofs roofs = build_roofs(site);
    check(roofs);
    return roofs;
  }
  LatticeTet corners(const CellRoofs& r, const Tet& t) const {
    LatticeTet c;
    for (std::size_t i = 0; i < 4; ++i)
      c[i] = t[i] < kFirstRaisedPoint ? points[t[i]] : r.points[t[i] - kFirstRaisedPoint];
    return c;
  }
  /// What every result keeps.
  void check(const CellRoofs& r) const {
    REQUIRE(r.built.size() == triangles.size());
    std::vector<LatticeTet> all;
    std::vector<Tet> numbers;
    for (Tet t : r.tets) {
      all.push_back(corners(r, t));
      for (std::uint32_t& v : t)
        if (v >= kFirstRaisedPoint) v = v - kFirstRaisedPoint + static_cast<std::uint32_t>(points.size());
      numbers.push_back(t);
      CHECK(orient3d(all.back()[0], all.back()[1], all.back()[2], all.back()[3]) > 0);
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(overlap(all[i], all[j]));
      for (const Tet& o : site.obstacles) CHECK_FALSE(overlap(all[i], corners(r, o)));
      for (std::size_t k = 0; k < 4; ++k)
        if (r.tets[i][k] >= kFirstRaisedPoint)
          for (const CellSide& s : site.sides) CHECK(side_of_plane(s.plane, all[i][k]) == s.side);
    }
    const auto glued = glue(numbers);
    REQUIRE(glued.ok());
    CHECK(verify_surface(static_cast<std::uint32_t>(glued->vertices.size()), glued->triangles));
  }
};

const std::vector<LatticeVector> kSquare{{600, 600, 0}, {-600, 600, 0}, {-600, -600, 0}, {600, -600, 0}};

std::size_t copies(const CellRoofs& r, std::uint32_t offset) {
  std::vector<Tet> numbers = r.tets;
  for (Tet& t : numbers)
    for (std::uint32_t& v : t)
      if (v >= kFirstRaisedPoint) v = v - kFirstRaisedPoint + offset;
  return glue(numbers)->copies;
}

}  // namespace

TEST_CASE("a square gets a plate of one piece, no higher than asked") {
  Scene scene(kSquare, 100);
  const CellRoofs r = scene.build();
  CHECK(r.built == std::vector<std::uint8_t>(4, 1));
  CHECK(r.height == 100);
  CHECK(r.tets.size() == 4 + 4 * 2 + 4 * 2);
  CHECK(copies(r, 5) == 0);
}

TEST_CASE("the far side of the cell keeps it low") {
  Scene scene(kSquare, 3000);
  CHECK(scene.build().height == 750);
}

TEST_CASE("solid above it keeps it low where it is, and at the vertex it stands on leaves a pit") {
  Scene scene(kSquare, 400);
  scene.points.push_back(make_point({100, 50, 900}));
  scene.points.push_back(make_point({200, 400, 900}));
  scene.points.push_back(make_point({-100, 100, 900}));
  scene.points.push_back(make_point({60, 80, 30}));
  scene.site.obstacles = {{7, 5, 6, 8}};
  const CellRoofs hanging = scene.build();
  CHECK(hanging.built == std::vector<std::uint8_t>(4, 1));
  CHECK(copies(hanging, 9) == 0);
  scene.site.obstacles = {{5, 6, 7, 0}};
  const CellRoofs standing = scene.build();
  CHECK(standing.built == std::vector<std::uint8_t>(4, 1));
  CHECK(standing.tets.size() < hanging.tets.size());
}

// Points came down by half in 24 rounds at most, which ended far above it.
TEST_CASE("a plate gets under solid that hangs a few units over it") {
  constexpr std::int64_t kFar = std::int64_t{1} << 40;
  Scene scene({{kFar, kFar, 0}, {-kFar, kFar, 0}, {-kFar, -kFar, 0}, {kFar, -kFar, 0}}, kFar);
  scene.site.sides[1] = {make_axis_plane(2, 4 * kFar), -1};
  scene.points.push_back(make_point({-4 * kFar, -4 * kFar, 4}));
  scene.points.push_back(make_point({4 * kFar, -4 * kFar, 4}));
  scene.points.push_back(make_point({0, 4 * kFar, 4}));
  scene.points.push_back(make_point({0, 0, kFar}));
  scene.site.obstacles = {{5, 6, 7, 8}};
  const CellRoofs r = scene.build();
  CHECK(r.built == std::vector<std::uint8_t>(4, 1));
  CHECK(r.height <= 4.5);
}

// Three tetrahedra around its long side lean over the needle, 4.6 units wide: at the lowest place over its middle
// the point was rounded into them.
TEST_CASE("a needle under solid gets a plate where a point rounds into the room there is") {
  Scene scene({}, 522165);
  for (const LatticeVector& p : std::vector<LatticeVector>{{-17592168452226, 35184354496646, -17592168452226},
                                                           {4, 0, 4},
                                                           {-28745179957415, 38116403096235, -53351664793603},
                                                           {-25956927081118, 76965818342367, -62003981150721},
                                                           {-24189249763755, 8796088624162, -37383383799509},
                                                           {-25813142352943, 102621091123155, -56283702398076}})
    scene.points.push_back(make_point(p));
  scene.triangles = {{3, {0, 1, 2}}};
  scene.site.sides = {{make_lattice_plane({0, 0, 0}, {0, 1, 0}, {1, 0, 1}), 1}};
  scene.site.obstacles = {{1, 2, 3, 4}, {5, 2, 3, 1}, {1, 2, 4, 6}};
  const CellRoofs r = scene.build();
  CHECK(r.built == std::vector<std::uint8_t>{1});
  CHECK(r.height <= 2);
}

// Two tetrahedra around the long sides lean over the needle by 1e-5; where a grid point has room under them it
// is 100 units beside the needle.
TEST_CASE("a needle under solid that leans by less than the grid gets a plate up to a corner of it") {
  Scene scene({{1000000, 0, 0}, {500000, 2, 0}}, 50);
  scene.triangles = {{3, {0, 1, 2}}};
  scene.points.push_back(make_point({500000, -1000000, 10}));
  scene.points.push_back(make_point({500000, 0, 1000000}));
  scene.site.sides[1] = {make_axis_plane(2, 2000000), -1};
  scene.site.obstacles = {{2, 1, 3, 4}, {0, 2, 3, 4}};
  const CellRoofs r = scene.build();
  CHECK(r.built == std::vector<std::uint8_t>{1});
  CHECK(r.tets == std::vector<Tet>{{0, 1, 2, 3}});
  CHECK(r.height == 10);
  scene.site.height = 9;  // the corner is higher than a plate may be
  const CellRoofs low = scene.build();
  CHECK(low.built == std::vector<std::uint8_t>{1});
  CHECK(low.height <= 2);
}

TEST_CASE("what is blocked altogether is left out, the rest is built") {
  Scene scene(kSquare, 100);
  scene.points.push_back(make_point({0, 0, 500}));
  scene.site.obstacles = {{0, 1, 2, 5}};  // stands on the first triangle
  const CellRoofs r = scene.build();
  CHECK(r.built == std::vector<std::uint8_t>{0, 1, 1, 1});
}

TEST_CASE("random stars, also of a few units") {
  std::mt19937_64 random(5);
  MESSAGE("seed 5");
  std::size_t built = 0, all = 0;
  for (int run = 0; run < 60; ++run) {
    const std::int64_t size = run % 3 == 0 ? 6 : run % 3 == 1 ? 60 : 100000;
    std::vector<LatticeVector> ring;
    for (const LatticeVector& d : std::vector<LatticeVector>{
             {3, 0, 0}, {2, 2, 0}, {0, 3, 0}, {-2, 2, 0}, {-3, 0, 0}, {-1, -3, 0}, {2, -2, 0}})
      if (random() % 4 != 0) {
        const std::int64_t f = size * (1 + static_cast<std::int64_t>(random() % 9)) / 6;
        ring.push_back({d[0] * f, d[1] * f, 0});
      }
    bool turns = ring.size() >= 3;
    for (std::size_t i = 0; turns && i < ring.size(); ++i) {
      const LatticeVector &a = ring[i], &b = ring[(i + 1) % ring.size()];
      turns = a[0] * b[1] - a[1] * b[0] > 0;
    }
    if (!turns) continue;
    Scene scene(ring, size / 3);
    for (const std::uint8_t b : scene.build().built) built += b, ++all;
  }
  CHECK(all > 100);
  CHECK(built == all);
}
