#include "../../geom/frame.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "../../geom/lattice_reduction.h"

using namespace crossloft;

namespace {

constexpr std::int64_t kRadius = std::int64_t{1} << 48;
constexpr double kHuge = 281474976710656.0;  // 2^48

Vec3 to_real(const LatticeVector& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}
Vec3 unit(Vec3 v) { return (1 / norm(v)) * v; }
double angle(Vec3 a, Vec3 b) { return norm(cross(unit(a), unit(b))); }

double uniform(std::mt19937_64& random) {
  return static_cast<double>(static_cast<std::int64_t>(random() >> 10)) * 0x1p-53 - 1;
}
Vec3 random_vector(std::mt19937_64& random) { return {uniform(random), uniform(random), uniform(random)}; }
LatticeVector random_point(std::mt19937_64& random) {
  const Vec3 v = kHuge * random_vector(random);
  return {static_cast<std::int64_t>(v.x), static_cast<std::int64_t>(v.y), static_cast<std::int64_t>(v.z)};
}

bool is_primitive(const LatticeVector& v) { return std::gcd(std::gcd(v[0], v[1]), v[2]) == 1; }

void check_frame(const LatticePlane& p) {
  CHECK(cross(p.e1, p.e2) == p.normal);
  CHECK(is_primitive(p.normal));
  for (const std::int64_t c : p.normal) CHECK(std::llabs(c) <= kNormalLimit);
  for (const std::int64_t c : p.origin) CHECK(std::llabs(c) <= kLatticeLimit);
}

double distance(const LatticeVector& a, const LatticeVector& b) { return norm(to_real(a) - to_real(b)); }

}  // namespace

TEST_CASE("a direction does not depend on sign and length") {
  const LatticeVector d = quantise_direction({1, 2, -3});
  CHECK(d == quantise_direction({-1, -2, 3}));
  CHECK(d == quantise_direction({1e300, 2e300, -3e300}));
  CHECK(d == quantise_direction({0x1p-1060, 0x1p-1059, -3 * 0x1p-1060}));
  CHECK(quantise_direction({0, 0, -1e-300}) == LatticeVector{0, 0, std::int64_t{1} << 46});
  CHECK(quantise_direction({0, 3, -3}) == LatticeVector{0, std::int64_t{1} << 46, -(std::int64_t{1} << 46)});
}

TEST_CASE("simple normals are found") {
  for (const LatticeVector n : {LatticeVector{0, 0, 1}, LatticeVector{0, 1, 0}, LatticeVector{1, 0, 0},
                                LatticeVector{1, 1, 0}, LatticeVector{1, -2, 3}, LatticeVector{3, 4, 0},
                                LatticeVector{0, 7, -12}, LatticeVector{101, 103, 107}}) {
    const Vec3 v = to_real(n);
    CHECK(fit_normal(quantise_direction(v), kRadius) == n);
    CHECK(fit_normal(quantise_direction(unit(-v)), kRadius) == n);
    CHECK(fit_normal(quantise_direction((1 / 3.0) * v), kRadius) == n);
  }
}

TEST_CASE("axis planes have unit vectors") {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    LatticeVector n{}, point{5, -6, 7};
    n[axis] = 1;
    const LatticePlane p = plane_through(n, point, {100, 200, 300});
    check_frame(p);
    LatticeVector origin{100, 200, 300};
    origin[axis] = point[axis];
    CHECK(p.origin == origin);
    CHECK(std::llabs(p.e1[0]) + std::llabs(p.e1[1]) + std::llabs(p.e1[2]) == 1);
    CHECK(std::llabs(p.e2[0]) + std::llabs(p.e2[1]) + std::llabs(p.e2[2]) == 1);
    CHECK(snap_to_plane(p, {11, 12, 13})[(axis + 1) % 3] == 11 + static_cast<std::int64_t>((axis + 1) % 3));
  }
}

TEST_CASE("random planes: tilt and mesh in balance") {
  std::mt19937_64 random(11);
  double worst = 0;
  for (int i = 0; i < 60; ++i) {
    const Vec3 wanted = random_vector(random);
    const LatticePlane p =
        plane_through(fit_normal(quantise_direction(wanted), kRadius), {1, 2, 3}, {0, 0, 0});
    check_frame(p);
    worst = std::max({worst, kHuge * angle(wanted, to_real(p.normal)), norm(to_real(p.e2))});
    for (int k = 0; k < 20; ++k) {
      const LatticeVector q = random_point(random), s = snap_to_plane(p, q);
      CHECK(side_of_plane(p, make_point(s)) == 0);
      // Never further than the plane and its mesh are.
      const double away = std::fabs(dot(unit(to_real(p.normal)), to_real(q) - to_real(p.origin)));
      CHECK(distance(q, s) <= away + norm(to_real(p.e1)) + norm(to_real(p.e2)));
    }
  }
  CHECK(worst < kHuge * 1e-9);
}

TEST_CASE("planes tilted by a hair stay within 4e-7") {
  for (int bits = 2; bits <= 60; ++bits) {
    CAPTURE(bits);
    const Vec3 wanted{std::ldexp(1.0, -bits), std::ldexp(-0.3, -bits), 1};
    const LatticePlane p =
        plane_through(fit_normal(quantise_direction(wanted), kRadius), {0, 0, 0}, {0, 0, 0});
    check_frame(p);
    CHECK(angle(wanted, to_real(p.normal)) < 4e-7);
    CHECK(norm(to_real(p.e2)) < 4e-7 * kHuge);
  }
}

TEST_CASE("the nearest lattice point is nearest") {
  std::mt19937_64 random(13);
  const LatticePlane p = plane_through({7, -11, 5}, {1, 2, 3}, {0, 0, 0});
  check_frame(p);
  for (int i = 0; i < 50; ++i) {
    LatticeVector q;
    for (auto& c : q) c = static_cast<std::int64_t>(random() % 40) - 20;
    const double found = distance(q, snap_to_plane(p, q));
    for (std::int64_t u = -30; u <= 30; ++u)
      for (std::int64_t v = -30; v <= 30; ++v) {
        LatticeVector s;
        for (std::size_t k = 0; k < 3; ++k) s[k] = p.origin[k] + u * p.e1[k] + v * p.e2[k];
        CHECK_MESSAGE(found <= distance(q, s), "a nearer one");
      }
  }
}

TEST_CASE("an integer plane through integer points keeps them") {
  std::mt19937_64 random(17);
  const LatticeVector n{2, -3, 7};
  const LatticePlane wanted = plane_through(n, {1000001, 77, -5}, {0, 0, 0});
  std::vector<LatticeVector> points;
  for (int i = 0; i < 50; ++i) points.push_back(snap_to_plane(wanted, random_point(random)));
  const LatticePlane p = plane_amid(n, points, {0, 0, 0});
  CHECK(same_plane(p, wanted));
  CHECK(p.origin == wanted.origin);
  for (const LatticeVector& q : points) CHECK(snap_to_plane(p, q) == q);
}

TEST_CASE("the planes of a pencil contain its axis") {
  std::mt19937_64 random(19);
  for (int i = 0; i < 10; ++i) {
    const Vec3 wanted = random_vector(random);
    const LatticeVector axis = fit_axis(quantise_direction(wanted), kRadius);
    CHECK(is_primitive(axis));
    CHECK(angle(wanted, to_real(axis)) < 1e-8);
    std::vector<LatticePlane> planes;
    for (int k = 0; k < 5; ++k) {
      const Vec3 n = cross(wanted, random_vector(random));
      planes.push_back(
          plane_through(fit_normal_around(quantise_direction(n), axis, kRadius), {5, 6, 7}, {0, 0, 0}));
      check_frame(planes.back());
      CHECK(angle(n, to_real(planes.back().normal)) < 1e-8);
      for (const std::int64_t t : {-1, 0, 1000})
        CHECK(side_of_plane(planes.back(), make_point({5 + t * axis[0], 6 + t * axis[1], 7 + t * axis[2]})) ==
              0);
    }
    for (std::size_t k = 2; k < 5; ++k) CHECK(share_line(planes[0], planes[1], planes[k]));
    LatticeVector common;
    REQUIRE(axis_of(planes[0], planes[1], common));
    CHECK((common == axis || cross(common, axis) == LatticeVector{0, 0, 0}));
    LatticeVector in_plane;
    REQUIRE(fit_axis_in_plane(quantise_direction(wanted), planes[0].normal, kRadius, in_plane));
    CHECK(side_of_plane(planes[0], make_point({5 + in_plane[0], 6 + in_plane[1], 7 + in_plane[2]})) == 0);
    CHECK(angle(wanted, to_real(in_plane)) < 1e-6);
  }
}

TEST_CASE("a plane may have no axis along a direction, or none at all") {
  constexpr std::int64_t kFar = std::int64_t{1} << 48;
  LatticeVector axis;
  CHECK_FALSE(fit_axis_in_plane(quantise_direction({1, 0, 0}), {1, 0, std::int64_t{1} << 40}, kFar, axis));
  CHECK(fit_axis_in_plane(quantise_direction({0, 1, 0}), {1, 0, std::int64_t{1} << 40}, kFar, axis));
  CHECK(axis == LatticeVector{0, 1, 0});
  CHECK_FALSE(fit_axis_in_plane({15140012084368, -70368744177664, 12096333600756},
                                {1099511627562, 387571161529, 878470860577}, kFar, axis));
}

TEST_CASE("exact tests of planes") {
  const LatticePlane z0 = make_axis_plane(2, 0), z1 = make_axis_plane(2, 1), x = make_axis_plane(0, 0);
  const LatticePlane diagonal = plane_through({1, 0, 1}, {0, 5, 0}, {0, 0, 0});
  CHECK(same_plane(z0, plane_through({0, 0, 1}, {9, 9, 0}, {4, 4, 4})));
  CHECK_FALSE(same_plane(z0, z1));
  CHECK(compare_offsets(z0, z1) < 0);
  CHECK(compare_offsets(z1, z0) > 0);
  CHECK(share_line(x, z0, diagonal));
  CHECK_FALSE(share_line(x, z1, diagonal));
  CHECK_FALSE(share_line(z0, z1, x));
  LatticeVector axis;
  CHECK(axis_of(x, z0, axis));
  CHECK(axis == LatticeVector{0, 1, 0});
  CHECK_FALSE(axis_of(z0, z1, axis));
}

TEST_CASE("a kernel is all integer solutions") {
  for (const LatticeVector n : {LatticeVector{0, 0, 1}, LatticeVector{0, 0, -1}, LatticeVector{6, 10, 15},
                                LatticeVector{-5, 0, 3}, LatticeVector{1099511627776, 3, -1099511627775}}) {
    const Kernel k = kernel_of(n);
    CHECK(narrow(cross(k.a, k.b)) == n);
    CHECK(dot(widen(n), k.a) == 0);
    CHECK(dot(widen(n), k.b) == 0);
    CHECK(dot(widen(n), k.t) == 1);
    CHECK(dot(k.a, k.a) <= dot(k.b, k.b));
    CHECK(2 * abs(dot(k.a, k.b)) <= dot(k.a, k.a));
  }
}

TEST_CASE("quotients round half upwards") {
  const std::array<std::array<int, 3>, 7> cases{
      {{7, 2, 4}, {-7, 2, -3}, {-8, 3, -3}, {8, 3, 3}, {0, 5, 0}, {-5, 10, 0}, {5, 10, 1}}};
  for (const auto& c : cases) CHECK(round_quotient(Wide(c[0]), Wide(c[1])) == c[2]);
}
