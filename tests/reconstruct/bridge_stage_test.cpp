/// What the whole solid owes to bridges.
#include <map>

#include "../../inspect/check.h"
#include "../arrangement/polygon_sections.h"
#include "../fuzz/section_judge.h"
#include "shown.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

/// Tetrahedra of the solid at an edge, in groups that hang together through triangles with it.
struct Wedges {
  std::size_t with_section = 0, without = 0;  ///< by whether a section triangle at the edge is theirs
  bool all_triangles = true;                  ///< every section triangle at the edge has a tetrahedron
};

Wedges wedges_at(const Edge& edge, const std::vector<Tet>& tets, const std::vector<Triangle>& section) {
  std::map<Triangle, std::vector<std::size_t>> at;
  for (std::size_t k = 0; k < tets.size(); ++k)
    for (unsigned i = 0; i < 4; ++i)
      if (const Triangle f = facet_of(tets[k], i); has(f, edge)) at[f].push_back(k);
  Groups groups(tets.size());
  for (const auto& [triangle, sides] : at) groups.put_together(sides.front(), sides.back());
  Wedges wedges;
  std::set<std::size_t> with;
  for (const Triangle& t : section) {
    if (at.count(t) == 0) {
      wedges.all_triangles = false;
    } else {
      with.insert(groups.of(at[t].front()));
    }
  }
  wedges.with_section = with.size();
  wedges.without = groups.count() - with.size();
  return wedges;
}

struct EdgeCounts {
  std::size_t inner = 0, pinched = 0, bare = 0, extra_wedges = 0;
};

/// Where there are tetrahedra at all, kept or not: cells of vertices in one plane have none.
std::set<Edge> edges_of_cells(const Shown& s) {
  std::set<Edge> edges;
  for (const BuiltCell& cell : s.cells)
    for (Tet tet : cell.complex.mesh.vertices) {
      for (std::uint32_t& v : tet) v = cell.vertices[v];
      for (unsigned e = 0; e < 6; ++e) edges.insert(edge_of(tet, e));
    }
  return edges;
}

EdgeCounts count_edges(const Shown& s) {
  std::map<Edge, std::vector<Tet>> tets;
  std::map<Edge, std::vector<Triangle>> section;
  const std::set<Edge> inner = s.inner_edges();
  for (const Tet& t : s.solid)
    for (unsigned e = 0; e < 6; ++e)
      if (inner.count(edge_of(t, e)) != 0) tets[edge_of(t, e)].push_back(t);
  s.for_section_triangles([&](const Triangle& t) {
    for (std::size_t k = 0; k < 3; ++k)
      if (const Edge e = ascending(Edge{t[k], t[(k + 1) % 3]}); inner.count(e) != 0) section[e].push_back(t);
  });
  EdgeCounts counts;
  for (const Edge& e : edges_of_cells(s)) {
    if (inner.count(e) == 0) continue;
    const Wedges w = wedges_at(e, tets[e], section[e]);
    ++counts.inner;
    counts.pinched += w.with_section == 1 && w.all_triangles ? 0U : 1U;
    counts.bare += w.all_triangles ? 0U : 1U;
    counts.extra_wedges += w.without;
  }
  return counts;
}

/// Section triangles with nothing on either side.
std::size_t bare_triangles(const Shown& s, const std::vector<Tet>& solid) {
  std::set<Triangle> covered;
  for (const Tet& t : solid)
    for (unsigned i = 0; i < 4; ++i) covered.insert(facet_of(t, i));
  std::size_t bare = 0;
  s.for_section_triangles([&](const Triangle& t) { bare += covered.count(t) == 0 ? 1U : 0U; });
  return bare;
}

/// The solid without bridges.
std::vector<Tet> solid_of_cells(const Shown& s) {
  std::vector<Tet> solid;
  for (std::size_t c = 0; c < s.cells.size(); ++c)
    for (std::size_t t = 0; t < s.kept[c].size(); ++t)
      if (s.kept[c][t] != 0) {
        Tet tet = s.cells[c].complex.mesh.vertices[t];
        for (std::uint32_t& v : tet) v = s.cells[c].vertices[v];
        solid.push_back(tet);
      }
  return solid;
}

/// Of all section triangles as a surface that may branch at lines: vertices are apart where triangles hang
/// together at them through no edge.
std::int64_t euler_of_sections(const Shown& s) {
  std::vector<Triangle> triangles;
  s.for_section_triangles([&](const Triangle& t) { triangles.push_back(t); });
  std::map<Edge, std::vector<std::size_t>> edges;
  std::map<std::uint32_t, std::vector<std::size_t>> at;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      edges[ascending(Edge{triangles[t][k], triangles[t][(k + 1) % 3]})].push_back(t);
      at[triangles[t][k]].push_back(t);
    }
  auto euler = static_cast<std::int64_t>(triangles.size()) - static_cast<std::int64_t>(edges.size());
  for (const auto& [vertex, here] : at) {
    Groups parts(here.size());
    for (std::size_t i = 0; i < here.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        std::size_t common = 0;
        for (const std::uint32_t v : triangles[here[i]])
          common +=
              static_cast<std::size_t>(std::count(triangles[here[j]].begin(), triangles[here[j]].end(), v));
        if (common == 2) parts.put_together(i, j);
      }
    euler += static_cast<std::int64_t>(parts.count());
  }
  return euler;
}

std::int64_t euler_of(const Surface& surface) {
  std::int64_t euler = 0;
  for (const ComponentReport& c : check_surface(surface).components) euler += c.euler;
  return euler;
}

/// Two planes full of bridges, and far below three that take branching samples: these give vertices new
/// numbers when the bridges above have been found.
Sections samples_elsewhere() {
  Sections sections = load("figures/fig18.contour");
  const auto row = [&](double z, std::initializer_list<double> at, double r, int corners) {
    PlaneSection plane = plane_at({0, 0, 1}, {0, 0, z});
    for (const double x : at) add_contour(plane, polygon({0, 0, 1}, {x, 0, z}, r, corners));
    sections.planes.push_back(plane);
  };
  row(-12, {0.1}, 1, 40);
  row(-11, {-1, 1}, 0.5, 24);
  row(-10, {0.1}, 1, 40);
  return sections;
}

/// Three circles on each of a few planes, which know nothing of each other: sections that contradict each
/// other on the lines, and slivers.
Sections rows_of_circles(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Sections sections;
  for (int p = 0; p < 4; ++p) {
    const Vec3 normal = random_vector(random);
    PlaneSection plane = plane_at(normal, 0.3 * random_vector(random));
    const Vec3 n = unit(normal), u = unit(cross(n, {0.3, 0.2, 1.1})), v = cross(n, u);
    const Vec3 origin = (-plane.offset / dot(normal, normal)) * normal;
    for (int k = -1; k < 2; ++k) {
      const Vec3 centre = origin + (2.0 * k + 0.3 * uniform(random)) * u + (0.3 * uniform(random)) * v;
      add_contour(plane,
                  polygon(normal, centre, 0.4 + 0.15 * uniform(random), 5 + static_cast<int>(random() % 12)));
    }
    sections.planes.push_back(plane);
  }
  return sections;
}

/// Walls thinner than the slices are apart: samples over holes, many wedges.
Sections slanted_slices(const Surface& mesh, std::uint32_t count) {
  return cut(mesh, parallel_planes(bounds_of(mesh.points), count, {0.3, 0.5, 1}));
}

std::vector<Scene> larger_scenes() {
  std::vector<Scene> scenes = small_scenes();
  scenes.push_back({"samples elsewhere", samples_elsewhere()});
  const Surface ring = torus(1, 0.4, 30, 15);
  for (const std::uint64_t seed : {1u, 2u, 3u})
    scenes.push_back({"torus by 12, set " + std::to_string(seed), cut_randomly(ring, 12, seed)});
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    scenes.push_back(
        {"genus 2 by 16, set " + std::to_string(seed), cut_randomly(genus2_solid(20), 16, seed)});
    scenes.push_back({"vessel by 16, set " + std::to_string(seed), cut_randomly(vessel_solid(20), 16, seed)});
  }
  scenes.push_back({"trefoil by 14", cut_randomly(trefoil_solid(20), 14, 2)});
  scenes.push_back({"gyroid by 12", cut_randomly(gyroid_solid(16), 12, 2)});
  scenes.push_back({"shells by 10", cut_randomly(nested_shells(16), 10, 2)});
  for (const std::uint32_t count : {7u, 9u, 11u})
    scenes.push_back(
        {"shells by " + std::to_string(count) + " slices", slanted_slices(nested_shells(20), count)});
  for (const char* name :
       {"figures/fig14p.contour", "figures/fig16_one_two.contour", "figures/fig16_shift.contour",
        "figures/fig16_center.contour", "figures/fig17.contour", "figures/fig17_cross.contour",
        "figures/fig19.contour", "figures/fig20b.contour", "topology/dome.contour", "topology/tunnel.contour",
        "demo.contour"})
    scenes.push_back({name, load(name)});
  Options strict;
  strict.natural.join_confidence = 0.5;
  strict.branching.mode = Branching::off;
  for (const std::uint64_t seed : {3u, 5u})
    scenes.push_back({"shells by 3, few joins, set " + std::to_string(seed),
                      cut_randomly(nested_shells(14), 3, seed), strict});
  scenes.push_back({"genus 3 by 3", cut_randomly(genus3_solid(16), 3, 6)});
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u, 6u, 7u, 8u})
    scenes.push_back({"rows, seed " + std::to_string(seed), rows_of_circles(seed)});
  return scenes;
}

}  // namespace

TEST_CASE(
    "with bridges no edge in a section is pinched but the open ones, and no section with an edge is bare") {
  std::size_t bridges = 0, open = 0, fewer_bare = 0, extra = 0;
  std::vector<Scene> scenes = larger_scenes();
  const std::size_t count = scenes.size();
  for (std::size_t i = 0; i < count; ++i) {
    scenes.push_back(scenes[i]);
    scenes.back().name += ", undivided";
    scenes.back().options.natural.divide = InCells::off;
  }
  for (const Scene& scene : scenes) {
    CAPTURE(scene.name);
    EdgeCounts edges;
    std::size_t bare = 0, bare_before = 0;
    const auto look = [&](const Shown& s) {
      edges = count_edges(s);
      bare = bare_triangles(s, s.solid);
      bare_before = bare_triangles(s, solid_of_cells(s));
    };
    const Reconstruction r = run(scene.sections, look, scene.options);
    const TopologyReport& t = r.report.topology;
    CHECK(edges.pinched == t.open_edges);
    CHECK(bare <= bare_before);
    CHECK((r.report.flat_area > 0) == (bare > 0));
    if (t.open_edges == 0) CHECK(edges.bare == 0);
    CHECK(check_surface(r.surface).good_topology());
    CHECK(check_surface(r.surface).crossings == 0);
    bridges += t.bridges;
    open += t.open_edges;
    extra += edges.extra_wedges;
    fewer_bare += bare_before - bare;
  }
  MESSAGE("bridges at " << bridges << " edges, open edges " << open << ", section triangles covered "
                        << fewer_bare << ", wedges on no section " << extra);
  CHECK(bridges > 250);
  CHECK(open > 0);
  CHECK(fewer_bare > 0);
  CHECK(extra > 0);
}

TEST_CASE("what the cells count is true of the result: its Euler characteristic is the sum of theirs") {
  std::size_t told = 0, with_bridges = 0, handles = 0;
  for (const Scene& scene : larger_scenes()) {
    CAPTURE(scene.name);
    std::int64_t expected = 0;
    const auto look = [&](const Shown& s) { expected = euler_of_sections(s); };
    const Reconstruction r = run(scene.sections, look, scene.options);
    CHECK(r.report.topology.handles == 0);
    for (const CellReport& c : r.report.cells)
      expected += std::int64_t{c.topology.bodies} + c.topology.outsides - 1 - c.topology.sections;
    // Crossings without partner break a section along a line that is no edge of a contour.
    if (r.report.topology.open_edges != 0 || r.report.flat_area > 0 || !r.report.unmatched.empty()) continue;
    CHECK(euler_of(r.surface) == 2 * (expected - r.report.topology.bridge_handles));
    ++told;
    handles += r.report.topology.bridge_handles;
    with_bridges += r.report.topology.bridges != 0 ? 1U : 0U;
  }
  CHECK(told >= 25);
  CHECK(with_bridges >= 8);
  CHECK(handles > 0);
}

TEST_CASE("the U shapes of figure 18 and what the link joins are one body without a hole") {
  for (const char* name : {"figures/fig18.contour", "topology/link.contour"}) {
    CAPTURE(std::string(name));
    const Reconstruction r = run(load(name));
    CHECK(r.report.topology.open_edges == 0);
    CHECK(check_surface(r.surface).components.size() == 1);
    CHECK(check_surface(r.surface).genus == 0);
  }
}

TEST_CASE("bridges are for natural alone, and the same for any number of threads and order of the input") {
  for (const char* name : {"figures/fig18.contour", "figures/fig16_center.contour"}) {
    CAPTURE(std::string(name));
    Options joint;
    joint.mode = PruneMode::joint;
    CHECK(run(load(name), {}, joint).report.topology.bridges == 0);
    const Reconstruction one = run(load(name));
    CHECK(one.report.topology.bridges > 0);
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      CAPTURE(seed);
      Context context;
      context.threads = 2;
      const auto two = reconstruct(shuffled(load(name), seed), {}, context);
      REQUIRE(two.ok());
      CHECK(hash(*two) == hash(one));
    }
  }
}

// The upright section ends half way across the disks: beyond, its plane has none of the common line, and the
// disks have. Bridges that ended at a triangle with its side there put that side into the solid.
TEST_CASE("where sections disagree on a common line, no edge of the solid is outside of one") {
  for (const double reach : {0.0, 0.5}) {
    CAPTURE(reach);
    Sections sections{"", {disk({0, 0, 1}, {0, 0, 0}, 1, 12), disk({0, 0, 1}, {0, 0, 1}, 1, 12)}};
    sections.planes.push_back(plane_at({1, 0, 0}, {0.1, 0, 0}));
    add_contour(sections.planes.back(),
                {{0.1, -1, -0.5}, {0.1, reach, -0.5}, {0.1, reach, 1.5}, {0.1, -1, 1.5}});
    SectionJudge judge;
    const auto r = reconstruct(sections, {}, {}, &judge);
    REQUIRE(r.ok());
    REQUIRE(r->report.unmatched.size() == 8);
    CHECK(judge.complaint() == "");
    CHECK(r->report.topology.open_edges == 8);
    CHECK(r->report.flat_area > 0);
    CHECK(r->report.flat_area < 0.15 * r->report.section_area);
  }
}
