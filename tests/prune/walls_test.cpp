// Walls that a solid lacks, against parts of the hull and of the outside put together from sets of vertices.
#include "prune/walls.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "brute_solid.h"
#include "cells.h"
#include "prune/star.h"

namespace {

using namespace crossloft;
using namespace crossloft::test;

constexpr std::int32_t kLeast = 400;

/// A cell with a random solid in R1 and random confidences, several tetrahedra to each.
struct Scene {
  explicit Scene(std::uint32_t seed) : random(seed), cell(random_cell(seed)), solid(r1_of(cell)) {
    for (std::uint32_t t = 0; t < cell.mesh.size(); ++t) {
      confidence.push_back(100 * static_cast<std::int32_t>(random() % 10));
      if (random() % 4 == 0) solid[t] = 0;
    }
  }
  std::vector<std::uint32_t> walls() const {
    return find_walls(cell, solid, kLeast, [this](std::uint32_t t) { return confidence[t]; }).lacking;
  }

  std::mt19937 random;
  CellComplex cell;
  Flags solid;
  std::vector<std::int32_t> confidence;
};

/// Facets of the hull outside of sections in groups by common edges outside: the vertices of each, and
/// whether it shows several faces or ends beyond them.
struct HullPart {
  std::vector<Simplex> facets;
  bool is_wide = false;
};

std::vector<HullPart> hull_parts(const CellComplex& cell) {
  std::vector<Simplex> facets;
  std::vector<std::set<std::uint64_t>> shows;
  std::map<Simplex, bool> edge_outside;
  for (std::uint32_t t = 0; t < cell.mesh.size(); ++t)
    for (unsigned i = 0; i < 4; ++i) {
      if (cell.mesh.neighbours[t][i] != kNone || cell.facets[t][i] == FacetKind::internal) continue;
      Simplex facet;
      std::uint64_t faces = ~std::uint64_t{0};
      for (const std::uint8_t slot : kFacetSlots[i]) {
        facet.push_back(cell.mesh.vertices[t][slot]);
        faces &= cell.faces_of(facet.back())[0];
      }
      facets.push_back(sorted(facet));
      shows.push_back({faces});
      for (unsigned e = 0; e < 6; ++e) {
        const bool outside = cell.edges[t][e] == EdgeKind::external || cell.edges[t][e] == EdgeKind::free;
        edge_outside[sorted(
            {cell.mesh.vertices[t][kEdgeSlots[e][0]], cell.mesh.vertices[t][kEdgeSlots[e][1]]})] = outside;
      }
    }
  Groups groups(facets.size());
  for (std::size_t a = 0; a < facets.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const Simplex edge = common(facets[a], facets[b]);
      if (edge.size() == 2 && edge_outside[edge]) groups.put_together(a, b);
    }
  std::map<std::size_t, HullPart> parts;
  std::map<std::size_t, std::set<std::uint64_t>> seen;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    parts[groups.of(f)].facets.push_back(facets[f]);
    seen[groups.of(f)].insert(shows[f].begin(), shows[f].end());
  }
  std::vector<HullPart> list;
  for (auto& [group, part] : parts) {
    part.is_wide = seen[group].size() > 1 || seen[group].count(0) != 0;
    list.push_back(part);
  }
  return list;
}

/// Pairs of wide parts of the hull that tetrahedra with in[t] != 0 connect, across common edges.
std::set<std::array<std::size_t, 2>> connected_pairs(const CellComplex& cell, const Flags& in) {
  const std::vector<HullPart> parts = hull_parts(cell);
  const std::uint32_t n = cell.mesh.size();
  std::vector<Simplex> tets;
  for (const auto& v : cell.mesh.vertices) tets.push_back(sorted({v.begin(), v.end()}));
  Groups groups(n + parts.size());
  for (std::uint32_t a = 0; a < n; ++a) {
    for (std::uint32_t b = 0; b < a; ++b)
      if (in[a] != 0 && in[b] != 0 && common(tets[a], tets[b]).size() >= 2) groups.put_together(a, b);
    for (std::size_t p = 0; p < parts.size(); ++p)
      if (in[a] != 0 && std::any_of(parts[p].facets.begin(), parts[p].facets.end(),
                                    [&](const Simplex& facet) { return has(tets[a], facet); }))
        groups.put_together(a, n + p);
  }
  std::set<std::array<std::size_t, 2>> pairs;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (std::size_t q = 0; q < p; ++q)
      if (parts[p].is_wide && parts[q].is_wide && groups.of(n + p) == groups.of(n + q)) pairs.insert({p, q});
  return pairs;
}

}  // namespace

TEST_CASE("random cells: walls part just the wide parts of the hull that are not surely connected") {
  int lacking = 0, open = 0;
  for (std::uint32_t seed = 0; seed < 3000; ++seed) {
    CAPTURE(seed);
    const Scene s(seed);
    const std::vector<std::uint32_t> walls = s.walls();
    Flags outside, surely, rest;
    for (std::uint32_t t = 0; t < s.solid.size(); ++t) {
      const bool in_wall = std::find(walls.begin(), walls.end(), t) != walls.end();
      outside.push_back(s.solid[t] == 0);
      surely.push_back(s.solid[t] == 0 && s.confidence[t] < kLeast);
      rest.push_back(s.solid[t] == 0 && !in_wall);
      if (in_wall) CHECK(s.solid[t] == 0);
      if (in_wall) CHECK(s.confidence[t] >= kLeast);
    }
    const auto sure = connected_pairs(s.cell, surely);
    CHECK(connected_pairs(s.cell, rest) == sure);
    CHECK(walls.empty() == (connected_pairs(s.cell, outside) == sure));
    // One less in the wall, and two parts are connected that need not be: there is none in vain.
    for (const std::uint32_t t : walls) {
      rest[t] = 1;
      CHECK(connected_pairs(s.cell, rest).size() > sure.size());
      rest[t] = 0;
    }
    lacking += walls.empty() ? 0 : 1;
    open += sure.empty() ? 0 : 1;
  }
  CHECK(lacking > 20);
  CHECK(open > 10);
}

TEST_CASE("random cells: walls do not depend on the numbers of the tetrahedra") {
  for (std::uint32_t seed = 0; seed < 1000; ++seed) {
    CAPTURE(seed);
    Scene s(seed);
    std::vector<std::uint32_t> from;
    Scene other = s;
    other.cell = shuffled(s.cell, s.random, from);
    for (std::uint32_t t = 0; t < from.size(); ++t) {
      other.solid[t] = s.solid[from[t]];
      other.confidence[t] = s.confidence[from[t]];
    }
    std::vector<std::uint32_t> walls = other.walls();
    for (std::uint32_t& t : walls) t = from[t];
    CHECK(walls == s.walls());
  }
}
