/// Flat regions as thin plates: the solid meets each plane in its section, whole.

#include "../../inspect/check.h"
#include "../fuzz/section_judge.h"
#include "shown.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

Sections one_plane() {
  Sections sections = load("figures/fig16_center.contour");
  sections.planes.resize(1);
  return sections;
}

/// An empty plane above and below each plane, and one across all.
Sections among_empty_planes() {
  Sections sections = load("figures/fig20b.contour");
  const std::size_t count = sections.planes.size();
  for (std::size_t p = 0; p < count; ++p)
    for (const double by : {-0.1, 0.1}) {
      PlaneSection empty;
      empty.normal = sections.planes[p].normal;
      empty.offset = sections.planes[p].offset + by;
      sections.planes.push_back(empty);
    }
  return sections;
}

std::vector<Scene> flat_scenes() {
  std::vector<Scene> scenes{{"one plane", one_plane()}, {"among empty planes", among_empty_planes()}};
  Options joint;
  joint.mode = PruneMode::joint;
  for (const char* name : {"figures/fig16_shift.contour", "figures/fig20b.contour"})
    scenes.push_back({name, load(name), joint});
  Options strict;
  strict.natural.join_confidence = 0.9;
  strict.natural.alone_confidence = 1;
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u})
    scenes.push_back(
        {"genus 2 by 6, set " + std::to_string(seed), cut_randomly(genus2_solid(14), 6, seed), strict});
  Options paper;
  paper.mode = PruneMode::paper;
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u})
    scenes.push_back(
        {"gyroid by 8, set " + std::to_string(seed), cut_randomly(gyroid_solid(12), 8, seed), paper});
  return scenes;
}

}  // namespace

TEST_CASE("with plates no section is bare, and the solid meets each plane in its section") {
  std::size_t regions = 0;
  for (Scene& scene : flat_scenes()) {
    CAPTURE(scene.name);
    const Reconstruction before = run(scene.sections, {}, scene.options);
    scene.options.thicken = 2e-3;
    SectionJudge judge;
    const auto result = reconstruct(scene.sections, scene.options, {}, &judge);
    REQUIRE(result.ok());
    const Reconstruction& r = *result;
    CHECK(judge.complaint() == "");
    for (const double area : judge.flat_area) CHECK(area == 0);
    CHECK(r.report.flat_area == 0);
    CHECK(r.report.flat_regions == 0);
    CHECK(r.report.thickened_regions >= before.report.flat_regions);
    CHECK((r.report.thickened_regions > 0) == (before.report.flat_regions > 0));
    CHECK(r.report.thickness <= 2e-3 * r.report.diagonal);
    CHECK(r.report.volume >= before.report.volume);
    CHECK(r.report.volume <= before.report.volume + before.report.flat_area * r.report.thickness * 1.0001);
    const CheckReport surface = check_surface(r.surface);
    CHECK(surface.good_topology());
    CHECK(surface.crossings == 0);
    CHECK(surface.overlaps == 0);
    CHECK(surface.inverted == 0);
    SectionCheckOptions close;
    close.on_plane = 1e-12;
    const SectionCheck met = check_sections(r.surface, r.sections, close);
    CHECK(met.difference_area <= 1e-9 * met.section_area);
    regions += before.report.flat_regions;
  }
  MESSAGE(regions << " flat regions");
  CHECK(regions > 20);
}

TEST_CASE("without plates they are left out and told of") {
  const Reconstruction r = run(one_plane());
  CHECK(r.surface.triangles.empty());
  CHECK(r.report.flat_regions > 0);
  CHECK(r.report.thickened_regions == 0);
  CHECK(r.report.warnings.size() == 1);
}

TEST_CASE("plates do not depend on the order of the input nor on threads") {
  for (const Scene& scene : flat_scenes()) {
    CAPTURE(scene.name);
    Options options = scene.options;
    options.thicken = 1e-2;
    const Reconstruction one = run(scene.sections, {}, options);
    Context context;
    context.threads = 2;
    const auto two = reconstruct(shuffled(scene.sections, 9), options, context);
    REQUIRE(two.ok());
    CHECK(hash(*two) == hash(one));
  }
}
