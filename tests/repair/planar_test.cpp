// The planar grid, snap rounding, and sections combined on it.
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <set>

#include "../../inspect/random.h"
#include "../../repair/overlay.h"
#include "../../repair/planar_lattice.h"
#include "../../repair/section_edit.h"
#include "../../repair/snap_rounding.h"
#include "../arrangement/polygon_sections.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

PlanarPoint random_point(Random& random, std::int64_t size) {
  const auto at = [&] {
    return static_cast<std::int64_t>(random.next() % static_cast<std::uint64_t>(2 * size + 1)) - size;
  };
  const std::int64_t x = at();
  return {x, at()};
}

/// Even-odd by a ray to the right. REQUIRES: the point is not on a wall.
bool inside(const std::vector<OverlaySegment>& walls, std::uint32_t layer, double x, double y) {
  bool in = false;
  for (const OverlaySegment& w : walls) {
    if (w.layer != layer) continue;
    const auto ax = static_cast<double>(w.a.x), ay = static_cast<double>(w.a.y),
               bx = static_cast<double>(w.b.x), by = static_cast<double>(w.b.y);
    if ((ay > y) == (by > y)) continue;
    if (x < ax + (y - ay) / (by - ay) * (bx - ax)) in = !in;
  }
  return in;
}

std::vector<OverlaySegment> random_loop(Random& random, std::uint32_t layer, int corners, std::int64_t size) {
  std::vector<PlanarPoint> points;
  for (int c = 0; c < corners; ++c) points.push_back(random_point(random, size));
  std::vector<OverlaySegment> loop;
  for (std::size_t c = 0; c < points.size(); ++c)
    loop.push_back({points[c], points[(c + 1) % points.size()], layer});
  return loop;
}

}  // namespace

TEST_CASE("a chart goes there and back, and does not depend on the side of the normal") {
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const Vec3 n = random.direction(), middle = 3 * random.direction();
    const double offset = -dot(n, middle) + random.uniform(-0.2, 0.2);
    const PlaneChart chart(n, offset, middle, 2), turned(-n, -offset, middle, 2);
    const PlanarPoint p = random_point(random, kPlanarLimit / 2);
    CHECK(chart.to_grid(chart.to_space(p)) == p);
    CHECK(turned.to_space(p) == chart.to_space(p));
    CHECK(std::fabs(dot(n, chart.to_space(p)) + offset) < 1e-14);
    const Vec3 q = chart.to_space(p) + (0.3 * chart.step()) * random.direction();
    CHECK(norm(chart.to_space(chart.to_grid(q)) - q) < chart.step());
  }
}

TEST_CASE("crossings are rounded exactly") {
  CHECK(crossing_point({0, 0}, {4, 4}, {0, 4}, {4, 0}) == PlanarPoint{2, 2});
  CHECK(crossing_point({0, 0}, {1, 1}, {0, 1}, {1, 0}) == PlanarPoint{1, 1});      // a half goes up
  CHECK(crossing_point({0, 0}, {-1, -1}, {0, -1}, {-1, 0}) == PlanarPoint{0, 0});  // below 0, too
  Random random(11);
  for (int i = 0; i < 2000; ++i) {
    const std::int64_t size = i % 2 ? 20 : kPlanarLimit;
    const PlanarPoint a = random_point(random, size), b = random_point(random, size),
                      c = random_point(random, size), d = random_point(random, size);
    if (!cross(a, b, c, d)) continue;
    const PlanarPoint p = crossing_point(a, b, c, d);
    CHECK(p == crossing_point(c, d, a, b));
    CHECK(p == crossing_point(b, a, d, c));
    CHECK(passes(a, b, p));
    CHECK(passes(c, d, p));
  }
}

TEST_CASE("a segment passes the squares that it meets") {
  CHECK(passes({0, 0}, {10, 0}, {5, 0}));
  CHECK(passes({0, 0}, {10, 1}, {5, 0}));
  CHECK(passes({0, 0}, {10, 1}, {5, 1}));
  CHECK_FALSE(passes({0, 0}, {10, 0}, {5, 1}));
  CHECK_FALSE(passes({0, 0}, {10, 0}, {11, 0}));
  CHECK_FALSE(passes({0, 0}, {4, 4}, {0, 2}));
}

TEST_CASE("after snap rounding pieces meet at grid points alone, and rounding again changes nothing") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<PlanarSegment> segments;
    const std::int64_t size = seed % 3 == 0 ? 12 : seed % 3 == 1 ? 1000 : kPlanarLimit;
    for (int s = 0; s < 40; ++s) segments.push_back({random_point(random, size), random_point(random, size)});
    const std::vector<SegmentPiece> pieces = snap_round(segments);
    std::map<std::uint32_t, PlanarPoint> last;
    for (const SegmentPiece& p : pieces) {
      // The pieces of a segment are a chain from its beginning to its end.
      if (last.count(p.segment) == 0) last[p.segment] = segments[p.segment][0];
      CHECK(p.a == last[p.segment]);
      last[p.segment] = p.b;
      int crossed = 0, passed = 0;
      for (const SegmentPiece& q : pieces) {
        crossed += cross(p.a, p.b, q.a, q.b);
        for (const PlanarPoint e : {q.a, q.b}) passed += e != p.a && e != p.b && passes(p.a, p.b, e);
      }
      CHECK(crossed == 0);
      CHECK(passed == 0);
    }
    for (const auto& [s, end] : last) CHECK(end == segments[s][1]);
    std::vector<PlanarSegment> again;
    for (const SegmentPiece& p : pieces) again.push_back({p.a, p.b});
    CHECK(snap_round(again).size() == again.size());
  }
}

TEST_CASE("a raised flag ends the rounding, and an edit changes nothing then") {
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  const std::vector<PlanarSegment> crossed{{PlanarPoint{0, 0}, PlanarPoint{8, 8}},
                                           {PlanarPoint{0, 8}, PlanarPoint{8, 0}}};
  CHECK(snap_round(crossed).size() == 4);
  CHECK(snap_round(crossed, context).size() == 2);
  std::vector<OverlaySegment> segments;
  for (const PlanarSegment& s : crossed) segments.push_back({s[0], s[1], 0});
  CHECK(overlay(segments, std::vector{LayerKind::section}, context).empty());
  PlaneSection section = disk({0, 0, 1}, {0, 0, 0}, 1, 12);
  const PlaneSection before = section;
  const Patch patch{LayerKind::added, {{0.5, 0, 0}, {2, -0.1, 0}, {2, 0.1, 0}}, std::vector<bool>(3, false)};
  const PlaneChart chart({0, 0, 1}, 0, {0, 0, 0}, 4);
  CHECK_FALSE(edit_section(section, chart, {&patch, 1}, {}, context).changed);
  CHECK(section.vertices == before.vertices);
  CHECK(section.edges.size() == before.edges.size());
  CHECK(edit_section(section, chart, {&patch, 1}).changed);
}

// A vertex that the section has there was taken by its own edge, and the patch made another one.
TEST_CASE("edges of a section and of a patch end at one vertex") {
  PlaneSection section = plane_at({0, 0, 1}, {0, 0, 0});
  add_contour(section, square(0, 0, 0, 1));
  const std::vector<Patch> patches{
      {LayerKind::removed, {{1, 1, 0}, {-0.5, 2, 0}, {-0.5, 0, 0}}, std::vector<bool>(3, true)},
      {LayerKind::removed, {{2, 0.2, 0}, {0.5, 0, 0}, {2, -0.2, 0}}, std::vector<bool>(3, false)}};
  const PlaneChart chart({0, 0, 1}, 0, {0, 0, 0}, 4);
  REQUIRE(edit_section(section, chart, patches).changed);
  std::set<Vec3> places;
  std::set<std::uint32_t> vertices;
  for (const ContourEdge& e : section.edges)
    for (const std::uint32_t v : {e.a, e.b}) vertices.insert(v), places.insert(section.vertices[v]);
  CHECK(vertices.size() == places.size());
}

TEST_CASE("an overlay is inside where its layers say so") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    std::vector<OverlaySegment> segments;
    const std::vector<LayerKind> kinds{LayerKind::section, LayerKind::added, LayerKind::removed,
                                       LayerKind::section};
    for (std::uint32_t layer = 0; layer < kinds.size(); ++layer)
      for (const OverlaySegment& s : random_loop(random, layer, 5, 1000000)) segments.push_back(s);
    const std::vector<OverlayEdge> edges = overlay(segments, kinds);
    std::vector<OverlaySegment> walls;
    std::map<PlanarPoint, int> degree;
    for (const OverlayEdge& e : edges) {
      walls.push_back({e.a, e.b, 0});
      ++degree[e.a], ++degree[e.b];
    }
    for (const auto& [p, d] : degree) CHECK(d % 2 == 0);
    for (int i = 0; i < 300; ++i) {
      const double x = random.uniform(-1e6, 1e6), y = random.uniform(-1e6, 1e6);
      const auto in = [&](std::uint32_t layer) { return inside(segments, layer, x, y); };
      CHECK(inside(walls, 0, x, y) == ((in(0) || in(1) || in(3)) && !in(2)));
    }
  }
}

TEST_CASE("an edited section keeps its other edges and vertices, and fixed corners are taken as they are") {
  PlaneSection section = disk({1, 2, 3}, {0.1, 0.2, 0.3}, 1, 40);
  const PlaneSection before = section;
  const Vec3 n = unit({1, 2, 3});
  const PlaneChart chart(n, section.offset / norm(section.normal), {0.1, 0.2, 0.3}, 3);
  const Vec3 v = section.vertices[3];
  Patch patch{LayerKind::added, {}, {}};
  const Vec3 out = unit(v - Vec3{0.1, 0.2, 0.3}), aside = cross(n, out);
  for (const Vec3 d : {0.2 * out, 0.05 * aside, -0.2 * out, -0.05 * aside}) {
    patch.corners.push_back(v + d);
    patch.fixed.push_back(true);
  }
  const SectionEdit edit = edit_section(section, chart, {&patch, 1});
  CHECK(edit.changed);
  CHECK(edit.contours == std::vector<std::uint32_t>{0});
  CHECK(std::count(section.vertices.begin(), section.vertices.end(), v + 0.2 * out) == 1);
  for (std::size_t k = 0; k < before.vertices.size(); ++k) CHECK(section.vertices[k] == before.vertices[k]);
  std::size_t kept = 0;
  for (const ContourEdge& e : before.edges)
    kept += static_cast<std::size_t>(std::count_if(section.edges.begin(), section.edges.end(),
                                                   [&](const auto& f) { return f.a == e.a && f.b == e.b; }));
  CHECK(kept == 38);
  const PlaneSection once = section;
  CHECK_FALSE(edit_section(section, chart, {&patch, 1}).changed);
  CHECK(section.vertices == once.vertices);
  tidy_section(section);
  CHECK(section.vertices.size() == 39 + 5);
  for (const ContourEdge& e : section.edges) CHECK(e.contour == 0);
}
