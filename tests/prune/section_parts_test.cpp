// Parts of the sections and the planes that meet bodies of them, against brute force.
#include "prune/section_parts.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "cells.h"

namespace {

using namespace crossloft;
using namespace crossloft::test;

/// The faces of the cell that all three vertices are on.
std::set<std::uint32_t> faces_of(const CellComplex& cell, const Triangle& triangle) {
  std::set<std::uint32_t> faces;
  for (std::uint32_t f = 0; f < 64 * cell.words; ++f)
    if (std::all_of(triangle.begin(), triangle.end(),
                    [&](std::uint32_t v) { return (cell.faces_of(v)[f / 64] >> f % 64 & 1U) != 0; }))
      faces.insert(f);
  return faces;
}

struct PartSets {
  std::set<std::uint32_t> vertices, faces;
};

/// By Ground::part.
std::map<std::uint32_t, PartSets> parts_of(const CellComplex& cell, const Ground& ground) {
  std::map<std::uint32_t, PartSets> parts;
  for (std::uint32_t g = 0; g < ground.size(); ++g) {
    Triangle triangle;
    for (unsigned k = 0; k < 3; ++k)
      triangle[k] = cell.mesh.vertices[ground.facet(g).tet][kFacetSlots[ground.facet(g).facet][k]];
    PartSets& part = parts[ground.part(g)];
    part.vertices.insert(triangle.begin(), triangle.end());
    part.faces.merge(faces_of(cell, triangle));
  }
  return parts;
}

}  // namespace

TEST_CASE("random cells: parts have the vertices and faces of their triangles, whatever the numbers") {
  std::size_t several = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    const PlacedCell placed = placed_cell(seed);
    const CellComplex cell = seed % 3 == 0 ? with_many_faces(placed).complex : placed.complex;
    const Ground ground(cell);
    const std::vector<SectionPart> parts = section_parts(cell, ground);
    const std::map<std::uint32_t, PartSets> brute = parts_of(cell, ground);
    REQUIRE(parts.size() == brute.size());
    for (const SectionPart& part : parts) {
      const PartSets& other = brute.at(part.number);
      CHECK(part.vertices == std::vector<std::uint32_t>(other.vertices.begin(), other.vertices.end()));
      CHECK(part.faces == std::vector<std::uint32_t>(other.faces.begin(), other.faces.end()));
      several += part.faces.size() > 1 ? 1U : 0U;
    }
    std::mt19937 random(seed);
    std::vector<std::uint32_t> from;
    const CellComplex other = shuffled(placed.complex, random, from);
    const std::vector<SectionPart> again = section_parts(other, Ground(other));
    REQUIRE(again.size() == parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      CHECK(again[i].vertices == parts[i].vertices);
      CHECK(again[i].faces.size() == parts[i].faces.size());
    }
  }
  CHECK(several > 20);
}

TEST_CASE("bodies are met by the planes of all their parts") {
  std::mt19937 random(7);
  for (int round = 0; round < 50; ++round) {
    std::vector<SectionPart> parts(2 + random() % 5);
    std::vector<std::set<std::uint32_t>> faces(parts.size());
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
      for (std::size_t k = 0; k <= random() % 4; ++k) faces[i].insert(random() % 8);
      parts[i] = {i, {i}, {faces[i].begin(), faces[i].end()}};
    }
    SeenBodies bodies(parts);
    std::vector<std::uint32_t> body(parts.size());
    for (std::uint32_t i = 0; i < parts.size(); ++i) body[i] = i;
    for (std::size_t joined = 1; joined < parts.size(); ++joined) {
      const auto a = static_cast<std::uint32_t>(random() % parts.size());
      const auto b = static_cast<std::uint32_t>(random() % parts.size());
      if (body[a] == body[b]) continue;
      CHECK(bodies.planes_at_both(bodies.body_of(a), bodies.body_of(b)) ==
            std::min(faces[body[a]].size(), faces[body[b]].size()));
      const Join join{std::min(a, b), std::max(a, b), 0, true};
      const auto pair = bodies_of(join, parts, bodies);
      REQUIRE(pair);
      CHECK(((*pair)[0] == bodies.body_of(join.a) && (*pair)[1] == bodies.body_of(join.b)));
      bodies.join((*pair)[0], (*pair)[1]);
      CHECK(!bodies_of(join, parts, bodies));
      faces[body[a]].insert(faces[body[b]].begin(), faces[body[b]].end());
      std::replace(body.begin(), body.end(), std::uint32_t{body[b]}, std::uint32_t{body[a]});
    }
  }
}

TEST_CASE("parts that touch in their smallest vertex: a join in that name is between the first two bodies") {
  const std::vector<SectionPart> parts{{0, {2, 3, 4}, {0}}, {1, {2, 5, 6}, {1, 2}}, {2, {7, 8, 9}, {3}}};
  SeenBodies bodies(parts);
  const auto touching = bodies_of({2, 2, 0, true}, parts, bodies);
  REQUIRE(touching);
  CHECK(bodies.planes_at_both((*touching)[0], (*touching)[1]) == 1);
  bodies.join((*touching)[0], (*touching)[1]);
  CHECK(!bodies_of({2, 2, 0, true}, parts, bodies));
  CHECK(bodies_of({2, 7, 0, true}, parts, bodies));
  CHECK(!bodies_of({3, 7, 0, true}, parts, bodies));
}
