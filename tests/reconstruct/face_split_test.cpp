/// Splits of contour edges, against a search through all vertices of the face.

#include "../../reconstruct/face_split.h"

#include <algorithm>
#include <cmath>

#include "../../geom/lattice_rounding.h"
#include "../arrangement/built_graph.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

void add_ring(PlaneSection& plane, double radius, std::uint32_t count, std::uint32_t contour) {
  const auto first = static_cast<std::uint32_t>(plane.vertices.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * i / count;
    plane.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    plane.edges.push_back({first + i, first + (i + 1) % count, 1, 0, contour, 0});
  }
}

/// No vertex in the closed triangle a, b, c but a and b.
bool is_free(const LatticePlane& plane, const std::vector<LatticePoint>& points, std::uint32_t a,
             std::uint32_t b, const LatticePoint& c) {
  const LatticePoint &p = points[a], &q = points[b];
  const int turn = orient2d(plane, p, q, c);
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    const LatticePoint& x = points[v];
    if (v == a || v == b) continue;
    if (equal(x, c)) return false;
    if (turn != 0 && orient2d(plane, p, q, x) * turn >= 0 && orient2d(plane, q, c, x) * turn >= 0 &&
        orient2d(plane, c, p, x) * turn >= 0)
      return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a split is the candidate nearest to its place that sweeps over no vertex, old or new") {
  // A ring of few long edges, with rings of many short ones so near that only some candidates are free.
  Sections sections;
  PlaneSection& plane = sections.planes.emplace_back();
  plane.normal = {0, 0, 1};
  constexpr std::uint32_t kEdges = 60;
  add_ring(plane, 1, kEdges, 0);
  add_ring(plane, 1.01, 7 * kEdges, 1);
  add_ring(plane, 0.98, 5 * kEdges, 2);
  const Built built = build(sections);
  REQUIRE(built.graph.ok());
  const SectionGraph& graph = *built.graph;
  std::vector<LatticePoint> points = graph.points;
  const std::vector<Wall>& walls = graph.walls[0];
  const auto location = graph.wall_locations[0][0];
  REQUIRE(location.dimension == 2);
  FaceSplitter splitter(graph, *built.arrangement, FaceId{location.index}, 0, walls, points);
  const OpenFace face(graph, *built.arrangement, FaceId{location.index});
  const LatticePlane& in = graph.planes[0];
  std::size_t made = 0, second_best = 0;
  for (const double t : {0.5, 0.25, 0.75, 0.001, 0.999, 1e-9, 0.5})
    for (std::uint32_t w = 0; w < walls.size(); ++w) {
      const SplitRequest request{w, walls[w].a, walls[w].b, false, false, t};
      const std::vector<LatticePoint> before = points;
      const std::uint32_t split = splitter(request);
      const LatticePoint &from = before[request.from], &to = before[request.to];
      const Vec3 target = real(from) + t * (real(to) - real(from));
      const auto [u0, v0] = nearest_coordinates(in, target);
      std::vector<LatticePoint> candidates;
      for (std::int64_t u = u0 - 2; u <= u0 + 2; ++u)
        for (std::int64_t v = v0 - 2; v <= v0 + 2; ++v) candidates.push_back(plane_point(in, u, v));
      std::sort(candidates.begin(), candidates.end(), [&](const auto& x, const auto& y) {
        const double a = norm(real(x) - target), b = norm(real(y) - target);
        return a != b ? a < b : compare_lex(x, y) < 0;
      });
      const int inside = walls[w].inside_left ? 1 : -1;
      const auto good = std::find_if(candidates.begin(), candidates.end(), [&](const LatticePoint& c) {
        return orient2d(in, from, to, c) * inside <= 0 && face.contains(c) &&
               is_free(in, before, request.from, request.to, c);
      });
      CHECK((split == kNone) == (good == candidates.end()));
      if (split == kNone) continue;
      REQUIRE(split == before.size());
      REQUIRE(points.size() == before.size() + 1);
      CHECK(equal(points[split], *good));
      ++made;
      second_best += good != candidates.begin() ? 1U : 0U;
    }
  MESSAGE(made << " splits, " << second_best << " not at the nearest place");
  CHECK(made > 3000);
  CHECK(second_best > 500);
}
