/// Flat regions as thin plates: the solid meets each plane in its section, whole.

#include "../../inspect/check.h"
#include "../arrangement/polygon_sections.h"
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
    CHECK(met.difference_area() <= 1e-9 * met.section_area);
    regions += before.report.flat_regions;
  }
  MESSAGE(regions << " flat regions");
  CHECK(regions > 20);
}

// Over a needle between two planes 1e-9 apart solid leaves room of some thousand units of the grid, less than
// what 24 halvings of the height had come to.
TEST_CASE("a plate fits into a narrow wedge between solid and section") {
  Options options;
  options.thicken = 0.01;
  const auto r = reconstruct(load("plate_in_a_wedge.contour", "/tests/reconstruct/cases/"), options);
  REQUIRE(r.ok());
  CHECK(r->report.thickened_regions > 0);
  CHECK(r->report.flat_area == 0);
  CHECK(check_surface(r->surface).good_topology());
}

// Solid that goes up to points inside a cell 15,000 units of the grid thick leans over a needle 11,500 units
// wide by 3e-10: no grid point over it was under that solid.
TEST_CASE("a needle under solid that leans by less than the grid gets a plate towards its corner") {
  const Sections sections = load("plate_under_leaning_solid.contour", "/tests/reconstruct/cases/");
  SectionJudge bare;
  REQUIRE(reconstruct(sections, Options{}, {}, &bare).ok());
  CHECK(bare.complaint() == "");
  for (const double height : {1e-2, 1e-12}) {  // the corner: 5e-11
    CAPTURE(height);
    Options options;
    options.thicken = height;
    SectionJudge judge(bare);
    const auto r = reconstruct(sections, options, {}, &judge);
    REQUIRE(r.ok());
    CHECK(judge.complaint() == "");
    CHECK(judge.widest_flat == 0);
    CHECK(r->report.flat_area == 0);
    CHECK(r->report.thickness <= height * r->report.diagonal);
    CHECK(check_surface(r->surface).good_topology());
  }
}

// Two needles with plates 1e-9 high: what doubles made of their volume was -1e-14.
TEST_CASE("the volume of thin plates over needles is not negative") {
  Options options;
  options.mode = PruneMode::paper;
  options.thicken = 1e-9;
  const auto r = reconstruct(load("plates_over_needles.contour", "/tests/reconstruct/cases/"), options);
  REQUIRE(r.ok());
  CHECK(r->report.thickened_regions == 2);
  CHECK(r->report.volume >= 0);
}

namespace {

/// A disk whose upright neighbour ends half way across it.
Sections disagreeing_disks() {
  Sections sections{"", {disk({0, 0, 1}, {0, 0, 0}, 1, 12), disk({0, 0, 1}, {0, 0, 1}, 1, 12)}};
  sections.planes.push_back(plane_at({1, 0, 0}, {0.1, 0, 0}));
  add_contour(sections.planes.back(), {{0.1, -1, -0.5}, {0.1, 0.5, -0.5}, {0.1, 0.5, 1.5}, {0.1, -1, 1.5}});
  return sections;
}

/// Shows the judge tetrahedra that there are not: at each side of each plate's base one that stands on this side
/// alone.
class Forger : public SectionJudge {
 public:
  Forger(const SectionJudge& bare, std::size_t points) : SectionJudge(bare), points_(points) {}
  std::size_t forged = 0;

  void on_solid(std::span<const test::Tet> solid, const Numbering& numbering) override {
    const auto raised = static_cast<std::uint32_t>(numbering.points.size() - 1);
    std::vector<test::Tet> tets(solid.begin(), solid.end());
    const auto is_corner = [&](std::uint32_t v) { return v < points_; };
    for (test::Tet t : solid) {
      std::partition(t.begin(), t.end(), is_corner);
      if (std::count_if(t.begin(), t.end(), is_corner) != 3 || t[3] == raised) continue;
      for (const auto& e : {test::Edge{t[0], t[1]}, test::Edge{t[1], t[2]}, test::Edge{t[2], t[0]}}) {
        const auto p = [&](std::uint32_t v) { return numbering.points[v]; };
        const int turn = orient3d(p(e[0]), p(e[1]), p(t[3]), p(raised));
        if (turn > 0) tets.push_back({e[0], e[1], t[3], raised});
        if (turn < 0) tets.push_back({e[1], e[0], t[3], raised});
        forged += turn != 0;
      }
    }
    SectionJudge::on_solid(tets, numbering);
  }

 private:
  std::size_t points_;  ///< of the run without plates
};

}  // namespace

TEST_CASE("where sections disagree on a common line a plate has what one has of it, and the judge allows no more") {
  const Sections sections = disagreeing_disks();
  Options options;
  SectionJudge bare;
  const auto without = reconstruct(sections, options, {}, &bare);
  REQUIRE(without.ok());
  CHECK(bare.complaint() == "");
  CHECK(bare.widest_flat > 0);
  options.thicken = 0.01;
  SectionJudge thick(bare);
  const auto r = reconstruct(sections, options, {}, &thick);
  REQUIRE(r.ok());
  CHECK(thick.complaint() == "");
  CHECK(thick.plate_edges_outside > 0);
  CHECK(thick.widest_flat == 0);
  CHECK(r->report.flat_area == 0);

  const auto said_of = [&](SectionJudge&& judge) {
    REQUIRE(reconstruct(sections, options, {}, &judge).ok());
    return judge.complaint();
  };
  const auto is_edge_outside = [](const std::string& said) {
    return said.find("an edge of the solid lies outside") != std::string::npos;
  };
  CHECK(is_edge_outside(said_of(SectionJudge())));       // no plates were to be expected
  CHECK(is_edge_outside(said_of(SectionJudge(thick))));  // nor where nothing was flat
  Forger forger(bare, without->solid.points.size());
  REQUIRE(reconstruct(sections, options, {}, &forger).ok());
  CHECK(forger.forged > 0);
  CHECK(is_edge_outside(forger.complaint()));
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
