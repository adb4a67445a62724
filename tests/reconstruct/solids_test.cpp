/// Known solids, cut and reconstructed.

#include "../../inspect/check.h"
#include "../../inspect/slice.h"
#include "../../inspect/solids.h"
#include "scenes.h"

using namespace crossloft;
using namespace crossloft::test;

TEST_CASE("a torus by ten random planes: volume, topology, conformity") {
  const Surface mesh = torus(1, 0.4, 80, 40);
  const double truth = check_surface(mesh).volume;
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    const auto sections = slice(mesh, random_planes(bounds_of(mesh.points), 10, seed));
    REQUIRE(sections.ok());
    const auto r = reconstruct(*sections);
    REQUIRE(r.ok());
    CHECK(r->report.unmatched.empty());
    const CheckReport report = check_surface(r->surface);
    CHECK(report.good_topology());
    CHECK(report.crossings == 0);
    const SectionCheck conform = check_sections(r->surface, r->sections);
    for (std::size_t p = 0; p < conform.planes.size(); ++p)
      CHECK(conform.planes[p].extra_area + conform.planes[p].missing_area <=
            r->report.planes[p].flat_area + 1e-6 * r->report.section_area);
    sum += report.volume / truth;
  }
  CHECK(sum / 20 >= 0.92);
  MESSAGE("mean volume ratio " << sum / 20);
}
