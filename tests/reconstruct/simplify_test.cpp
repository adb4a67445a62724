/// The pipeline on contours with fewer vertices: every promise holds for the sections as they are then.

#include "../../inspect/check.h"
#include "../../inspect/slice.h"
#include "../../inspect/solids.h"
#include "scenes.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

Options simplify(double tolerance) {
  Options options;
  options.simplify = tolerance;
  return options;
}

std::size_t vertices_of(const Sections& sections) {
  std::size_t count = 0;
  for (const PlaneSection& plane : sections.planes) count += plane.vertices.size();
  return count;
}

/// Returns the volume.
double check_promises(const Reconstruction& r) {
  CHECK(r.report.unmatched.empty());
  const CheckReport report = check_surface(r.surface);
  CHECK(report.good_topology());
  CHECK(report.crossings == 0);
  const SectionCheck conform = check_sections(r.surface, r.sections);
  for (std::size_t p = 0; p < conform.planes.size(); ++p)
    CHECK(conform.planes[p].extra_area + conform.planes[p].missing_area <=
          r.report.planes[p].flat_area + 1e-6 * r.report.section_area);
  return report.volume;
}

}  // namespace

TEST_CASE("a torus and a solid of genus 2: manifold and conforming to the simplified sections") {
  const Surface solids[] = {torus(1, 0.4, 160, 80), genus2_solid(64)};
  for (const Surface& mesh : solids) {
    double sum = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      CAPTURE(mesh.triangles.size());
      CAPTURE(seed);
      const auto sections = slice(mesh, random_planes(bounds_of(mesh.points), 12, seed));
      REQUIRE(sections.ok());
      const auto all = reconstruct(*sections), few = reconstruct(*sections, simplify(1e-3));
      REQUIRE(all.ok());
      REQUIRE(few.ok());
      sum += check_promises(*few);
      CHECK(few->report.simplified_vertices > 0);
      CHECK(few->report.simplify_deviation > 0);
      CHECK(few->report.simplify_deviation <= 1e-3 * few->report.diagonal);
      CHECK(few->report.crossings == all->report.crossings);
      CHECK(few->report.matched_crossings == all->report.matched_crossings);
      CHECK(few->report.disagreeing_vertices == all->report.disagreeing_vertices);
      CHECK(vertices_of(few->sections) < vertices_of(all->sections) * 3 / 4);
    }
    CHECK(sum / 4 == doctest::Approx(check_surface(mesh).volume).epsilon(0.1));
  }
}

TEST_CASE("a stack of slices, where no point of three planes is added: walls that replace others are oriented too") {
  const Surface mesh = torus(1, 0.4, 60, 30);
  const auto sections = slice(mesh, parallel_planes(bounds_of(mesh.points), 6));
  REQUIRE(sections.ok());
  const auto r = reconstruct(*sections, simplify(1e-3));
  REQUIRE(r.ok());
  CHECK(r->report.simplified_vertices > 0);
  CHECK(check_promises(*r) > 0);
}

TEST_CASE("the same bytes for any order of the input and any number of threads") {
  const std::uint64_t seed = 21;
  CAPTURE(seed);
  for (const char* name : {"demo.contour", "figures/fig14p.contour", "figures/fig17_cross.contour"}) {
    CAPTURE(std::string(name));
    const Sections sections = load(name);
    const auto reference = reconstruct(sections, simplify(1e-3));
    REQUIRE(reference.ok());
    CHECK(reference->report.simplified_vertices > 0);
    for (std::uint64_t round = 0; round < 4; ++round) {
      Context context;
      context.threads = round % 2 == 0 ? 2 : 1;
      const auto r = reconstruct(shuffled(sections, seed + round), simplify(1e-3), context);
      REQUIRE(r.ok());
      CHECK(hash(*r) == hash(*reference));
    }
  }
}

TEST_CASE("a tolerance too small for any vertex changes nothing; one that is none is refused") {
  const Sections sections = load("demo.contour");
  const auto plain = reconstruct(sections), tiny = reconstruct(sections, simplify(1e-15));
  REQUIRE(plain.ok());
  REQUIRE(tiny.ok());
  CHECK(tiny->report.simplified_vertices == 0);
  CHECK(hash(*tiny) == hash(*plain));
  for (const double bad : {-1.0, 2.0, static_cast<double>(NAN)}) {
    const auto r = reconstruct(sections, simplify(bad));
    REQUIRE_FALSE(r.ok());
    CHECK(r.error().code == ErrorCode::usage);
  }
}
