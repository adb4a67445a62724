// CGAL's filtered and exact kernels as an independent referee, on points and conventions stated in
// predicates.h.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <doctest/doctest.h>

#include "../../geom/predicates.h"
#include "lattice_samples.h"

using namespace crossloft;
using samples::Generator;

namespace {

constexpr std::uint64_t kSeed = 20260505;

template <class Kernel>
struct Referee {
  using P3 = typename Kernel::Point_3;
  using P2 = typename Kernel::Point_2;
  static P3 point(Vec3 p) { return P3(p.x, p.y, p.z); }
  static P2 flat(Vec3 p) { return P2(p.x, p.y); }

  static void check(const std::array<Vec3, 5>& p) {
    const auto& [a, b, c, d, e] = p;
    const auto xy = [](Vec3 v) { return Vec2{v.x, v.y}; };
    CHECK(orient3d(a, b, c, d) == CGAL::orientation(point(a), point(b), point(c), point(d)));
    CHECK(orient2d(xy(a), xy(b), xy(c)) == CGAL::orientation(flat(a), flat(b), flat(c)));
    if (orient3d(a, b, c, d) != 0)
      CHECK(insphere(a, b, c, d, e) ==
            CGAL::side_of_oriented_sphere(point(a), point(b), point(c), point(d), point(e)));
    if (orient2d(xy(a), xy(b), xy(c)) != 0)
      CHECK(incircle(xy(a), xy(b), xy(c), xy(d)) ==
            CGAL::side_of_oriented_circle(flat(a), flat(b), flat(c), flat(d)));
  }
};

void check(const std::array<Vec3, 5>& p) {
  Referee<CGAL::Exact_predicates_inexact_constructions_kernel>::check(p);
  Referee<CGAL::Exact_predicates_exact_constructions_kernel>::check(p);
}

LatticePoint lattice(Vec3 p) { return {p.x, p.y, p.z, nullptr}; }

}  // namespace

TEST_CASE("doubles in the unit cube and on a grid of tenths") {
  MESSAGE("seed " << kSeed);
  Generator generator(kSeed);
  for (int round = 0; round < 500; ++round) {
    std::array<Vec3, 5> random, grid;
    const auto unit = [&] { return static_cast<double>(generator.integer(kLatticeLimit)) * 0x1p-50; };
    const auto tenth = [&] { return static_cast<double>(generator.integer(2)) / 10; };
    for (Vec3& v : random) v = {unit(), unit(), unit()};
    for (Vec3& v : grid) v = {tenth(), tenth(), tenth()};
    check(random);
    check(grid);
  }
}

TEST_CASE("cospherical lattice points, through both interfaces") {
  Generator generator(kSeed + 1);
  const auto sphere = samples::cospherical({1, 2, 3}, 1);
  for (int round = 0; round < 500; ++round) {
    std::array<Vec3, 5> p;
    for (Vec3& v : p) {
      const LatticePoint& q = sphere[generator.index(sphere.size())];
      v = {q.x, q.y, q.z};
    }
    if (generator.chance(50)) p[generator.index(5)].x += 1;
    check(p);
    CHECK(orient3d(lattice(p[0]), lattice(p[1]), lattice(p[2]), lattice(p[3])) ==
          orient3d(p[0], p[1], p[2], p[3]));
    CHECK(insphere(lattice(p[0]), lattice(p[1]), lattice(p[2]), lattice(p[3]), lattice(p[4])) ==
          insphere(p[0], p[1], p[2], p[3], p[4]));
  }
}
