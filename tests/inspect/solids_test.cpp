#include "../../inspect/solids.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

#include "../../inspect/check.h"
#include "../../inspect/circle.h"

using namespace crossloft;

namespace {

CheckReport good(const Surface& mesh) {
  const CheckReport r = check_surface(mesh);
  CHECK(r.good_topology());
  CHECK(r.crossings == 0);
  CHECK(r.overlaps == 0);
  CHECK(r.flat_triangles == 0);
  CHECK(r.repeated_points == 0);
  CHECK(r.inverted == 0);
  return r;
}

/// FNV-1a over all bytes.
std::uint64_t hash(const Surface& mesh) {
  std::uint64_t h = 0xcbf29ce484222325u;
  const auto feed = [&h](const void* data, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
      h = (h ^ static_cast<const unsigned char*>(data)[i]) * 0x100000001b3u;
  };
  for (const Vec3& p : mesh.points) feed(&p, sizeof p);
  for (const auto& t : mesh.triangles) feed(t.data(), sizeof t);
  return h;
}

}  // namespace

TEST_CASE("sine and cosine agree with the C library") {
  for (int k = -3000; k <= 3000; ++k) {
    const SineCosine s = circle(k / 977.0);
    CHECK(std::abs(s.sine - std::sin(2 * 3.14159265358979323846 * k / 977.0)) < 1e-14);
    CHECK(std::abs(s.cosine - std::cos(2 * 3.14159265358979323846 * k / 977.0)) < 1e-14);
  }
  CHECK(circle(0.25).cosine == 0);
  CHECK(circle(0.5).sine == 0);
}

TEST_CASE("solids have the topology they promise") {
  CHECK(good(torus(1, 0.4, 80, 40)).genus == 1);
  CHECK(good(genus2_solid(40)).genus == 2);
  CHECK(good(genus3_solid(48)).genus == 3);
  CHECK(good(trefoil_solid(48)).genus == 1);
  const CheckReport vessel = good(vessel_solid(64));
  CHECK(vessel.genus == 0);
  CHECK(vessel.components.size() == 1);
  const CheckReport gyroid = good(gyroid_solid(40));
  CHECK(gyroid.components.size() == 1);
  CHECK(gyroid.genus == 2);
  const CheckReport shells = good(nested_shells(32));
  CHECK(shells.components.size() == 3);
  CHECK(shells.cavities == 1);
  const CheckReport demo = good(demo_solid(64));
  CHECK(demo.genus == 2);
  CHECK(demo.components.size() == 1);
  CHECK(demo.cavities == 0);
}

TEST_CASE("an implicit ball has the ball's volume and closes at the box") {
  Bounds box;
  box.add(Vec3{-1, -1, -1});
  box.add(Vec3{1, 1, 1});
  const auto ball = [](const Vec3& p) { return norm(p) - 0.8; };
  CHECK(good(implicit_solid(ball, box, 40)).volume == doctest::Approx(4.18879 * 0.512).epsilon(0.01));
  const auto everywhere = [](const Vec3&) { return -1.0; };
  CHECK(good(implicit_solid(everywhere, box, 10)).volume > 5);
  const auto nowhere = [](const Vec3&) { return 1.0; };
  CHECK(implicit_solid(nowhere, box, 10).triangles.empty());
}

TEST_CASE("solids are the same to the bit for every compiler and optimisation level") {
  CHECK(hash(demo_solid(32)) == 0x662c35ae2a340a20u);
  CHECK(hash(torus(1, 0.4, 80, 40)) == 0x81d863af309225d1u);
  CHECK(hash(gyroid_solid(24)) == 0xfdbdc21a90082893u);
  CHECK(hash(vessel_solid(24)) == 0x8c77174b4f34c26u);
}
