// Broken fans, against their definition on sets of vertices.
#include "prune/broken_fans.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "brute_solid.h"
#include "cells.h"

namespace {

using namespace crossloft;
using namespace crossloft::test;

Simplex facet_of(const CellComplex& cell, std::uint32_t tet, unsigned facet) {
  Simplex s;
  for (const std::uint8_t slot : kFacetSlots[facet]) s.push_back(cell.mesh.vertices[tet][slot]);
  return sorted(s);
}

/// A tetrahedron of a gap with the triangles by which one comes to it and goes on.
struct Step {
  std::size_t tet;
  Simplex from, to;

  friend auto operator<=>(const Step&, const Step&) = default;
};

/// By an edge: the ground triangles at the two ends, and what of the fan is not kept.
struct Fan {
  std::array<Simplex, 2> ground;
  std::vector<Step> all, bare;
  bool broken = false;
  std::size_t gaps = 0;  ///< one iff each of the bare ones follows on the one before
};

/// All tetrahedra at an edge, from the triangle `first` on: each time the one that shares a triangle with the
/// last.
std::vector<Step> in_turn(const BruteSolid& solid, const Simplex& edge, const Simplex& first,
                          const Simplex& last) {
  std::vector<std::size_t> left;
  for (std::size_t t = 0; t < solid.tets(); ++t)
    if (has(solid.pieces()[t], edge)) left.push_back(t);
  std::vector<Step> steps;
  for (Simplex from = first; !left.empty();) {
    const auto next =
        std::find_if(left.begin(), left.end(), [&](std::size_t t) { return has(solid.pieces()[t], from); });
    REQUIRE(next != left.end());
    const std::size_t t = *next;
    left.erase(next);
    Simplex to = last;
    for (const std::size_t other : left)
      if (common(solid.pieces()[t], solid.pieces()[other]).size() == 3)
        to = common(solid.pieces()[t], solid.pieces()[other]);
    steps.push_back({t, from, to});
    from = to;
  }
  CHECK(steps.back().to == last);
  return steps;
}

/// The fans of all edges that two internal hull triangles share.
std::map<Simplex, Fan> all_fans(const BruteSolid& solid, const Flags& kept) {
  std::map<Simplex, Fan> fans;
  const std::vector<std::size_t> ground = solid.ground();
  for (const std::size_t a : ground)
    for (const std::size_t b : ground) {
      const Simplex edge = common(solid.pieces()[a], solid.pieces()[b]);
      if (b <= a || edge.size() != 2) continue;
      Fan fan{{solid.pieces()[a], solid.pieces()[b]}, {}, {}, false, 0};
      fan.all = in_turn(solid, edge, fan.ground[0], fan.ground[1]);
      for (const Step& s : fan.all)
        if (kept[s.tet] == 0) fan.bare.push_back(s);
      fan.broken = !fan.bare.empty();
      for (std::size_t i = 0; i < fan.bare.size(); ++i)
        fan.gaps += i == 0 || fan.bare[i].from != fan.bare[i - 1].to ? 1U : 0U;
      CHECK(fans.emplace(edge, fan).second);
    }
  return fans;
}

std::vector<Step> steps_of(const CellComplex& cell, const std::vector<GapTet>& gaps) {
  std::vector<Step> steps;
  for (const GapTet& g : gaps)
    steps.push_back({g.tet, facet_of(cell, g.tet, g.from), facet_of(cell, g.tet, g.to)});
  return steps;
}

/// A tetrahedron is the last of its gap iff the next one, if any, does not share its facet.
void check_ends(const CellComplex& cell, const std::vector<GapTet>& gaps) {
  const std::vector<Step> steps = steps_of(cell, gaps);
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    CHECK(gaps[i].is_first == (i == 0 || steps[i - 1].to != steps[i].from));
    CHECK(gaps[i].is_last == (i + 1 == gaps.size() || steps[i + 1].from != steps[i].to));
  }
}

std::vector<Step> reversed(std::vector<Step> steps) {
  std::reverse(steps.begin(), steps.end());
  for (Step& s : steps) std::swap(s.from, s.to);
  return steps;
}

/// What of R1 is kept: all, nothing, or some.
std::vector<Flags> solids(const CellComplex& cell, std::mt19937& random) {
  const Flags r1 = r1_of(cell);
  std::vector<Flags> list{r1, Flags(r1.size(), 0), Flags(r1.size(), 1)};
  for (const std::uint32_t share : {3U, 6U, 9U}) {
    list.push_back(Flags(r1.size(), 1));
    for (std::uint8_t& k : list.back()) k = random() % 10 < share;
  }
  return list;
}

/// How often each kind of fan occurred.
struct Seen {
  std::size_t whole = 0, bare = 0, open_at_first = 0, open_at_last = 0, inside = 0, several = 0, one_tet = 0,
              two_faces = 0;

  void add(const Fan& fan) {
    const std::size_t n = fan.all.size();
    one_tet += n == 1 ? 1U : 0U;
    if (!fan.broken) {
      ++whole;
    } else if (fan.gaps > 1) {
      ++several;
    } else {
      const bool first = fan.bare.front().tet == fan.all.front().tet;
      const bool last = fan.bare.back().tet == fan.all.back().tet;
      ++(first && last ? bare : first ? open_at_first : last ? open_at_last : inside);
    }
  }
};

void check_same(const CellComplex& cell, const Ground& ground, const Flags& kept,
                const std::map<Simplex, Fan>& fans) {
  std::set<Simplex> found;
  for (const BrokenFan& b : broken_fans(cell, ground, kept)) {
    const Simplex edge{b.edge[0], b.edge[1]};
    CHECK(edge[0] < edge[1]);
    REQUIRE(fans.count(edge) == 1);
    CHECK(found.insert(edge).second);
    const Fan& fan = fans.at(edge);
    CHECK(fan.broken);
    CHECK(b.ground[0] < b.ground[1]);
    const auto triangle = [&](std::size_t k) {
      const Facet& f = ground.facet(b.ground[k]);
      return facet_of(cell, f.tet, f.facet);
    };
    const bool turned = triangle(0) != fan.ground[0];
    CHECK(triangle(turned ? 1 : 0) == fan.ground[0]);
    CHECK(triangle(turned ? 0 : 1) == fan.ground[1]);
    CHECK(steps_of(cell, b.gaps) == (turned ? reversed(fan.bare) : fan.bare));
    check_ends(cell, b.gaps);
  }
  for (const auto& [edge, fan] : fans) CHECK(fan.broken == (found.count(edge) != 0));
}

/// Edge and gap of each, whatever the numbers of the tetrahedra: from[t] is the number that t had.
std::set<std::pair<Simplex, std::set<std::size_t>>> by_names(const std::vector<BrokenFan>& fans,
                                                             const std::vector<std::uint32_t>& from) {
  std::set<std::pair<Simplex, std::set<std::size_t>>> names;
  for (const BrokenFan& fan : fans) {
    std::set<std::size_t> gap;
    for (const GapTet& g : fan.gaps) gap.insert(from[g.tet]);
    names.insert({{fan.edge[0], fan.edge[1]}, gap});
  }
  CHECK(names.size() == fans.size());
  return names;
}

/// Five tetrahedra around the edge 0-1 from the ground triangle 0 1 2 to 0 1 7.
CellComplex half_turn() {
  std::vector<Tet> tets;
  for (std::uint32_t i = 2; i < 7; ++i) tets.push_back({0, 1, i, i + 1});
  return make_cell(tets, {3, 3, 1, 0, 0, 0, 0, 2}, {{0, 1, 2}, {0, 1, 7}});
}

}  // namespace

TEST_CASE("random cells: broken fans are those of the definition") {
  Seen seen;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const CellComplex cell = seed % 2 == 0 ? random_cell(seed) : deep_cell(seed);
    const Ground ground(cell);
    const BruteSolid solid(cell);
    for (const Flags& kept : solids(cell, random)) {
      CAPTURE(kept);
      const std::map<Simplex, Fan> fans = all_fans(solid, kept);
      check_same(cell, ground, kept, fans);
      for (const auto& [edge, fan] : fans) {
        seen.add(fan);
        const bool one_face = (cell.faces_of(fan.ground[0][0])[0] & cell.faces_of(fan.ground[0][1])[0] &
                               cell.faces_of(fan.ground[0][2])[0] & cell.faces_of(fan.ground[1][0])[0] &
                               cell.faces_of(fan.ground[1][1])[0] & cell.faces_of(fan.ground[1][2])[0]) != 0;
        seen.two_faces += one_face ? 0U : 1U;
      }
    }
  }
  MESSAGE("whole " << seen.whole << ", bare " << seen.bare << ", open at the first end " << seen.open_at_first
                   << ", at the last " << seen.open_at_last << ", inside " << seen.inside << ", several gaps "
                   << seen.several << ", of one tetrahedron " << seen.one_tet << ", between two faces "
                   << seen.two_faces);
  for (const std::size_t count : {seen.whole, seen.bare, seen.open_at_first, seen.open_at_last, seen.inside,
                                  seen.several, seen.one_tet, seen.two_faces})
    CHECK(count > 50);
}

TEST_CASE("random cells: broken fans do not depend on the numbers of the tetrahedra") {
  std::size_t gaps = 0;
  for (std::uint32_t seed = 400; seed < 460; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const CellComplex cell = random_cell(seed);
    std::vector<std::uint32_t> from, same(cell.mesh.size());
    for (std::uint32_t t = 0; t < same.size(); ++t) same[t] = t;
    const CellComplex other = shuffled(cell, random, from);
    for (const Flags& kept : solids(cell, random)) {
      Flags moved;
      for (const std::uint32_t t : from) moved.push_back(kept[t]);
      const auto names = by_names(broken_fans(cell, Ground(cell), kept), same);
      CHECK(names == by_names(broken_fans(other, Ground(other), moved), from));
      gaps += names.size();
    }
  }
  CHECK(gaps > 1000);
}

TEST_CASE("one fan: gaps are what is not kept") {
  const CellComplex cell = half_turn();
  const Ground ground(cell);
  using List = std::vector<std::uint32_t>;
  const auto gaps_of = [&](const Flags& kept) {
    const std::vector<BrokenFan> fans = broken_fans(cell, ground, kept);
    REQUIRE(fans.size() == 1);
    CHECK(fans[0].edge == std::array<std::uint32_t, 2>{0, 1});
    std::vector<List> gaps;
    for (const GapTet& g : fans[0].gaps) {
      if (g.is_first) gaps.emplace_back();
      gaps.back().push_back(g.tet);
    }
    return gaps;
  };
  using Lists = std::vector<List>;
  CHECK(broken_fans(cell, ground, {1, 1, 1, 1, 1}).empty());
  CHECK(gaps_of({0, 0, 0, 0, 0}) == Lists{{0, 1, 2, 3, 4}});
  CHECK(gaps_of({1, 0, 0, 1, 1}) == Lists{{1, 2}});
  CHECK(gaps_of({0, 1, 1, 1, 1}) == Lists{{0}});
  CHECK(gaps_of({1, 1, 1, 0, 0}) == Lists{{3, 4}});
  CHECK(gaps_of({1, 0, 1, 0, 1}) == Lists{{1}, {3}});
  CHECK(gaps_of({0, 0, 1, 0, 0}) == Lists{{0, 1}, {3, 4}});
}

TEST_CASE("an edge at the border of the section has no fan that could break") {
  const CellComplex cell = make_cell({{0, 1, 2, 3}, {0, 1, 3, 4}}, {1, 1, 1, 0, 1}, {{0, 1, 2}});
  CHECK(broken_fans(cell, Ground(cell), {0, 0}).empty());
}
