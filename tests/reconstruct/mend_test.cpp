/// What crosses because coordinates are rounded comes apart.

#include "../../reconstruct/mend.h"

#include "../../inspect/check.h"
#include "../inspect/shapes.h"
#include "shown.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

/// The same scene so far from the origin that doubles are coarse there.
Sections far_away(Sections sections, const Vec3& by) {
  for (PlaneSection& plane : sections.planes) {
    for (Vec3& v : plane.vertices) v = v + by;
    plane.offset -= dot(plane.normal, by);
  }
  return sections;
}

std::vector<SurfaceVertex> own_origins(const Surface& surface) {
  std::vector<SurfaceVertex> origins;
  for (std::uint32_t v = 0; v < surface.points.size(); ++v) origins.push_back({v, kNone});
  return origins;
}

}  // namespace

TEST_CASE("a tip that rounding pushed through a facet goes back") {
  Surface surface = tetrahedron({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4});
  append(surface, tetrahedron({1, 1, -0x1p-50}, {0, 0, -4}, {4, 0, -4}, {0, 4, -4}));
  surface.points[4].z = 0x1p-50;
  REQUIRE(check_surface(surface).crossings > 0);
  std::vector<std::uint8_t> rounded(surface.points.size(), 0);
  const std::vector<SurfaceVertex> origins = own_origins(surface);
  const Surface before = surface;
  Mending none = mend_crossings(surface, origins, rounded);
  CHECK(none.found == 0);  // no vertex is rounded, so nothing is asked
  CHECK(surface.points == before.points);
  rounded[4] = 1;
  const Mending mending = mend_crossings(surface, origins, rounded);
  CHECK(mending.found > 0);
  CHECK(mending.left == 0);
  CHECK(mending.moved == 1);
  CHECK(mending.largest > 0);
  CHECK(mending.largest <= 0x1p-45);
  CHECK(check_surface(surface).crossings == 0);
  for (std::uint32_t v = 0; v < before.points.size(); ++v)
    if (v != 4) CHECK(surface.points[v] == before.points[v]);
}

TEST_CASE("what lies too deep is left and counted") {
  Surface surface = tetrahedron({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4});
  append(surface, tetrahedron({1, 1, 1}, {0, 0, -4}, {4, 0, -4}, {0, 4, -4}));
  const std::vector<std::uint8_t> rounded(surface.points.size(), 1);
  const Mending mending = mend_crossings(surface, own_origins(surface), rounded);
  CHECK(mending.left > 0);
  const CheckReport after = check_surface(surface);
  CHECK(after.crossings + after.overlaps == mending.left);
}

// Before mending: 19 crossings in the first, 4 in the second, 18 and 2 overlaps in the third.
TEST_CASE("figures far from the origin, where rounding makes triangles cross") {
  struct Far {
    const char* name;
    double distance;
  };
  for (const Far& far : {Far{"figures/fig17_cross.contour", 1e12}, Far{"figures/fig17_cross.contour", 1e11},
                         Far{"demo.contour", 1e12}}) {
    CAPTURE(std::string(far.name));
    CAPTURE(far.distance);
    const Reconstruction r = run(far_away(load(far.name), far.distance * Vec3{1.3, 2.7, -3.1}));
    CHECK(r.report.crossing_pairs > 0);
    CHECK(r.report.crossing_pairs_left == 0);
    CHECK(r.report.mended_vertices > 0);
    const CheckReport surface = check_surface(r.surface);
    CHECK(surface.good_topology());
    CHECK(surface.crossings == 0);
    CHECK(surface.overlaps == 0);
  }
}

TEST_CASE("near the origin rounding makes nothing cross, and nothing moves") {
  for (const Scene& scene : small_scenes()) {
    CAPTURE(scene.name);
    const Reconstruction r = run(scene.sections, {}, scene.options);
    CHECK(r.report.crossing_pairs == 0);
    CHECK(r.report.mended_vertices == 0);
    CHECK(check_surface(r.surface).crossings == 0);
  }
}
