// The lattice predicates against rational arithmetic: every kind of point, every size, degenerate sets, sign
// laws, and the filters against the exact stage.

#include <doctest/doctest.h>

#include "../../geom/lattice_filters.h"
#include "lattice_samples.h"
#include "rational_reference.h"

using namespace crossloft;
using reference::exact;
using samples::Generator;

namespace {

constexpr std::uint64_t kSeed = 20260101;

/// A filter may be silent, never wrong; the exact stage and the predicate always say the same.
void check_stages(int expected, int filter, int exact_stage, int answer) {
  CHECK(answer == expected);
  CHECK(exact_stage == expected);
  CHECK((filter == 0 || filter == expected));
}

void check_orient3d(const std::array<LatticePoint, 5>& p) {
  const int expected = reference::orient3d(exact(p[0]), exact(p[1]), exact(p[2]), exact(p[3]));
  check_stages(expected, orient3d_filter(p[0], p[1], p[2], p[3]), orient3d_exact(p[0], p[1], p[2], p[3]),
               orient3d(p[0], p[1], p[2], p[3]));
}

void check_insphere(const std::array<LatticePoint, 5>& p) {
  const int expected = reference::insphere(exact(p[0]), exact(p[1]), exact(p[2]), exact(p[3]), exact(p[4]));
  check_stages(expected, insphere_filter(p[0], p[1], p[2], p[3], p[4]),
               insphere_exact(p[0], p[1], p[2], p[3], p[4]), insphere(p[0], p[1], p[2], p[3], p[4]));
}

void check_on_plane(const LatticePlane& plane, const std::array<LatticePoint, 4>& p) {
  const auto n = exact(plane.normal);
  check_stages(reference::orient2d(n, exact(p[0]), exact(p[1]), exact(p[2])),
               orient2d_filter(plane, p[0], p[1], p[2]), orient2d_exact(plane, p[0], p[1], p[2]),
               orient2d(plane, p[0], p[1], p[2]));
  check_stages(reference::incircle(n, exact(p[0]), exact(p[1]), exact(p[2]), exact(p[3])),
               incircle_filter(plane, p[0], p[1], p[2], p[3]), incircle_exact(plane, p[0], p[1], p[2], p[3]),
               incircle(plane, p[0], p[1], p[2], p[3]));
}

LatticePoint moved(const LatticePoint& p, const LatticeVector& by) {
  const LatticeVector c = to_vector(p);
  return make_point({c[0] + by[0], c[1] + by[1], c[2] + by[2]});
}

/// A point of the plane: explicit, or its common point with two others.
LatticePoint point_on(const LatticePlane& plane, Generator& generator, LatticePointStore& store,
                      std::int64_t normal_limit, std::int64_t coordinate_limit) {
  for (;;) {
    if (generator.chance(60)) {
      const std::int64_t u = generator.integer(1 << 12), v = generator.integer(1 << 12);
      LatticeVector c;
      for (std::size_t k = 0; k < 3; ++k) c[k] = plane.origin[k] + u * plane.e1[k] + v * plane.e2[k];
      return make_point(c);
    }
    LatticePoint p;
    const LatticePlane other = generator.plane(normal_limit, coordinate_limit);
    const LatticePlane third = generator.chance(50) ? generator.plane(normal_limit, coordinate_limit)
                                                    : make_axis_plane(static_cast<int>(generator.index(3)),
                                                                      generator.integer(coordinate_limit));
    if (store.meet(plane, other, third, p)) return p;
  }
}

}  // namespace

TEST_CASE("random points of all kinds and sizes") {
  MESSAGE("seed " << kSeed);
  Generator generator(kSeed);
  LatticePointStore store;
  for (const std::int64_t coordinates : {std::int64_t{4}, std::int64_t{1} << 20, kLatticeLimit})
    for (const std::int64_t normals : {std::int64_t{8}, std::int64_t{1} << 28, kNormalLimit})
      for (const unsigned rational : {0u, 30u, 100u})
        for (int round = 0; round < 60; ++round) {
          std::array<LatticePoint, 5> p;
          for (LatticePoint& q : p) q = generator.point(store, normals, coordinates, rational);
          check_orient3d(p);
          check_insphere(p);
          const LatticePlane plane = generator.plane(normals, coordinates);
          check_stages(reference::side(plane, exact(p[0])), side_of_plane_filter(plane, p[0]),
                       side_of_plane_exact(plane, p[0]), side_of_plane(plane, p[0]));
        }
}

TEST_CASE("every number of rational points in every place") {
  Generator generator(kSeed + 1);
  LatticePointStore store;
  for (unsigned mask = 0; mask < 32; ++mask)
    for (int round = 0; round < 8; ++round) {
      std::array<LatticePoint, 5> p;
      for (std::size_t i = 0; i < 5; ++i)
        p[i] = generator.point(store, kNormalLimit, kLatticeLimit, (mask >> i & 1u) != 0 ? 100 : 0);
      check_orient3d(p);
      check_insphere(p);
      p[4] = p[generator.index(4)];
      check_insphere(p);
      p[3] = p[generator.index(3)];
      check_orient3d(p);
    }
}

TEST_CASE("points on a plane, and one off it") {
  Generator generator(kSeed + 2);
  LatticePointStore store;
  for (const std::int64_t normals : {std::int64_t{8}, std::int64_t{1} << 28, kNormalLimit})
    for (int round = 0; round < 200; ++round) {
      const LatticePlane plane = generator.plane(normals, kLatticeLimit / 2);
      std::array<LatticePoint, 5> p;
      for (LatticePoint& q : p) q = point_on(plane, generator, store, normals, kLatticeLimit / 2);
      for (const LatticePoint& q : p) REQUIRE(side_of_plane(plane, q) == 0);
      CHECK(orient3d(p[0], p[1], p[2], p[3]) == 0);
      CHECK(insphere(p[0], p[1], p[2], p[3], p[4]) == 0);
      check_on_plane(plane, {p[0], p[1], p[2], p[3]});
      check_on_plane(plane, {p[0], p[1], p[0], p[3]});
      for (LatticePoint& q : p) {
        if (!q.is_explicit()) continue;
        LatticeVector by{};
        by[generator.index(3)] = generator.chance(50) ? 1 : -1;
        q = moved(q, by);
        check_orient3d(p);
        check_insphere(p);
        CHECK(side_of_plane(plane, q) == reference::side(plane, exact(q)));
        break;
      }
    }
}

TEST_CASE("cospherical and concircular points, and one unit off") {
  Generator generator(kSeed + 3);
  for (const std::int64_t scale : {std::int64_t{1}, std::int64_t{1} << 40}) {
    const std::vector<LatticePoint> sphere = samples::cospherical({5, -3, 11}, scale);
    REQUIRE(sphere.size() > 50);
    const auto pick = [&] { return sphere[generator.index(sphere.size())]; };
    for (int round = 0; round < 300; ++round) {
      std::array<LatticePoint, 5> p{pick(), pick(), pick(), pick(), pick()};
      CHECK(insphere(p[0], p[1], p[2], p[3], p[4]) == 0);
      LatticeVector by{};
      by[generator.index(3)] = generator.chance(50) ? 1 : -1;
      LatticePoint& off = p[generator.index(5)];
      off = moved(off, by);
      check_insphere(p);
      check_orient3d(p);
    }
    for (int axis = 0; axis < 3; ++axis)
      for (const LatticePoint& q : sphere) {
        std::vector<LatticePoint> circle;
        for (const LatticePoint& r : sphere)
          if (r[axis] == q[axis]) circle.push_back(r);
        if (circle.size() < 4) continue;
        const LatticePlane plane = make_axis_plane(axis, to_vector(q)[static_cast<std::size_t>(axis)]);
        CHECK(incircle(plane, circle[0], circle[1], circle[2], circle[3]) == 0);
        LatticeVector by{};
        by[static_cast<std::size_t>((axis + 1) % 3)] = 1;
        check_on_plane(plane, {circle[0], moved(circle[1], by), circle[2], circle[3]});
      }
  }
}

TEST_CASE("a small grid: all degeneracies at once") {
  std::vector<LatticePoint> grid;
  for (std::int64_t x = 0; x < 2; ++x)
    for (std::int64_t y = 0; y < 2; ++y)
      for (std::int64_t z = 0; z < 3; ++z) grid.push_back(make_point({x << 48, y << 48, z << 48}));
  Generator generator(kSeed + 4);
  for (int round = 0; round < 3000; ++round) {
    std::array<LatticePoint, 5> p;
    for (LatticePoint& q : p) q = grid[generator.index(grid.size())];
    check_orient3d(p);
    check_insphere(p);
  }
}

TEST_CASE("near ties of rational points within the blur of their rounding") {
  // Three-plane points a fraction of a unit apart: their rounded coordinates lie up to half an ulp off.
  Generator generator(kSeed + 5);
  LatticePointStore store;
  for (int round = 0; round < 200; ++round) {
    const LatticeVector around = generator.vector(kLatticeLimit - 4096);
    std::array<LatticePoint, 5> p;
    for (LatticePoint& q : p) {
      const auto near = [&] {
        LatticePlane plane = generator.plane(kNormalLimit, 4);
        for (std::size_t k = 0; k < 3; ++k) plane.origin[k] += around[k];
        return plane;
      };
      while (!store.meet(near(), near(), near(), q)) {
      }
    }
    check_orient3d(p);
    check_insphere(p);
    for (int axis = 0; axis < 3; ++axis)
      CHECK(compare_axis(axis, p[0], p[1]) == sgn(mpq_class(exact(p[0])[static_cast<std::size_t>(axis)] -
                                                            exact(p[1])[static_cast<std::size_t>(axis)])));
  }
}

TEST_CASE("near ties with a plane at a corner of the lattice: the blur decides") {
  Generator generator(kSeed + 9);
  LatticePointStore store;
  for (int round = 0; round < 4000; ++round) {
    samples::NearPlane near(generator, store);
    std::array<LatticePoint, 5> p;
    for (LatticePoint& q : p) q = near.point();
    check_orient3d(p);
    check_insphere(p);
    std::array<LatticePoint, 4> r;
    for (LatticePoint& q : r) q = near.on_plane();
    check_on_plane(near.plane(), r);
    for (const LatticePoint& q : p)
      CHECK(side_of_plane(near.plane(), q) == reference::side(near.plane(), exact(q)));
  }
}

TEST_CASE("exchanging two points changes every sign") {
  Generator generator(kSeed + 6);
  LatticePointStore store;
  for (int round = 0; round < 200; ++round) {
    std::array<LatticePoint, 5> p;
    for (LatticePoint& q : p) q = generator.point(store, 1 << 20, 64, 40);
    const int orientation = orient3d(p[0], p[1], p[2], p[3]), sphere = insphere(p[0], p[1], p[2], p[3], p[4]);
    for (std::size_t i = 0; i < 5; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        auto q = p;
        std::swap(q[i], q[j]);
        if (i < 4) CHECK(orient3d(q[0], q[1], q[2], q[3]) == -orientation);
        CHECK(insphere(q[0], q[1], q[2], q[3], q[4]) == -sphere);
      }
    CHECK(orient3d(p[1], p[2], p[0], p[3]) == orientation);
  }
}

TEST_CASE("signs on a simplex that one can see") {
  const LatticePoint o = make_point({0, 0, 0}), x = make_point({8, 0, 0}), y = make_point({0, 8, 0}),
                     z = make_point({0, 0, 8});
  CHECK(orient3d(o, x, y, z) == 1);
  CHECK(insphere(o, x, y, z, make_point({1, 1, 1})) == 1);
  CHECK(insphere(o, x, y, z, make_point({8, 8, 8})) == 0);
  CHECK(insphere(o, x, y, z, make_point({9, 9, 9})) == -1);
  for (int axis = 0; axis < 3; ++axis) {
    const std::array<LatticePoint, 3> unit{x, y, z};
    const auto at = [&](int k) { return unit[static_cast<std::size_t>((axis + k) % 3)]; };
    const LatticePlane plane = make_axis_plane(axis, 0);
    CHECK(orient2d(plane, o, at(1), at(2)) == 1);
    LatticeVector in{1, 1, 1}, out{9, 9, 9};
    in[static_cast<std::size_t>(axis)] = out[static_cast<std::size_t>(axis)] = 0;
    CHECK(incircle(plane, o, at(1), at(2), make_point(in)) == 1);
    CHECK(incircle(plane, o, at(1), at(2), make_point(out)) == -1);
  }
}
