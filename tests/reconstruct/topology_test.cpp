/// The mode natural on solids whose topology is known, and what the user can steer.

#include <algorithm>
#include <cmath>

#include "../../inspect/check.h"
#include "../../inspect/slice.h"
#include "../../inspect/solids.h"
#include "../arrangement/polygon_sections.h"
#include "scenes.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

Reconstruction cut_and_rebuild(const Surface& mesh, const std::vector<CuttingPlane>& planes,
                               const Options& options = {}) {
  const auto sections = slice(mesh, planes);
  REQUIRE(sections.ok());
  auto r = reconstruct(*sections, options);
  REQUIRE(r.ok());
  CHECK(check_surface(r->surface).good_topology());
  return std::move(r).value();
}

Options with_mode(PruneMode mode) {
  Options options;
  options.mode = mode;
  return options;
}

/// A box with a square section that two planes cut; `gap` apart along x are two such boxes.
Sections two_columns(double gap) {
  Sections sections;
  for (const double z : {0.0, 1.0}) {
    PlaneSection plane;
    plane.normal = {0, 0, 1};
    plane.offset = -z;
    for (std::uint32_t k = 0; k < 2; ++k) {
      const double x = k * (1 + gap);
      const auto first = static_cast<std::uint32_t>(plane.vertices.size());
      for (const Vec3& v : {Vec3{x, 0, z}, Vec3{x + 1, 0, z}, Vec3{x + 1, 1, z}, Vec3{x, 1, z}})
        plane.vertices.push_back(v);
      for (std::uint32_t i = 0; i < 4; ++i) plane.edges.push_back({first + i, first + (i + 1) % 4, 1, 0, k});
    }
    sections.planes.push_back(plane);
  }
  return sections;
}

/// A tray whose floor has all of its contour on the lines of the planes through its walls, and a square above
/// it.
Sections tray_and_square() {
  Sections sections;
  for (const double z : {0.0, 1.0}) {
    sections.planes.push_back(plane_at({0, 0, 1}, {0, 0, z}));
    add_contour(sections.planes.back(), square(0, 0, z, z == 0 ? 1 : 0.5));
  }
  for (const double at : {-1.0, 1.0}) {
    constexpr double kHigh = 0.125;
    PlaneSection x = plane_at({1, 0, 0}, {at, 0, 0}), y = plane_at({0, 1, 0}, {0, at, 0});
    add_contour(x, {{at, -1, 0}, {at, 1, 0}, {at, 1, kHigh}, {at, -1, kHigh}});
    add_contour(y, {{-1, at, 0}, {1, at, 0}, {1, at, kHigh}, {-1, at, kHigh}});
    sections.planes.insert(sections.planes.end(), {x, y});
  }
  return sections;
}

/// In two planes a square ring with a slit: below on the right side, above on the left one or the same one.
Sections two_slit_rings(double height, bool opposite) {
  Sections sections;
  for (const double z : {0.0, height}) {
    PlaneSection plane;
    plane.normal = {0, 0, 1};
    plane.offset = -z;
    const double side = z > 0 && opposite ? -1 : 1;
    for (const auto& [x, y] : {std::pair{3.0, -0.5},
                               {1.0, -0.5},
                               {1.0, -1.0},
                               {-1.0, -1.0},
                               {-1.0, 1.0},
                               {1.0, 1.0},
                               {1.0, 0.5},
                               {3.0, 0.5},
                               {3.0, 3.0},
                               {-3.0, 3.0},
                               {-3.0, -3.0},
                               {3.0, -3.0}})
      plane.vertices.push_back({side * x, y, z});
    for (std::uint32_t i = 0; i < 12; ++i) plane.edges.push_back({i, (i + 1) % 12});
    sections.planes.push_back(plane);
  }
  return sections;
}

}  // namespace

TEST_CASE(
    "two rings that are slit on opposite sides ask for a handle between two planes, on the same side not") {
  for (const bool opposite : {true, false}) {
    CAPTURE(opposite);
    const auto r = reconstruct(two_slit_rings(0.5, opposite));
    REQUIRE(r.ok());
    CHECK(check_surface(r->surface).good_topology());
    CHECK(check_surface(r->surface).genus == (opposite ? 1 : 0));
    CHECK(r->report.topology.handles == (opposite ? 1U : 0U));
  }
  const auto far = reconstruct(two_slit_rings(8, true));  // nothing is sure of this ring
  REQUIRE(far.ok());
  CHECK(far->report.topology.handles == 0);
  Sections crossed = two_slit_rings(0.5, true);  // an empty plane beside the rings: planes meet in their cell
  PlaneSection& plane = crossed.planes.emplace_back();
  plane.normal = {1, 0, 0};
  plane.offset = -3.2;
  const auto r = reconstruct(crossed);
  REQUIRE(r.ok());
  CHECK(r->report.topology.handles == 0);
}

TEST_CASE("a stack across a tilted torus: between two planes the ring closes that neither has") {
  const Surface mesh = torus(1, 0.4, 96, 48);
  const Vec3 direction = random_planes(bounds_of(mesh.points), 1, 7)[0].normal;
  for (const std::uint32_t count : {10U, 16U}) {
    CAPTURE(count);
    const Reconstruction r = cut_and_rebuild(mesh, parallel_planes(bounds_of(mesh.points), count, direction));
    CHECK(check_surface(r.surface).genus == 1);
    CHECK(r.report.topology.handles == 1);
  }
}

TEST_CASE("a torus by ten to forty-five planes is a torus, whatever joint makes of it") {
  const Surface mesh = torus(1, 0.4, 80, 40);
  for (const std::uint32_t count : {10u, 16u, 45u}) {
    CAPTURE(count);
    const auto planes = random_planes(bounds_of(mesh.points), count, 2);
    const Reconstruction r = cut_and_rebuild(mesh, planes);
    const CheckReport report = check_surface(r.surface);
    CHECK(report.genus == 1);
    CHECK(report.components.size() == 1);
    CHECK(r.report.topology.handles == 0);
    CHECK(r.report.topology.voids == 0);
  }
}

TEST_CASE("a stack through a hollow ball: the cavity is closed at both ends") {
  const Surface mesh = nested_shells(40);
  for (const std::uint32_t count : {16U, 25U, 40U})
    for (const Vec3 direction : {Vec3{0, 0, 1}, Vec3{1, 0, 0}}) {
      CAPTURE(count);
      const auto planes = parallel_planes(bounds_of(mesh.points), count, direction);
      const CheckReport report = check_surface(cut_and_rebuild(mesh, planes).surface);
      CHECK(report.components.size() == 3);
      CHECK(report.cavities == 1);
      CHECK(report.genus == 0);
      CHECK(std::abs(report.volume - check_surface(mesh).volume) < 0.02 * report.volume);
    }
}

TEST_CASE(
    "a few slices through thin walls: no handles where wedges of the solid reach edges within sections") {
  const Surface mesh = nested_shells(32);
  for (const std::uint32_t count : {14U, 16U}) {  // genus 24 and 8 with bridges over one gap only
    CAPTURE(count);
    const auto planes = parallel_planes(bounds_of(mesh.points), count, {0.3, 0.5, 1});
    const Reconstruction r = cut_and_rebuild(mesh, planes);
    CHECK(check_surface(r.surface).genus == 0);
    CHECK(r.report.topology.bridges > 0);
    CHECK(r.report.topology.open_edges == 0);
  }
}

TEST_CASE("where confidences are in doubt, the sections around a cell tell that a torus goes on") {
  const Surface mesh = torus(1, 0.4, 96, 48);
  Options options;
  options.natural.look_around = InCells::all;
  const Reconstruction r = cut_and_rebuild(mesh, random_planes(bounds_of(mesh.points), 10, 7), options);
  const CheckReport report = check_surface(r.surface);
  CHECK(report.genus == 1);
  CHECK(report.components.size() == 1);
}

TEST_CASE("the demo has the genus of what it is cut from: a speck of a section is not joined by the function") {
  const auto r = reconstruct(load("demo.contour"));
  REQUIRE(r.ok());
  const CheckReport surface = check_surface(r->surface);
  CHECK(surface.genus == 2);
  CHECK(surface.components.size() == 1);
}

TEST_CASE("two balls with a gap stay two where several planes meet both in a cell") {
  // The function through the sections is a little above 0 in a gap that is narrower than its samples are
  // apart: these two are one unless the planes count that had to miss a join between them.
  const auto ball = [](const Vec3& p, double x) { return norm(p - Vec3{x, 0, 0}) - 0.5; };
  const Surface mesh = implicit_solid([&](const Vec3& p) { return std::min(ball(p, -0.54), ball(p, 0.54)); },
                                      Bounds{{-1.2, -0.7, -0.7}, {1.2, 0.7, 0.7}}, 40);
  REQUIRE(check_surface(mesh).components.size() == 2);
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    CAPTURE(seed);
    const auto planes = random_planes(bounds_of(mesh.points), 20, seed);
    CHECK(check_surface(cut_and_rebuild(mesh, planes).surface).components.size() == 2);
  }
}

TEST_CASE("between parts of the outside that several planes show there is a wall, where R1 has none, too") {
  const Surface mesh = gyroid_solid();
  const Reconstruction r = cut_and_rebuild(mesh, random_planes(bounds_of(mesh.points), 40, 12));
  CHECK(check_surface(r.surface).genus == 2);  // 3 without walls
  CHECK(r.report.topology.handles == 0);
}

TEST_CASE("handles that joint makes are gone, and every section is still met") {
  const Surface mesh = genus2_solid(40);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    CAPTURE(seed);
    const auto planes = random_planes(bounds_of(mesh.points), 24, seed);
    const Reconstruction joint = cut_and_rebuild(mesh, planes, with_mode(PruneMode::joint));
    CHECK(joint.report.topology.handles > 0);
    const Reconstruction natural = cut_and_rebuild(mesh, planes);
    CHECK(natural.report.topology.handles == 0);
    CHECK(check_surface(natural.surface).genus < check_surface(joint.surface).genus);
    const SectionCheck check = check_sections(natural.surface, natural.sections);
    for (std::size_t p = 0; p < check.planes.size(); ++p)
      CHECK(check.planes[p].difference_area() <=
            natural.report.planes[p].flat_area + 1e-6 * natural.report.section_area);
  }
}

TEST_CASE("two columns stay two; a request keeps even one column's ends apart") {
  const Sections sections = two_columns(1.5);
  const auto r = reconstruct(sections);
  REQUIRE(r.ok());
  CHECK(check_surface(r->surface).components.size() == 2);
  CHECK(r->report.topology.joins == 2);

  Options apart;
  apart.joins.push_back({0, 0, 1, 0, false});
  const auto cut = reconstruct(sections, apart);
  REQUIRE(cut.ok());
  CHECK(cut->report.topology.joins == 1);
  CHECK(cut->report.topology.refused_joins >= 1);
}

TEST_CASE("a request hears of contours that lie on lines of planes") {
  const Sections sections = tray_and_square();
  const auto one = reconstruct(sections);
  REQUIRE(one.ok());
  CHECK(one->report.topology.joins == 1);
  CHECK(check_surface(one->surface).components.size() == 1);
  Options options;
  options.joins.push_back({0, 0, 1, 0, false});
  const auto two = reconstruct(sections, options);
  REQUIRE(two.ok());
  CHECK(two->report.topology.joins == 0);
  CHECK(check_surface(two->surface).components.size() == 2);
}

TEST_CASE("a request finds a way where the cut leaves none between two sections") {
  Sections far;
  far.planes.push_back(disk({0, 0, 1}, {0, 0, 0}, 1, 16));
  far.planes.push_back(disk({0, 0, 1}, {4, 0, 0.5}, 1, 16));
  Options options;
  options.natural.alone_confidence = 1;  // nor does the second look
  const auto two = reconstruct(far, options);
  REQUIRE(two.ok());
  CHECK(check_surface(two->surface).components.size() == 2);
  options.joins.push_back({0, 0, 1, 0, true});
  const auto one = reconstruct(far, options);
  REQUIRE(one.ok());
  CHECK(one->report.topology.joins == 1);
  CHECK(check_surface(one->surface).components.size() == 1);
}

TEST_CASE("a join below the wanted confidence is refused and reported, and a request overrides that") {
  Options strict;
  strict.natural.join_confidence = strict.natural.alone_confidence = 1;
  const Sections sections = two_columns(1.5);
  const auto r = reconstruct(sections, strict);
  REQUIRE(r.ok());
  CHECK(r->report.topology.joins == 0);
  CHECK(r->report.topology.refused_joins >= 2);
  strict.joins.push_back({0, 1, 1, 1, true});
  const auto one = reconstruct(sections, strict);
  REQUIRE(one.ok());
  CHECK(one->report.topology.joins == 1);
}

TEST_CASE("a hole that is closed over from all sides with little confidence is no cavity") {
  const Surface mesh = genus3_solid(24);
  const auto planes = random_planes(bounds_of(mesh.points), 4, 31);
  Options closed;
  closed.natural.cavity_confidence = -1;
  CHECK(check_surface(cut_and_rebuild(mesh, planes, closed).surface).cavities == 1);
  const Reconstruction r = cut_and_rebuild(mesh, planes);
  const CheckReport report = check_surface(r.surface);
  CHECK(report.cavities == 0);
  CHECK(report.components.size() == 1);
  CHECK(report.crossings == 0);
  CHECK(r.report.topology.walls_opened >= 1);
  CHECK(r.report.topology.handles == 0);
  CHECK(r.report.flat_area == 0);
}

TEST_CASE("tips of bumps that few planes meet are joined, bubbles at tips of dents opened") {
  const Surface mesh = genus2_solid(32);
  Options without;
  without.natural.alone_confidence = 1;
  without.natural.cavity_confidence = -1;
  std::uint32_t joined = 0, opened = 0;
  for (const std::uint64_t seed : {1u, 30u, 59u}) {
    CAPTURE(seed);
    const auto planes = random_planes(bounds_of(mesh.points), 24, seed);
    const Reconstruction before = cut_and_rebuild(mesh, planes, without), r = cut_and_rebuild(mesh, planes);
    const TopologyReport& topology = r.report.topology;
    CHECK(check_surface(before.surface).components.size() ==
          1 + topology.bodies_joined + topology.walls_opened);
    const CheckReport report = check_surface(r.surface);
    CHECK(report.components.size() == 1);
    CHECK(topology.handles == 0);
    CHECK(topology.voids == 0);
    joined += topology.bodies_joined;
    opened += topology.walls_opened;
  }
  CHECK(joined > 0);
  CHECK(opened > 0);
}

TEST_CASE("options of natural and requests that make no sense are refused, with plane and contour") {
  const Sections sections = two_columns(1.5);
  const auto refused = [&](const Options& options) {
    const auto r = reconstruct(sections, options);
    REQUIRE(!r.ok());
    CHECK(r.error().code == ErrorCode::usage);
    return r.error();
  };
  for (const double bad : {-1.5, 1.5, static_cast<double>(NAN)}) {
    for (double NaturalOptions::*confidence :
         {&NaturalOptions::join_confidence, &NaturalOptions::dome_confidence,
          &NaturalOptions::alone_confidence, &NaturalOptions::cavity_confidence}) {
      Options options;
      options.natural.*confidence = bad;
      refused(options);
    }
  }
  for (const double bad : {-1.0, 1e10, static_cast<double>(INFINITY), static_cast<double>(NAN)}) {
    Options smooth;
    smooth.natural.smooth_weight = bad;
    refused(smooth);
  }
  Options plane, contour;
  plane.joins.push_back({0, 0, 2, 0, true});
  CHECK(refused(plane).plane == 2);
  contour.joins.push_back({0, 0, 1, 5, false});
  CHECK(refused(contour).plane == 1);
  CHECK(refused(contour).contour == 5);
  // A contour with itself, and the contrary of another, whichever contour comes first.
  for (const bool join : {false, true}) {
    Options itself, contrary;
    itself.joins = {{0, 0, 1, 1, true}, {1, 0, 1, 0, join}};
    CHECK(refused(itself).plane == 1);
    contrary.joins = {{0, 1, 1, 0, join}, {0, 0, 1, 0, true}, {0, 1, 1, 0, !join}};
    CHECK(refused(contrary).contour == 1);
    contrary.joins[0] = {1, 0, 0, 1, join};
    CHECK(refused(contrary).contour == 1);
    contrary.joins[2].join = join;  // the same twice
    CHECK(reconstruct(sections, contrary).ok());
  }
}

TEST_CASE("requests that do nothing are told") {
  const Sections sections = two_columns(1.5);
  Sections apart = sections;  // an empty plane between the two sections of each column
  apart.planes.push_back(plane_at({0, 0, 1}, {0, 0, 0.5}));
  Options options;
  options.joins = {{0, 0, 1, 0, true}, {1, 1, 0, 1, false}};
  const auto warnings = [&](const Sections& of) {
    const auto r = reconstruct(of, options);
    REQUIRE(r.ok());
    return r->report.warnings;
  };
  CHECK(warnings(sections).empty());
  std::vector<std::string> told = warnings(apart);
  REQUIRE(told.size() == 3);  // and that nothing came out
  CHECK(told[0] ==
        "a request to join does nothing: no cell has both contour 0 of plane 0 and contour 0 of plane 1");
  CHECK(told[1] ==
        "a request to join does nothing: no cell has both contour 1 of plane 1 and contour 1 of plane 0");
  options.mode = PruneMode::joint;
  told = warnings(sections);
  REQUIRE(told.size() == 1);
  CHECK(told[0] == "requests to join do nothing: they are for mode natural alone");
}

TEST_CASE("numbers that were made into choices are refused") {
  const Sections sections = two_columns(1.5);
  const auto check = [&](const auto& spoil) {
    Options options;
    spoil(options);
    const auto r = reconstruct(sections, options);
    REQUIRE(!r.ok());
    CHECK(r.error().code == ErrorCode::usage);
  };
  check([](Options& o) { o.mode = static_cast<PruneMode>(4); });
  check([](Options& o) { o.branching.mode = static_cast<Branching>(3); });
  check([](Options& o) { o.natural.divide = static_cast<InCells>(3); });
  check([](Options& o) { o.natural.look_around = static_cast<InCells>(77); });
}
