// What the contact of a tetrahedron says, against Euler characteristics and parts counted anew.
#include "prune/contact.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "brute_solid.h"
#include "cells.h"

namespace {

using namespace crossloft;
using namespace crossloft::test;

Simplex facet_of(const CellComplex& cell, std::uint32_t t, unsigned i) {
  Simplex s;
  for (const std::uint8_t slot : kFacetSlots[i]) s.push_back(cell.mesh.vertices[t][slot]);
  std::sort(s.begin(), s.end());
  return s;
}

/// Facets of t in groups that hang together at vertices of t through the solid's stars.
Groups parts_of_contact(const BruteSolid& brute, const CellComplex& cell, const Flags& kept,
                        std::uint32_t t) {
  Groups parts(4);
  for (const std::uint32_t v : cell.mesh.vertices[t]) {
    const Groups star = brute.star(kept, {v});
    for (unsigned i = 0; i < 4; ++i)
      for (unsigned j = 0; j < i; ++j) {
        const Simplex f = facet_of(cell, t, i), g = facet_of(cell, t, j);
        if (std::count(f.begin(), f.end(), v) == 0 || std::count(g.begin(), g.end(), v) == 0) continue;
        const std::size_t a = brute.across(t, f), b = brute.across(t, g);
        if (brute.is_solid(kept, a) && brute.is_solid(kept, b) && star.of(a) == star.of(b))
          parts.put_together(i, j);
      }
  }
  return parts;
}

struct Kinds {
  int simple = 0, dome = 0, plug = 0, apart = 0, loop = 0;
};

void check_contact(const BruteSolid& brute, const CellComplex& cell, const Contact& contact,
                   const Flags& kept, std::uint32_t t, Kinds& kinds) {
  const Groups parts = parts_of_contact(brute, cell, kept, t), bodies = brute.bodies(kept);
  std::set<std::size_t> seen;
  unsigned facets = 0;
  for (unsigned i = 0; i < 4; ++i) {
    const std::size_t piece = brute.across(t, facet_of(cell, t, i));
    if (!brute.is_solid(kept, piece)) continue;
    facets |= 1U << i;
    seen.insert(parts.of(i));
    for (unsigned j = 0; j < i; ++j) {
      const std::size_t other = brute.across(t, facet_of(cell, t, j));
      if (brute.is_solid(kept, other))
        CHECK((contact.bodies[i] == contact.bodies[j]) == (bodies.of(piece) == bodies.of(other)));
    }
  }
  CHECK(contact.facets == facets);
  CHECK(contact.parts == static_cast<int>(seen.size()));
  Flags more = kept;
  more[t] = 1;
  CHECK(1 - contact.parts + contact.loops == brute.euler_of_solid(more) - brute.euler_of_solid(kept));
  kinds.simple += contact.is_simple();
  kinds.dome += contact.is_dome();
  kinds.plug += contact.is_plug();
  kinds.apart += contact.parts > 1;
  kinds.loop += contact.parts > 1 && contact.loops > 0;
}

}  // namespace

TEST_CASE("random solids: contacts have the facets, parts, loops and bodies of the definition") {
  Kinds kinds;
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const CellComplex cell = seed % 3 == 0 ? random_cell(seed) : deep_cell(seed);
    const Ground ground(cell);
    const BruteSolid brute(cell);
    GrowingSolid solid(cell, ground);
    std::vector<std::uint32_t> order;
    for (std::uint32_t t = 0; t < cell.mesh.size(); ++t) order.push_back(t);
    std::shuffle(order.begin(), order.end(), random);
    for (const std::uint32_t t : order) {
      CAPTURE(t);
      CAPTURE(solid.kept());
      const Contact contact = solid.contact(t);
      check_contact(brute, cell, contact, solid.kept(), t, kinds);
      if (random() % 3 == 0 && !contact.is_simple()) continue;  // holes stay
      solid.add(t);
      CHECK(solid.has(t));
    }
    for (std::uint32_t g = 0; g < ground.size(); ++g)
      for (std::uint32_t h = 0; h < g; ++h) {
        const Groups bodies = brute.bodies(solid.kept());
        const auto prism = [&](std::uint32_t x) {
          return brute.across(ground.facet(x).tet,
                              facet_of(cell, ground.facet(x).tet, ground.facet(x).facet));
        };
        CHECK((solid.body_of_ground(g) == solid.body_of_ground(h)) ==
              (bodies.of(prism(g)) == bodies.of(prism(h))));
      }
  }
  MESSAGE("simple " << kinds.simple << ", dome " << kinds.dome << ", plug " << kinds.plug << ", in parts "
                    << kinds.apart << ", of these with loops " << kinds.loop);
  CHECK(kinds.simple > 200);
  CHECK(kinds.dome > 50);
  CHECK(kinds.plug > 0);
  CHECK(kinds.apart > 100);
  CHECK(kinds.loop > 0);
}

TEST_CASE("all but one: the last tetrahedron of a hole within is a plug") {
  Kinds kinds;
  for (std::uint32_t seed = 200; seed < 220; ++seed) {
    CAPTURE(seed);
    const CellComplex cell = deep_cell(seed);
    const Ground ground(cell);
    const BruteSolid brute(cell);
    for (std::uint32_t hole = 0; hole < cell.mesh.size(); hole += 7) {
      const auto& around = cell.mesh.neighbours[hole];
      if (std::count(around.begin(), around.end(), kNone) != 0) continue;
      CAPTURE(hole);
      GrowingSolid solid(cell, ground);
      for (std::uint32_t t = 0; t < cell.mesh.size(); ++t)
        if (t != hole) solid.add(t);
      const Contact contact = solid.contact(hole);
      check_contact(brute, cell, contact, solid.kept(), hole, kinds);
    }
  }
  CHECK(kinds.plug > 20);
}

TEST_CASE("random solids: every part of the outside at a contact has one of the tetrahedra around it") {
  int asked = 0;
  for (std::uint32_t seed = 100; seed < 160; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const CellComplex cell = random_cell(seed);
    const Ground ground(cell);
    GrowingSolid solid(cell, ground);
    const Flags r1 = r1_of(cell);
    for (std::uint32_t t = 0; t < cell.mesh.size(); ++t)
      if (r1[t] != 0 && random() % 4 != 0) solid.add(t);
    for (std::uint32_t t = 0; t < cell.mesh.size(); ++t) {
      if (solid.has(t)) continue;
      CAPTURE(t);
      const Contact contact = solid.contact(t);
      const std::vector<std::uint32_t> around = solid.outside_around(t, contact);
      CHECK(std::is_sorted(around.begin(), around.end()));
      CHECK(std::adjacent_find(around.begin(), around.end()) == around.end());
      for (const std::uint32_t n : around) {
        CHECK(!solid.has(n));
        std::size_t common = 0;
        for (const std::uint32_t v : cell.mesh.vertices[n])
          common += std::count(cell.mesh.vertices[t].begin(), cell.mesh.vertices[t].end(), v);
        CHECK(common >= 2);
      }
      // All neighbours outside across the facets are there.
      for (unsigned i = 0; i < 4; ++i) {
        const std::uint32_t n = cell.mesh.neighbours[t][i];
        if (n == kNone || solid.has(n)) continue;
        CHECK(std::binary_search(around.begin(), around.end(), n));
        ++asked;
      }
    }
  }
  CHECK(asked > 200);
}
