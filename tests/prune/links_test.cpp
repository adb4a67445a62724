// The census of extended links against a second one on sets of labels, and by hand.
#include "prune/links.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "cells.h"
#include "prune/prune.h"

namespace {

using namespace crossloft;
using namespace crossloft::test;
using Labels = std::set<std::uint32_t>;

/// Splits a set of simplices into parts that hang together by common faces of the given size.
std::vector<std::vector<Labels>> parts_of(std::vector<Labels> simplices, std::size_t common_size) {
  std::vector<std::vector<Labels>> parts;
  while (!simplices.empty()) {
    std::vector<Labels> part{simplices.back()};
    simplices.pop_back();
    for (std::size_t head = 0; head < part.size(); ++head) {
      for (std::size_t i = simplices.size(); i-- > 0;) {
        Labels common;
        std::set_intersection(part[head].begin(), part[head].end(), simplices[i].begin(), simplices[i].end(),
                              std::inserter(common, common.end()));
        if (common.size() != common_size) continue;
        part.push_back(simplices[i]);
        simplices.erase(simplices.begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
    parts.push_back(part);
  }
  return parts;
}

/// The link of v as sets of labels; each fan of internal triangles gets a label of its own for its far side.
std::vector<Labels> link_of(const CellComplex& cell, const std::vector<std::uint8_t>& kept, std::uint32_t v) {
  std::vector<Labels> link, ground;
  for (std::uint32_t t = 0; t < cell.mesh.size(); ++t) {
    Labels tet(cell.mesh.vertices[t].begin(), cell.mesh.vertices[t].end());
    if (tet.erase(v) == 0) continue;
    if (kept[t] != 0) link.push_back(tet);
    for (unsigned i = 0; i < 4; ++i) {
      Labels edge = tet;
      if (cell.facets[t][i] == FacetKind::internal && edge.erase(cell.mesh.vertices[t][i]) != 0)
        ground.push_back(edge);
    }
  }
  std::uint32_t label = 1000;
  for (const auto& fan : parts_of(ground, 1)) {
    for (Labels edge : fan) {
      edge.insert(label);
      link.push_back(edge);
    }
    ++label;
  }
  return link;
}

bool is_pinched(const std::vector<Labels>& link) {
  Labels vertices;
  for (const Labels& t : link) vertices.insert(t.begin(), t.end());
  return std::any_of(vertices.begin(), vertices.end(), [&](std::uint32_t a) {
    std::vector<Labels> rays;  // the link of a in the link: its parts must hang together by vertices
    for (Labels t : link) {
      if (t.erase(a) != 0) rays.push_back(t);
    }
    return parts_of(rays, 1).size() > 1;
  });
}

int euler(const std::vector<Labels>& link) {
  Labels vertices;
  std::set<Labels> edges;
  for (const Labels& t : link) {
    vertices.insert(t.begin(), t.end());
    for (const std::uint32_t a : t) {
      Labels edge = t;
      edge.erase(a);
      edges.insert(edge);
    }
  }
  return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) + static_cast<int>(link.size());
}

enum class Shape { bare, disk, sphere, disconnected, pinched, annular };

Shape slow_shape(const CellComplex& cell, const std::vector<std::uint8_t>& kept, std::uint32_t v) {
  const auto link = link_of(cell, kept, v);
  if (std::none_of(link.begin(), link.end(), [](const Labels& t) { return *t.rbegin() < 1000; }))
    return Shape::bare;
  if (parts_of(link, 2).size() > 1) return Shape::disconnected;
  if (is_pinched(link)) return Shape::pinched;
  return euler(link) == 2 ? Shape::sphere : euler(link) == 1 ? Shape::disk : Shape::annular;
}

LinkCensus slow_census(const CellComplex& cell, const std::vector<std::uint8_t>& kept) {
  std::map<Shape, std::uint32_t> count;
  for (std::uint32_t v = 0; v < cell.vertex_count; ++v) ++count[slow_shape(cell, kept, v)];
  return {count[Shape::bare],         count[Shape::disk],    count[Shape::sphere],
          count[Shape::disconnected], count[Shape::pinched], count[Shape::annular]};
}

LinkCensus census_all(const CellComplex& cell, const std::vector<std::uint8_t>& kept) {
  return census_links(cell, kept, std::vector<std::uint8_t>(cell.vertex_count, 1));
}

void check_equal(const LinkCensus& a, const LinkCensus& b) {
  CHECK(a.bare == b.bare);
  CHECK(a.disks == b.disks);
  CHECK(a.spheres == b.spheres);
  CHECK(a.disconnected == b.disconnected);
  CHECK(a.pinched == b.pinched);
  CHECK(a.annular == b.annular);
}

/// Vertex 0 in the middle of a hexagon 1..6 of a section, a second ring 7..12 over it, 13 on top. Tetrahedra
/// at 0: 2i and 2i+1 between the rings over side i of the hexagon, then 12..17 from the second ring to the
/// top.
CellComplex dome() {
  std::vector<Tet> tets;
  std::set<Triangle> internal;
  const auto low = [](std::uint32_t i) { return 1 + i % 6; };
  const auto high = [](std::uint32_t i) { return 7 + i % 6; };
  for (std::uint32_t i = 0; i < 6; ++i) {
    tets.push_back({0, low(i), low(i + 1), high(i)});
    tets.push_back({0, low(i + 1), high(i + 1), high(i)});
    internal.insert({0, std::min(low(i), low(i + 1)), std::max(low(i), low(i + 1))});
  }
  for (std::uint32_t i = 0; i < 6; ++i) tets.push_back({0, high(i), high(i + 1), 13});
  std::vector<std::uint64_t> masks(14, 2);
  for (std::uint32_t v = 0; v < 14; ++v) masks[v] = v < 7 ? 1 : 0;
  return make_cell(tets, masks, internal);
}

/// The shape at vertex 0 by the slow way, and both ways agree on the whole cell.
Shape at_apex(const CellComplex& cell, const std::vector<std::uint32_t>& missing) {
  std::vector<std::uint8_t> kept(cell.mesh.size(), 1);
  for (const std::uint32_t t : missing) kept[t] = 0;
  check_equal(census_all(cell, kept), slow_census(cell, kept));
  return slow_shape(cell, kept, 0);
}

}  // namespace

TEST_CASE("a vertex inside a section, everything above it kept: a sphere") {
  CHECK(at_apex(dome(), {}) == Shape::sphere);
}

TEST_CASE("one hole: a disk") {
  CHECK(at_apex(dome(), {12}) == Shape::disk);
  CHECK(at_apex(dome(), {12, 13, 14, 15, 16, 17}) == Shape::disk);
}

TEST_CASE("two holes: an annulus") {
  CHECK(at_apex(dome(), {0, 1, 6, 7}) == Shape::annular);
  CHECK(at_apex(dome(), {0, 6}) == Shape::annular);
}

TEST_CASE("two holes that touch in a vertex: pinched") {
  CHECK(at_apex(dome(), {12, 14}) == Shape::pinched);  // both at the top
}

TEST_CASE("a cap over nothing: disconnected from the section") {
  CHECK(at_apex(dome(), {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}) == Shape::disconnected);
}

TEST_CASE("nothing kept: bare") {
  CHECK(at_apex(dome(), {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17}) == Shape::bare);
}

TEST_CASE("random cells and random subsets: both ways of counting agree") {
  LinkCensus sum;
  for (std::uint32_t seed = 0; seed < 60; ++seed) {
    CAPTURE(seed);
    const CellComplex cell = random_cell(seed);
    std::mt19937 random(seed);
    std::vector<std::uint8_t> kept = prune(cell, PruneMode::joint).kept;
    for (int round = 0; round < 3; ++round) {
      const LinkCensus census = census_all(cell, kept);
      check_equal(census, slow_census(cell, kept));
      CHECK(census.bare + census.disks + census.spheres + census.bad_links() == cell.vertex_count);
      sum.annular += census.annular;
      sum.pinched += census.pinched;
      sum.disconnected += census.disconnected;
      sum.spheres += census.spheres;
      for (auto& k : kept) k = random() % 4 != 0 ? 1 : 0;
    }
  }
  CHECK(sum.annular > 0);
  CHECK(sum.pinched > 0);
  CHECK(sum.disconnected > 0);
  CHECK(sum.spheres > 0);
}
