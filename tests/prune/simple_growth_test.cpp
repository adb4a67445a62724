// Growth by moves: no handle, whatever is allowed and in whatever order; joins and wishes as asked.
#include "prune/simple_growth.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "brute_solid.h"
#include "cells.h"

namespace {

using namespace crossloft;
using namespace crossloft::test;

constexpr std::int32_t kLow = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t kHigh = std::numeric_limits<std::int32_t>::max();

/// Few different values, so that ties occur.
std::vector<std::int32_t> random_confidence(std::size_t n, std::mt19937& random) {
  std::vector<std::int32_t> c(n);
  for (std::int32_t& x : c) x = static_cast<std::int32_t>(random() % 9) - 4;
  return c;
}

/// Few vertices on the faces and some within: holes, tunnels and domes to decide on.
CellComplex any_cell(std::uint32_t seed) { return seed % 2 == 0 ? random_cell(seed) : deep_cell(seed); }

/// What growth may be given: all tetrahedra without an external facet.
Flags without_external_facet(const CellComplex& cell) {
  Flags flags;
  for (const auto& facets : cell.facets)
    flags.push_back(std::find(facets.begin(), facets.end(), FacetKind::external) == facets.end());
  return flags;
}

/// No vertex has two corners of sections that hang together elsewhere at most. (Where sections touch in a
/// point, the surface that is cut apart there counts one part of the outside more than growth does.)
bool has_no_touching_sections(const BruteSolid& brute) {
  const Flags none(brute.tets(), 0);
  std::map<std::uint32_t, std::set<std::size_t>> corners;
  for (const std::size_t p : brute.ground())
    for (const std::uint32_t v : brute.pieces()[p]) corners[v].insert(brute.star(none, {v}).of(p));
  return std::all_of(corners.begin(), corners.end(), [](const auto& c) { return c.second.size() == 1; });
}

/// A few per cent are missing: enough for holes to go around, too few to fall apart; or half of all.
Flags random_subset(const Flags& flags, std::mt19937& random) {
  const std::uint32_t toss = random() % 4, missing = toss == 0 ? 50 : 4 * toss;
  Flags subset = flags;
  for (std::uint8_t& x : subset) x = x != 0 && random() % 100 >= missing;
  return subset;
}

/// Two disjoint halves of a random choice of the section vertices.
JoinWish random_wish(const CellComplex& cell, bool join, std::mt19937& random) {
  std::set<std::uint32_t> vertices;
  for (std::uint32_t t = 0; t < cell.mesh.size(); ++t)
    for (unsigned i = 0; i < 4; ++i)
      if (cell.facets[t][i] == FacetKind::internal)
        for (const std::uint8_t slot : kFacetSlots[i]) vertices.insert(cell.mesh.vertices[t][slot]);
  JoinWish wish{{}, {}, join};
  for (const std::uint32_t v : vertices) {
    const std::uint32_t toss = random() % 3;
    if (toss == 0) wish.a.push_back(v);
    if (toss == 1) wish.b.push_back(v);
  }
  return wish;
}

/// A cell, the same by its definition, and confidences; `random` goes on from there.
struct Trial {
  Trial(std::uint32_t seed, CellComplex&& any)
      : random(seed),
        cell(std::move(any)),
        ground(cell),
        brute(cell),
        confidence(random_confidence(cell.mesh.size(), random)) {}
  Trial(const Trial&) = delete;

  GrowthResult grow(const Flags& allowed, const GrowthLimits& limits) const {
    return grow_simply(cell, ground, allowed, confidence, limits);
  }

  std::mt19937 random;
  const CellComplex cell;
  const Ground ground;
  const BruteSolid brute;
  const std::vector<std::int32_t> confidence;
};

std::size_t body_count(const BruteSolid& brute, const Flags& kept) { return brute.count(kept).bodies; }

/// Ground prisms with each body's smallest vertex.
std::map<std::size_t, std::uint32_t> names(const BruteSolid& brute, const Flags& kept) {
  const Groups bodies = brute.bodies(kept);
  std::map<std::size_t, std::uint32_t> name;
  for (const std::size_t p : brute.ground()) {
    const auto [entry, is_new] = name.emplace(bodies.of(p), brute.pieces()[p][0]);
    if (!is_new) entry->second = std::min(entry->second, brute.pieces()[p][0]);
  }
  return name;
}

std::multiset<std::uint32_t> name_list(const BruteSolid& brute, const Flags& kept) {
  std::multiset<std::uint32_t> list;
  for (const auto& [body, name] : names(brute, kept)) list.insert(name);
  return list;
}

std::vector<Join> done(const GrowthResult& result) {
  std::vector<Join> list = result.joins;
  list.erase(std::remove_if(list.begin(), list.end(), [](const Join& j) { return !j.done; }), list.end());
  return list;
}

}  // namespace

TEST_CASE("random cells: no handle and no void, whatever is allowed and however sure it is") {
  std::size_t kept_count = 0, domes = 0, joins = 0, refused = 0, left = 0;
  for (std::uint32_t seed = 0; seed < 1200; ++seed) {
    CAPTURE(seed);
    Trial trial(seed, any_cell(seed));
    const Flags most = without_external_facet(trial.cell);
    const Flags allowed = seed % 8 < 2 ? most : random_subset(most, trial.random);
    const GrowthLimits limits{static_cast<std::int32_t>(trial.random() % 12) - 6,
                              static_cast<std::int32_t>(trial.random() % 9) - 6,
                              {}};
    const GrowthResult result = trial.grow(allowed, limits);
    const BruteSolid::Counts counts = trial.brute.count(result.kept);
    CHECK(counts.genus == 0);
    CHECK(counts.voids == 0);
    CHECK(counts.bodies <= counts.sections);
    CHECK(counts.bodies + done(result).size() == counts.sections);
    // Only domes close something off.
    if (result.domes.empty() && has_no_touching_sections(trial.brute))
      CHECK(counts.outsides <= trial.brute.count(Flags(allowed.size(), 0)).outsides);
    for (std::uint32_t t = 0; t < allowed.size(); ++t) {
      CHECK(result.kept[t] <= allowed[t]);
      kept_count += result.kept[t];
      left += allowed[t] - result.kept[t];
    }
    domes += result.domes.size();
    joins += done(result).size();
    refused += result.joins.size() - done(result).size();
  }
  MESSAGE("kept " << kept_count << ", left " << left << ", domes " << domes << ", joins " << joins
                  << ", refused " << refused);
  CHECK(kept_count > 1000);
  CHECK(left > 100);
  CHECK(domes > 5);
  CHECK(joins > 100);
  CHECK(refused > 50);
}

TEST_CASE(
    "random cells: the genus is the number of handles that the sections ask for, and nothing fills them") {
  std::size_t handles = 0, none = 0;
  for (std::uint32_t seed = 0; seed < 1200; ++seed) {
    CAPTURE(seed);
    Trial trial(seed, any_cell(seed));
    const Flags allowed = random_subset(without_external_facet(trial.cell), trial.random);
    Flags wider(allowed.size());
    const std::uint32_t share = trial.random() % 100;
    for (std::uint8_t& x : wider) x = trial.random() % 100 < share ? 1 : 0;
    GrowthLimits limits{-4, -4, {}, {}, -2, [&](std::uint32_t t) { return wider[t] != 0; }};
    const GrowthResult result = trial.grow(allowed, limits);
    const BruteSolid::Counts counts = trial.brute.count(result.kept);
    CHECK(counts.genus <= result.handles);
    if (has_no_touching_sections(trial.brute)) CHECK(counts.genus == result.handles);
    CHECK(counts.voids == 0);
    handles += result.handles;
    // Where all may be filled no ring is open: a cell is a ball.
    limits.may_fill = [](std::uint32_t) { return true; };
    none += trial.grow(allowed, limits).handles;
    limits.handle = kHigh;
    limits.may_fill = [](std::uint32_t) { return false; };
    none += trial.grow(allowed, limits).handles;
  }
  MESSAGE("handles " << handles);
  CHECK(handles > 10);
  CHECK(none == 0);
}

TEST_CASE("a dome must not close in what hangs on the outside at an edge only") {
  // What is not allowed here are single tetrahedra within; growth once closed some in at their last open
  // edge.
  std::size_t domes = 0;
  for (std::uint32_t seed = 2000; seed < 2400; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const CellComplex cell = deep_cell(seed);
    Flags allowed = without_external_facet(cell);
    for (std::uint8_t& x : allowed) x = x != 0 && random() % 100 >= 5;
    std::vector<std::int32_t> confidence(allowed.size());
    for (std::int32_t& c : confidence) c = static_cast<std::int32_t>(random() % 1000);
    const GrowthResult result = grow_simply(cell, Ground(cell), allowed, confidence, {0, 0, {}});
    const BruteSolid::Counts counts = BruteSolid(cell).count(result.kept);
    CHECK(counts.voids == 0);
    CHECK(counts.genus == 0);
    domes += result.domes.size();
  }
  CHECK(domes > 0);
}

/// Parts of the tetrahedra outside, hanging together at edges, that open to no triangle of the hull; at the
/// edge of a section some are connected with the outside beyond it.
std::size_t pockets(const BruteSolid& brute, const Flags& kept) {
  Groups parts(brute.tets());
  std::set<std::size_t> open;
  const auto touch = [&](std::size_t a, std::size_t b) {
    Simplex common;
    std::set_intersection(brute.pieces()[a].begin(), brute.pieces()[a].end(), brute.pieces()[b].begin(),
                          brute.pieces()[b].end(), std::back_inserter(common));
    return common.size();
  };
  for (std::size_t a = 0; a < brute.tets(); ++a)
    for (std::size_t b = 0; kept[a] == 0 && b < brute.pieces().size(); ++b) {
      if (b == a || brute.is_solid(kept, b)) continue;
      if (b < brute.tets() && touch(a, b) >= 2) parts.put_together(a, b);
      if (b >= brute.tets() && touch(a, b) == 3) open.insert(a);
    }
  std::set<std::size_t> closed;
  for (std::size_t a = 0; a < brute.tets(); ++a)
    if (kept[a] == 0) closed.insert(parts.of(a));
  for (const std::size_t a : open) closed.erase(parts.of(a));
  return closed.size();
}

TEST_CASE("random cells: what is left could not be added by a simple move") {
  for (std::uint32_t seed = 400; seed < 480; ++seed) {
    CAPTURE(seed);
    Trial trial(seed, any_cell(seed));
    if (!has_no_touching_sections(trial.brute)) continue;
    const Flags allowed = random_subset(without_external_facet(trial.cell), trial.random);
    const Flags kept = trial.grow(allowed, {kLow, kLow, {}}).kept;
    const BruteSolid::Counts before = trial.brute.count(kept);
    for (std::uint32_t t = 0; t < kept.size(); ++t) {
      if (allowed[t] == 0 || kept[t] != 0) continue;
      CAPTURE(t);
      Flags more = kept;
      more[t] = 1;
      const BruteSolid::Counts now = trial.brute.count(more);
      // Joins and domes are free here: what is left would make a handle or close something in, or has no
      // contact.
      CHECK((now.genus > before.genus || now.bodies > before.bodies ||
             pockets(trial.brute, more) > pockets(trial.brute, kept)));
    }
  }
}

TEST_CASE("random cells: joins need their confidence and name the bodies by their smallest vertices") {
  std::size_t joins = 0, refused = 0;
  for (std::uint32_t seed = 500; seed < 700; ++seed) {
    CAPTURE(seed);
    Trial trial(seed, random_cell(seed));
    const GrowthLimits limits{1, 0, {}};
    const GrowthResult result = trial.grow(r1_of(trial.cell), limits);
    std::multiset<std::uint32_t> bodies = name_list(trial.brute, Flags(trial.cell.mesh.size(), 0));
    for (const Join& j : result.joins) {
      CHECK(j.a <= j.b);
      CHECK(bodies.count(j.a) != 0);
      CHECK(bodies.count(j.b) != 0);
      CHECK(j.done == (j.confidence >= limits.join));
      if (j.done) bodies.erase(bodies.find(j.b));
      ++(j.done ? joins : refused);
    }
    CHECK(bodies == name_list(trial.brute, result.kept));
    // Refused joins come last, once a pair.
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::size_t i = done(result).size(); i < result.joins.size(); ++i) {
      CHECK(!result.joins[i].done);
      CHECK(pairs.emplace(result.joins[i].a, result.joins[i].b).second);
    }
  }
  CHECK(joins > 50);
  CHECK(refused > 50);
}

TEST_CASE(
    "random cells: with a limit above all confidences nothing is joined, below all everything that can be") {
  std::size_t more = 0;
  for (std::uint32_t seed = 700; seed < 800; ++seed) {
    CAPTURE(seed);
    Trial trial(seed, random_cell(seed));
    const Flags apart = trial.grow(r1_of(trial.cell), {kHigh, kLow, {}}).kept;
    const Flags joined = trial.grow(r1_of(trial.cell), {kLow, kLow, {}}).kept;
    CHECK(body_count(trial.brute, apart) == trial.ground.part_count());
    CHECK(body_count(trial.brute, joined) <= trial.ground.part_count());
    more += body_count(trial.brute, apart) - body_count(trial.brute, joined);
  }
  CHECK(more > 50);
}

TEST_CASE("random cells: a wish that sets stay apart is kept, one that they join goes before the limit") {
  std::size_t forbidden = 0, forced = 0;
  for (std::uint32_t seed = 800; seed < 1000; ++seed) {
    CAPTURE(seed);
    Trial trial(seed, random_cell(seed));
    const Flags none(trial.cell.mesh.size(), 0);
    // The vertices of a wish by the part of the ground that they are in, before and after.
    const auto mixed = [&](const JoinWish& wish, const Flags& kept) {
      const Groups bodies = trial.brute.bodies(kept);
      std::map<std::size_t, std::set<std::size_t>> parts[2];  // by body: parts of the ground with a side
      const Groups sections = trial.brute.bodies(none);
      for (const std::size_t p : trial.brute.ground())
        for (const std::uint32_t v : trial.brute.pieces()[p])
          for (const std::size_t side : {0, 1}) {
            const auto& list = side == 0 ? wish.a : wish.b;
            if (std::count(list.begin(), list.end(), v) != 0)
              parts[side][bodies.of(p)].insert(sections.of(p));
          }
      std::size_t bad = 0;  // bodies that have both sides from different parts
      for (const auto& [body, list] : parts[0]) {
        const auto other = parts[1].find(body);
        if (other != parts[1].end() && (list != other->second || list.size() > 1)) ++bad;
      }
      return bad;
    };
    JoinWish wish = random_wish(trial.cell, false, trial.random);
    const GrowthResult apart = trial.grow(r1_of(trial.cell), {kLow, kLow, {&wish, 1}});
    CHECK(mixed(wish, apart.kept) == 0);
    const GrowthResult freely = trial.grow(r1_of(trial.cell), {kLow, kLow, {}});
    forbidden += mixed(wish, freely.kept);
    wish.join = true;
    const GrowthResult joined = trial.grow(r1_of(trial.cell), {kHigh, kLow, {&wish, 1}});
    forced += done(joined).size();
    if (!done(joined).empty()) CHECK(mixed(wish, joined.kept) > 0);
  }
  CHECK(forbidden > 50);
  CHECK(forced > 50);
}

TEST_CASE("random cells: growth does not depend on the numbers of the tetrahedra nor on their slots") {
  for (std::uint32_t seed = 1000; seed < 1300; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const CellComplex cell = any_cell(seed);
    std::vector<std::uint32_t> from;
    const CellComplex other = shuffled(cell, random, from);
    const Flags allowed = random_subset(without_external_facet(cell), random);
    const auto confidence = random_confidence(cell.mesh.size(), random);
    const JoinWish wish = random_wish(cell, random() % 2 == 0, random);
    const GrowthLimits limits{0, 0, {&wish, seed % 2}};
    const GrowthResult a = grow_simply(cell, Ground(cell), allowed, confidence, limits);
    Flags moved;
    std::vector<std::int32_t> moved_confidence;
    for (const std::uint32_t t : from) {
      moved.push_back(allowed[t]);
      moved_confidence.push_back(confidence[t]);
    }
    const GrowthResult b = grow_simply(other, Ground(other), moved, moved_confidence, limits);
    Flags expected;
    for (const std::uint32_t t : from) expected.push_back(a.kept[t]);
    CHECK(b.kept == expected);
    CHECK(b.joins == a.joins);
    CHECK(b.domes == a.domes);
  }
}

TEST_CASE("two triangles in a prism: the middle tetrahedron joins them if it is sure enough, or wished") {
  const CellComplex cell =
      make_cell({{0, 1, 2, 3}, {1, 2, 3, 4}, {2, 3, 4, 5}}, {1, 1, 1, 2, 2, 2}, {{0, 1, 2}, {3, 4, 5}});
  const Ground ground(cell);
  const std::vector<std::int32_t> confidence{9, -5, 7};
  const Flags all{1, 1, 1};
  const auto grow = [&](std::int32_t limit, std::span<const JoinWish> wishes) {
    return grow_simply(cell, ground, all, confidence, {limit, 0, wishes});
  };
  const Join join{0, 3, -5, true}, refused{0, 3, -5, false};
  CHECK(grow(-5, {}).kept == Flags{1, 1, 1});
  CHECK(grow(-5, {}).joins == std::vector<Join>{join});
  CHECK(grow(-4, {}).kept == Flags{1, 0, 1});
  CHECK(grow(-4, {}).joins == std::vector<Join>{refused});
  const std::vector<JoinWish> wanted{{{0}, {5}, true}}, forbidden{{{4}, {1, 2}, false}},
      elsewhere{{{0}, {1}, true}};
  CHECK(grow(100, wanted).joins == std::vector<Join>{join});
  CHECK(grow(-100, forbidden).joins == std::vector<Join>{refused});
  CHECK(grow(100, elsewhere).joins == std::vector<Join>{refused});  // both sides in one body already
}

TEST_CASE("random cells: once the flag is raised nothing grows any more") {
  const std::atomic<bool> raised{true};
  std::size_t grown = 0;
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const CellComplex cell = random_cell(seed);
    const Ground ground(cell);
    const std::vector<std::int32_t> confidence(cell.mesh.size(), 0);
    GrowthLimits limits;
    const Flags kept = grow_simply(cell, ground, r1_of(cell), confidence, limits).kept;
    grown += kept != Flags(cell.mesh.size(), 0) ? 1 : 0;
    limits.cancel = &raised;
    CHECK(grow_simply(cell, ground, r1_of(cell), confidence, limits).kept == Flags(cell.mesh.size(), 0));
  }
  CHECK(grown > 5);
}
