// Voronoi and power diagrams against CGAL.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/convex_hull_2.h>

#include <map>
#include <set>

#include "../../moebius/cells.h"
#include "diagram_checks.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_2<
    Kernel,
    CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>>>;
using RegularBase =
    CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel,
                                                CGAL::Regular_triangulation_vertex_base_2<Kernel>>;
using Regular = CGAL::Regular_triangulation_2<
    Kernel,
    CGAL::Triangulation_data_structure_2<RegularBase, CGAL::Regular_triangulation_face_base_2<Kernel>>>;

using Pair = std::array<std::uint32_t, 2>;
using Triple = std::array<std::uint32_t, 3>;

/// The border of two cells: the third sites at its ends, kNone at infinity, in ascending order.
using Borders = std::map<Pair, Pair>;
using Corners = std::map<Triple, Vec2>;

template <std::size_t N>
std::array<std::uint32_t, N> sorted(std::array<std::uint32_t, N> a) {
  std::sort(a.begin(), a.end());
  return a;
}

/// The same of a Moebius diagram without circles.
void read(const MoebiusDiagram& diagram, Borders& borders, Corners& corners) {
  std::vector<std::set<std::uint32_t>> around(diagram.vertices.size());
  for (const MoebiusArc& arc : diagram.arcs)
    for (const std::uint32_t v : {arc.from, arc.to})
      if (v != kNone) around[v].insert(arc.sites.begin(), arc.sites.end());
  for (std::size_t v = 0; v < around.size(); ++v) {
    REQUIRE(around[v].size() == 3);
    Triple triple{};
    std::copy(around[v].begin(), around[v].end(), triple.begin());
    CHECK(corners.emplace(triple, diagram.vertices[v]).second);
  }
  for (const MoebiusArc& arc : diagram.arcs) {
    Pair ends{kNone, kNone};
    for (const int k : {0, 1})
      if (const std::uint32_t v = k ? arc.to : arc.from; v != kNone)
        for (const std::uint32_t s : around[v])
          if (s != arc.sites[0] && s != arc.sites[1]) ends[k] = s;
    CHECK(borders.emplace(sorted(arc.sites), sorted(ends)).second);
  }
}

template <class Triangulation>
void read(const Triangulation& t, Borders& borders, Corners& corners) {
  for (auto face = t.finite_faces_begin(); face != t.finite_faces_end(); ++face) {
    const auto centre = t.dual(face);
    corners.emplace(sorted(Triple{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()}),
                    Vec2{centre.x(), centre.y()});
  }
  for (auto edge = t.finite_edges_begin(); edge != t.finite_edges_end(); ++edge) {
    const auto [face, slot] = *edge;
    const auto third = [&](auto f, int s) { return t.is_infinite(f) ? kNone : f->vertex(s)->info(); };
    const Pair sites{face->vertex(t.cw(slot))->info(), face->vertex(t.ccw(slot))->info()};
    borders.emplace(sorted(sites),
                    sorted(Pair{third(face, slot), third(face->neighbor(slot), t.mirror_index(face, slot))}));
  }
}

template <class Triangulation>
void compare(const MoebiusDiagram& diagram, const Triangulation& t) {
  CHECK(verify(diagram) == "");
  Borders borders, wanted_borders;
  Corners corners, wanted_corners;
  read(diagram, borders, corners);
  read(t, wanted_borders, wanted_corners);
  CHECK(borders == wanted_borders);
  REQUIRE(corners.size() == wanted_corners.size());
  int far = 0;
  for (const auto& [triple, place] : corners) {
    REQUIRE(wanted_corners.count(triple) == 1);
    const Vec2 wanted = wanted_corners.at(triple);
    far += !(length(place - wanted) <= 1e-7 * (1 + dot(wanted, wanted)));
  }
  CHECK(far == 0);
  for (const MoebiusArc& arc : diagram.arcs) CHECK(arc.curve.is_line);
}

}  // namespace

TEST_CASE("Voronoi diagrams") {
  for (const unsigned seed : {1u, 2u, 3u}) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    Sites sites;
    std::vector<std::pair<Kernel::Point_2, std::uint32_t>> points;
    for (std::uint32_t i = 0; i < 2000; ++i) {
      sites.push_back({{unit(random), unit(random)}});
      points.push_back({{sites[i].p.x, sites[i].p.y}, i});
    }
    for (std::uint32_t i = 0; i < 50; ++i) sites.push_back(sites[7 * i]);  // duplicates stay without a cell
    const Delaunay delaunay(points.begin(), points.end());
    compare(diagram_of(sites), delaunay);
    for (MoebiusSite& s : sites) s.lambda = 2.5;
    compare(diagram_of(sites), delaunay);
  }
}

TEST_CASE("power diagrams, with hidden sites") {
  for (const unsigned seed : {4u, 5u, 6u}) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    Sites sites;
    std::vector<std::pair<Kernel::Weighted_point_2, std::uint32_t>> points;
    for (std::uint32_t i = 0; i < 2000; ++i) {
      sites.push_back({{unit(random), unit(random)}, 1, 0.004 * unit(random)});
      points.push_back({{{sites[i].p.x, sites[i].p.y}, sites[i].mu}, i});
    }
    Regular regular(points.begin(), points.end());
    CHECK(regular.number_of_hidden_vertices() > 100);
    const MoebiusDiagram diagram = diagram_of(sites);
    compare(diagram, regular);
    const MoebiusCells cells = moebius_cells(diagram);
    CHECK(cells.components.size() == regular.number_of_vertices());
    for (MoebiusSite& s : sites) s.lambda = 4, s.mu *= 4;
    compare(diagram_of(sites), regular);
  }
}

TEST_CASE("lambda -1: who is farthest has a cell iff it is a corner of the convex hull") {
  const unsigned seed = 7;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> integer(-1000, 1000);
  Sites sites;
  std::vector<Kernel::Point_2> points, hull;
  while (sites.size() < 3000) {
    const Vec2 p{double(integer(random)), double(integer(random))};
    if (dot(p, p) > 1e6) continue;
    sites.push_back({p, -1, 0});
    points.push_back({p.x, p.y});
  }
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
  const MoebiusDiagram diagram = diagram_of(sites);
  CHECK(verify(diagram) == "");
  const MoebiusCells cells = moebius_cells(diagram);
  std::set<std::pair<double, double>> corners, wanted;
  for (const auto& p : hull) wanted.insert({p.x(), p.y()});
  for (const CellComponent& c : cells.components) corners.insert({sites[c.site].p.x, sites[c.site].p.y});
  CHECK(corners == wanted);
  CHECK(cells.components.size() == hull.size());
}
