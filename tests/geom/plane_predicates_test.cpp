#include "../../geom/plane_predicates.h"

#include <doctest/doctest.h>

#include "lattice_samples.h"
#include "rational_reference.h"
#include "tracked_error.h"

using namespace crossloft;
using reference::exact;
using samples::Generator;

namespace {

constexpr std::uint64_t kSeed = 20260202;

int expected_side(const LatticePlane& a, const LatticePlane& b, const LatticePlane& c,
                  const LatticePlane& q) {
  const auto na = exact(a.normal), nb = exact(b.normal), nc = exact(c.normal), nq = exact(q.normal);
  const mpq_class w = reference::volume(na, nb, nc);
  if (w == 0) return 0;
  const auto offset = [](const LatticePlane& p) { return reference::dot(exact(p.normal), exact(p.origin)); };
  const auto x = reference::cross(nb, nc), y = reference::cross(nc, na), z = reference::cross(na, nb);
  reference::Rational3 point;
  for (std::size_t k = 0; k < 3; ++k) point[k] = (offset(a) * x[k] + offset(b) * y[k] + offset(c) * z[k]) / w;
  return sgn(mpq_class(reference::dot(nq, point) - offset(q)));
}

LatticePlane flipped(const LatticePlane& p) { return make_lattice_plane(p.origin, p.e2, p.e1); }

}  // namespace

TEST_CASE("side_of_meet agrees with rationals, whatever the planes") {
  MESSAGE("seed " << kSeed);
  Generator generator(kSeed);
  for (const std::int64_t normals : {std::int64_t{8}, std::int64_t{1} << 28, kNormalLimit})
    for (const std::int64_t coordinates : {std::int64_t{4}, kLatticeLimit})
      for (int round = 0; round < 300; ++round) {
        const LatticePlane a = generator.plane(normals, coordinates),
                           b = generator.plane(normals, coordinates),
                           c = generator.plane(normals, coordinates),
                           q = generator.plane(normals, coordinates);
        const int side = side_of_meet(a, b, c, q);
        CHECK(side == expected_side(a, b, c, q));
        CHECK(side_of_meet_exact(a, b, c, q) == side);
        if (const int sure = side_of_meet_filter(a, b, c, q)) CHECK(sure == side);
        CHECK(side_of_meet(b, a, c, q) == side);
        CHECK(side_of_meet(c, b, a, q) == side);
        CHECK(side_of_meet(a, flipped(b), c, q) == side);
        CHECK(side_of_meet(a, b, c, flipped(q)) == -side);
        CHECK(side_of_meet(a, b, c, a) == 0);
        CHECK(side_of_meet(a, b, c, c) == 0);
        CHECK(side_of_meet(a, b, b, q) == 0);
      }
}

TEST_CASE("four planes through one point, and one of them a unit off") {
  Generator generator(kSeed + 1);
  for (int round = 0; round < 300; ++round) {
    const LatticeVector common = generator.vector(kLatticeLimit - 1);
    std::array<LatticePlane, 4> p;
    for (LatticePlane& plane : p) {
      plane = generator.plane(kNormalLimit, 1);
      // The plane is through `common`, but given by another of its points.
      const std::int64_t u = generator.integer(256), v = generator.integer(256);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t o = common[k] + u * plane.e1[k] + v * plane.e2[k];
        plane.origin[k] = std::abs(o) <= kLatticeLimit ? o : common[k];
      }
      if (side_of_plane(plane, make_point(common)) != 0) plane.origin = common;
    }
    if (orient_normals(p[0], p[1], p[2]) == 0) continue;
    CHECK(side_of_meet(p[0], p[1], p[2], p[3]) == 0);
    for (std::size_t moved = 0; moved < 4; ++moved) {
      auto q = p;
      q[moved].origin[generator.index(3)] -= 1;
      const int side = expected_side(q[0], q[1], q[2], q[3]);
      CHECK(side_of_meet(q[0], q[1], q[2], q[3]) == side);
      if (const int sure = side_of_meet_filter(q[0], q[1], q[2], q[3])) CHECK(sure == side);
    }
  }
}

TEST_CASE("constant of side_of_meet: a determinant of exact normals and rounded offsets") {
  using tracked::Tracked;
  const Tracked normal{1, 0};
  // Of the sum of its terms' sizes: each of the three products and sums rounds by u of no more than that. The
  // size is a computed one, off by as much.
  mpq_class growth = 1;
  for (int i = 0; i < 3; ++i) growth *= 1 + tracked::kUnit;
  const Tracked offset{growth, (growth - 1) * growth};
  const Tracked term = offset * tracked::det3_of(normal);
  tracked::check_constant(filters::kSideOfMeetError, (term + term) + term);
}

TEST_CASE("the filter of side_of_meet decides nearly all planes in general position and never a tie") {
  MESSAGE("seed " << kSeed + 3);
  Generator generator(kSeed + 3);
  int decided = 0;
  for (int round = 0; round < 1000; ++round) {
    const auto plane = [&] { return generator.plane(kNormalLimit, kLatticeLimit); };
    const LatticePlane a = plane(), b = plane(), c = plane(), q = plane();
    if (side_of_meet_filter(a, b, c, q) != 0) ++decided;
    CHECK(side_of_meet_filter(a, b, c, a) == 0);
    CHECK(side_of_meet_filter(a, b, b, q) == 0);
  }
  CHECK(decided > 990);
}

TEST_CASE("side_of_meet agrees with the side of the constructed point") {
  Generator generator(kSeed + 2);
  LatticePointStore store;
  for (int round = 0; round < 300; ++round) {
    const auto plane = [&] { return generator.plane(kNormalLimit, kLatticeLimit / 4); };
    const LatticePlane a = plane(), b = plane(), c = plane(), q = plane();
    LatticePoint p;
    if (!store.meet(a, b, c, p)) continue;
    CHECK(side_of_plane(a, p) == 0);
    CHECK(side_of_meet(a, b, c, q) == side_of_plane(q, p));
  }
}
