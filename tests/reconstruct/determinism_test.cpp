/// The same input gives the same bytes, however it is told and wherever it runs.

#include "scenes.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

/// Golden: equal for g++ and clang, -O0 and -O3, any thread count. A change of the algorithm changes them; nothing
/// else may.
struct Golden {
  const char* name;
  std::uint64_t joint, natural;
};
const Golden kGolden[] = {
    {"demo.contour", 4284577561112142984u, 11244715811923143432u},  // moves copies apart
    {"figures/fig17_cross.contour", 13553432730895326032u, 16328409599535164268u},
    {"figures/fig17.contour", 11571815104915154071u, 14030934024063924220u},  // takes branching samples
    {"figures/fig19.contour", 7995723605599971474u, 2994461326608789252u},
};

}  // namespace

TEST_CASE("golden bytes") {
  for (const Golden& golden : kGolden) {
    CAPTURE(std::string(golden.name));
    for (const PruneMode mode : {PruneMode::joint, PruneMode::natural}) {
      Options options;
      options.mode = mode;
      const auto r = reconstruct(load(golden.name), options);
      REQUIRE(r.ok());
      CHECK(hash(*r) == (mode == PruneMode::joint ? golden.joint : golden.natural));
    }
  }
}

TEST_CASE("order of planes, vertices and edges, direction of edges and normals, threads: no trace") {
  const std::uint64_t seed = 7;
  CAPTURE(seed);
  for (const char* name : {"demo.contour", "figures/fig14p.contour", "figures/fig16_center.contour", "figures/fig17.contour",
                           "figures/fig19.contour"}) {
    CAPTURE(std::string(name));
    const Sections sections = load(name);
    const auto reference = reconstruct(sections);
    REQUIRE(reference.ok());
    for (std::uint64_t round = 0; round < 4; ++round) {
      Context context;
      context.threads = round % 2 == 0 ? 2 : 1;
      const auto r = reconstruct(shuffled(sections, seed + round), {}, context);
      REQUIRE(r.ok());
      CHECK(hash(*r) == hash(*reference));
    }
  }
}

TEST_CASE("a power of two in scale and a shift on the grid change nothing but the numbers") {
  for (const char* name : {"figures/fig17_cross.contour", "demo.contour"})
    for (const double factor : {0x1p40, 0x1p-40}) {
      CAPTURE(std::string(name));
      CAPTURE(factor);
      const Sections sections = load(name);
      const auto reference = reconstruct(sections);
      REQUIRE(reference.ok());
      Sections scaled = sections;
      for (PlaneSection& plane : scaled.planes) {
        plane.offset *= factor;
        for (Vec3& p : plane.vertices) p = factor * p;
      }
      const auto r = reconstruct(scaled);
      REQUIRE(r.ok());
      REQUIRE(r->surface.triangles == reference->surface.triangles);
      for (std::size_t v = 0; v < r->surface.points.size(); ++v)
        CHECK(r->surface.points[v] == factor * reference->surface.points[v]);
      CHECK(r->report.separation == factor * reference->report.separation);
    }
}
