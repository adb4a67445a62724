/// Where a body ends beside another one that goes on.

#include <cmath>

#include "../../inspect/check.h"
#include "columns.h"
#include "scenes.h"
#include "shuffled.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

Reconstruction rebuilt(const Sections& sections, PruneMode mode = PruneMode::natural) {
  Options options;
  options.mode = mode;
  auto r = reconstruct(sections, options);
  REQUIRE(r.ok());
  return std::move(r).value();
}

}  // namespace

TEST_CASE("a body that ends ends flat, however far what goes on is") {
  for (const double x : {35.0, 300.0}) {
    CAPTURE(x);
    const Sections sections = column_and_short_one(x, 3, 4);
    const Reconstruction r = rebuilt(sections);
    const CheckReport report = check_surface(r.surface);
    CHECK(report.components.size() == 2);
    CHECK(report.genus == 0);
    CHECK(r.report.flat_area == 0);
    CHECK(r.report.topology.spikes_dropped == 2);
    const double prism = kApart * 12 * std::sin(M_PI / 6) / 2 * 4;
    const double column = 7 * kApart * 60 * std::sin(M_PI / 30) / 2 * 400;
    CHECK(r.report.volume == doctest::Approx(column + prism).epsilon(1e-9));
  }
}

TEST_CASE("a section in one plane alone keeps one spike, rather than to be flat") {
  const Reconstruction r = rebuilt(column_and_short_one(60, 3, 3));
  CHECK(check_surface(r.surface).components.size() == 2);
  CHECK(r.report.flat_area == 0);
  CHECK(r.report.topology.spikes_dropped == 1);
  const double area = 12 * std::sin(M_PI / 6) / 2 * 4,
               column = 7 * kApart * 60 * std::sin(M_PI / 30) / 2 * 400;
  CHECK(r.report.volume == doctest::Approx(column + kApart * area / 3).epsilon(1e-9));
}

TEST_CASE("spikes go too where samples elsewhere change the numbers after them") {
  for (const double x : {-100.0, 100.0}) {
    CAPTURE(x);
    Sections sections = column_and_short_one(35, 3, 4);
    add_ring_and_disk(sections, x);
    const Reconstruction r = rebuilt(sections);
    CHECK(r.report.branching_samples > 0);
    CHECK(r.report.topology.spikes_dropped == 2);
  }
}

TEST_CASE("spikes that go leave no trace of order and threads") {
  const Sections sections = column_and_short_one(35, 2, 4);
  const Reconstruction r = rebuilt(sections);
  Context three;
  three.threads = 3;
  const auto other = reconstruct(shuffled(sections, 5), {}, three);
  REQUIRE(other.ok());
  CHECK(other->surface.points == r.surface.points);
  CHECK(other->surface.triangles == r.surface.triangles);
}

TEST_CASE("what the second look joins is no wedge but all that is between") {
  for (const double apart : {0.9, 1.01, 2.0}) {
    CAPTURE(apart);
    Sections sections;
    for (const double z : {0.0, apart}) {
      PlaneSection plane;
      plane.normal = {0, 0, 1};
      plane.offset = -z;
      for (const Vec3& v : {Vec3{0, 0, z}, Vec3{1, 0, z}, Vec3{1, 1, z}, Vec3{0, 1, z}})
        plane.vertices.push_back(v);
      for (std::uint32_t i = 0; i < 4; ++i) plane.edges.push_back({i, (i + 1) % 4});
      sections.planes.push_back(plane);
    }
    const Reconstruction r = rebuilt(sections);
    CHECK(r.report.topology.bodies_joined == (apart > 1 ? 1 : 0));
    CHECK(r.report.volume == doctest::Approx(apart).epsilon(1e-12));
  }
}
