/// What crosses because coordinates are rounded comes apart.

#include "../../reconstruct/mend.h"

#include <algorithm>
#include <atomic>

#include "../../geom/triangle_meeting.h"
#include "../../inspect/check.h"
#include "../../inspect/random.h"
#include "../../reconstruct/merge_places.h"
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

/// All pairs of triangles that cross or overlap, ascending.
std::vector<std::array<std::uint32_t, 2>> find_crossings(const Surface& surface) {
  const auto corners = [&](std::uint32_t t) {
    const auto& c = surface.triangles[t];
    return Corners{surface.points[c[0]], surface.points[c[1]], surface.points[c[2]]};
  };
  std::vector<std::array<std::uint32_t, 2>> found;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    for (std::uint32_t s = 0; s < t; ++s)
      if (meeting(corners(s), corners(t)) != Meeting::none) found.push_back({s, t});
  std::sort(found.begin(), found.end());
  return found;
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
  Mending none = mend_crossings(surface, origins, {rounded, {}});
  CHECK(none.found == 0);  // no vertex is rounded, so nothing is asked
  CHECK(surface.points == before.points);
  rounded[4] = 1;
  const Mending mending = mend_crossings(surface, origins, {rounded, {}});
  CHECK(mending.found > 0);
  CHECK(mending.left == 0);
  CHECK(mending.moved == 1);
  CHECK(mending.largest > 0);
  CHECK(mending.largest <= 0x1p-45);
  CHECK(check_surface(surface).crossings == 0);
  for (std::uint32_t v = 0; v < before.points.size(); ++v)
    if (v != 4) CHECK(surface.points[v] == before.points[v]);
}

TEST_CASE("a raised flag ends the search for crossings") {
  Surface surface = cube();
  append(surface, cube(0.5, 1.5));
  const std::vector<std::uint8_t> rounded(surface.points.size(), 1);
  const std::vector<SurfaceVertex> origins = own_origins(surface);
  const std::atomic<bool> flag{true};
  Context context;
  context.cancel = &flag;
  const Surface before = surface;
  CHECK(mend_crossings(surface, origins, {rounded, {}}, context).found == 0);
  CHECK(surface.points == before.points);
  CHECK(mend_crossings(surface, origins, {rounded, {}}).found > 0);
}

TEST_CASE("what lies too deep for short moves is merged") {
  Surface surface = tetrahedron({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4});
  append(surface, tetrahedron({1, 1, 1}, {0, 0, -4}, {4, 0, -4}, {0, 4, -4}));
  const std::vector<std::uint8_t> rounded(surface.points.size(), 1);
  const Mending mending = mend_crossings(surface, own_origins(surface), {rounded, {}});
  CHECK(mending.left > 0);
  CHECK(mending.merged > 0);
  CHECK(mending.merged <= mending.moved);
  const CheckReport after = check_surface(surface);
  CHECK(after.good_topology());
  CHECK(after.crossings + after.overlaps == 0);
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

TEST_CASE("however much crosses, merging ends without a crossing, and by index nothing changes") {
  // Tetrahedra thrown together: everything crosses everything.
  constexpr MergingEffort kEfforts[] = {{}, {1000, 1U << 20}, {0, 1U << 20}, {1000, 5000}, {0, 0}};
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const auto place = [&] { return Vec3{random.uniform(), random.uniform(), random.uniform()}; };
    Surface surface;
    for (int i = 0; i < 12; ++i) append(surface, tetrahedron(place(), place(), place(), place()));
    REQUIRE(check_surface(surface).crossings > 0);
    const Surface before = surface;
    const auto found = find_crossings(surface);
    CHECK(found.size() == check_surface(before).crossings + check_surface(before).overlaps);
    const Merging merging = merge_crossing_places(surface, found, {}, {}, kEfforts[seed % 5]);
    const CheckReport after = check_surface(surface);
    CHECK(after.crossings + after.overlaps == 0);
    CHECK(surface.triangles == before.triangles);
    std::uint32_t moved = 0;
    for (std::size_t v = 0; v < before.points.size(); ++v) {
      moved += surface.points[v] != before.points[v];
      CHECK(std::find(before.points.begin(), before.points.end(), surface.points[v]) != before.points.end());
    }
    CHECK(moved == merging.merged);
    CHECK(merging.merged < before.points.size());
  }
}

TEST_CASE("the nearest merge that helps is taken, and all that is at its place goes along") {
  Surface surface = tetrahedron({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4});
  append(surface, tetrahedron({1, 1, 1}, {0, 0, -4}, {4, 0, -4}, {0, 4, -4}));
  append(surface, tetrahedron({1, 1, 1}, {9, 9, 9}, {9, 8, 9}, {8, 9, 9}));
  const Surface before = surface;
  const Merging merging = merge_crossing_places(surface, find_crossings(surface));
  CHECK(check_surface(surface).crossings == 0);
  CHECK(merging.merged > 0);
  CHECK(surface.points[4] == surface.points[8]);
}

TEST_CASE("a place with an exact point stays if another corner can go") {
  Surface surface = tetrahedron({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4});
  append(surface, tetrahedron({1, 1, 1}, {0, 0, -4}, {4, 0, -4}, {0, 4, -4}));
  const Surface before = surface;
  merge_crossing_places(surface, find_crossings(surface));
  std::vector<std::uint8_t> exact(8, 0);
  for (std::size_t v = 0; v < 8; ++v) exact[v] = surface.points[v] != before.points[v] ? 1 : 0;
  REQUIRE(std::count(exact.begin(), exact.end(), 1) > 0);
  surface = before;
  CHECK(merge_crossing_places(surface, find_crossings(surface), exact).merged > 0);
  CHECK(find_crossings(surface).empty());
  for (std::size_t v = 0; v < 8; ++v)
    if (exact[v] != 0) CHECK(surface.points[v] == before.points[v]);
  surface = before;  // now all of them are exact, and one has to go
  const Merging all = merge_crossing_places(surface, find_crossings(surface), std::vector<std::uint8_t>(8, 1));
  CHECK(find_crossings(surface).empty());
  CHECK(all.merged > 0);
}

// Where too much was to be asked clusters collapsed: 1302 vertices of these took the places of others.
TEST_CASE("needles along one line come apart by short merges") {
  Random random(7);
  Surface surface;
  const auto near = [&] { return 1e-3 * Vec3{random.uniform(), random.uniform(), random.uniform()}; };
  for (int i = 0; i < 500; ++i) {
    const double x = 0.1 + 0.8 * random.uniform();
    const Vec3 tip = Vec3{x, x, x} + near();
    append(surface, tetrahedron({0, 0, 0}, {1, 1, 1}, tip, tip + 0.1 * near()));
  }
  REQUIRE(find_crossings(surface).size() > 10000);
  const Merging merging = merge_crossing_places(surface, find_crossings(surface));
  CHECK(find_crossings(surface).empty());
  CHECK(merging.merged < 1000);
}
