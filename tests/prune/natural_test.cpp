// The mode `natural` as a whole.
#include "prune/natural.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "brute_solid.h"
#include "cells.h"
#include "prune/confidence.h"
#include "prune/energy.h"
#include "prune/interior_places.h"
#include "prune/outside.h"
#include "prune/prune.h"
#include "prune/section_field.h"
#include "prune/solidity.h"
#include "prune/verify.h"

namespace {

using namespace crossloft;
using namespace crossloft::test;

/// The defaults, or limits that some cells don't meet.
NaturalOptions options_for(std::uint32_t seed) {
  NaturalOptions options;
  if (seed % 3 == 0) options.join_confidence = -0.1;
  if (seed % 3 == 1)
    options.join_confidence = 0.3, options.dome_confidence = 0.3, options.smooth_weight = 0.2;
  if (seed % 3 == 2) options.join_confidence = -1, options.dome_confidence = 0.9, options.smooth_weight = 3;
  return options;
}

PruneResult prune_cell(const PlacedCell& cell, const NaturalOptions& options,
                       std::span<const JoinWish> wishes = {}) {
  CellRequests requests;
  requests.wishes.assign(wishes.begin(), wishes.end());
  return prune(cell.complex, cell.shape, {PruneMode::natural, options}, requests);
}

std::size_t count(const Flags& flags) {
  return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), 1));
}

/// The cell's own sections as all that is known around it.
SectionField own_field(const PlacedCell& cell) {
  const Ground ground(cell.complex);
  const auto vertices = [&](std::uint32_t g) {
    const auto& tet = cell.complex.mesh.vertices[ground.facet(g).tet];
    const auto& slots = kFacetSlots[ground.facet(g).facet];
    return std::array{tet[slots[0]], tet[slots[1]], tet[slots[2]]};
  };
  const auto face_of = [&](std::uint32_t g) {
    const auto v = vertices(g);
    return cell.complex.common_face(v[0], v[1], v[2]);
  };
  std::vector<FieldPlane> planes;
  for (const FacePlane& face : cell.shape.faces) planes.push_back({face, {}});
  for (std::uint32_t g = 0; g < ground.size(); ++g)
    for (unsigned k = 0; k < 3; ++k) {
      const std::uint32_t other = ground.neighbour(g, k);
      if (other != kNone && face_of(other) == face_of(g)) continue;
      const auto v = vertices(g);
      planes[face_of(g)].contour.push_back({cell.shape.points[v[k]], cell.shape.points[v[(k + 1) % 3]]});
    }
  return SectionField(std::move(planes));
}

}  // namespace

TEST_CASE("random cells: no handle, no hole, all within R1 and the cheapest solid; the report says what is") {
  std::size_t grown = 0, handles = 0, joins = 0;
  for (std::uint32_t seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    const PlacedCell cell = placed_cell(seed);
    const NaturalOptions options = options_for(seed);
    const PruneResult result = prune_cell(cell, options);
    CHECK(verify_natural(cell.complex, result));
    const BruteSolid brute(cell.complex);
    const BruteSolid::Counts counts = brute.count(result.kept);
    const NaturalReport& report = result.natural;
    CHECK(counts.genus == report.handles);
    CHECK(counts.voids == 0);
    CHECK(report.after.bodies == counts.bodies);
    CHECK(report.after.outsides == counts.outsides);
    const Flags r1 = r1_of(cell.complex);
    CHECK(result.r1 == count(r1));
    EnergyWeights weights;
    weights.smooth = options.smooth_weight;
    const auto confidence = confidences(cell.complex, cell.shape, r1);
    const Flags cut = cheapest_solid(cell.complex, cell.shape, r1, confidence, weights);
    CHECK(result.r2 == count(cut));
    CHECK(report.before.genus == brute.count(cut).genus);
    for (std::uint32_t t = 0; t < cut.size(); ++t) CHECK(result.kept[t] <= cut[t]);
    std::size_t done = 0;
    for (const Join& j : report.joins) {
      done += j.done ? 1U : 0U;
      CHECK(j.done == (j.confidence >= options.join_confidence * kCertain));
    }
    CHECK(report.after.sections - report.after.bodies == done);
    if (!report.grown) {
      CHECK(result.kept == cut);
      CHECK((report.after.outsides <= 1 || !has_dome(cell.complex, cut)));
    }
    grown += report.grown ? 1U : 0U;
    handles += report.before.genus;
    joins += done;
  }
  MESSAGE("grown " << grown << ", handles before " << handles << ", joins " << joins);
  CHECK(grown > 20);
  CHECK(grown < 380);
  CHECK(joins > 50);
}

TEST_CASE("random cells: where natural is solid and covers the sections, so does joint") {
  std::size_t solid = 0, bare = 0;
  for (std::uint32_t seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    const PlacedCell cell = placed_cell(seed);
    const PruneResult natural = prune_cell(cell, options_for(seed));
    const CellTopology& topology = natural.natural.after;
    const bool is_solid =
        topology.bare == 0 && topology.bad_links == 0 && has_ground_everywhere(cell.complex, natural.kept);
    const Flags joint = prune(cell.complex, PruneMode::joint).kept;
    const Ground ground(cell.complex);
    std::size_t covered = 0;
    for (std::uint32_t g = 0; g < ground.size(); ++g) covered += joint[ground.facet(g).tet];
    if (is_solid) CHECK(covered == ground.size());
    solid += is_solid ? 1U : 0U;
    bare += covered < ground.size() ? 1U : 0U;
  }
  MESSAGE("solid " << solid << ", bare with joint " << bare);
  CHECK(solid > 20);
  CHECK(bare > 20);
}

TEST_CASE("random cells: the result does not depend on the numbers of the tetrahedra nor on their slots") {
  for (std::uint32_t seed = 400; seed < 600; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    PlacedCell cell = turned_cell(seed, random);
    std::vector<std::uint32_t> from;
    const PlacedCell other{shuffled(cell.complex, random, from), cell.shape};
    const PruneResult a = prune_cell(cell, options_for(seed)), b = prune_cell(other, options_for(seed));
    for (std::uint32_t t = 0; t < from.size(); ++t) CHECK(b.kept[t] == a.kept[from[t]]);
    CHECK(b.r2 == a.r2);
    CHECK(b.natural.before == a.natural.before);
    CHECK(b.natural.after == a.natural.after);
    CHECK(b.natural.grown == a.natural.grown);
    CHECK(b.natural.joins == a.natural.joins);
    CHECK(b.natural.domes == a.natural.domes);
  }
}

TEST_CASE("random cells: joins in doubt make no handle and do not depend on numbers") {
  std::size_t changed = 0;
  for (std::uint32_t seed = 800; seed < 1100; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    PlacedCell cell = turned_cell(seed, random);
    const PruneResult alone = prune_cell(cell, {});
    const LazySectionField field([&] { return own_field(cell); });
    cell.shape.field = &field;
    const PruneResult a = prune_cell(cell, {});
    CHECK(verify_natural(cell.complex, a));
    CHECK(BruteSolid(cell.complex).count(a.kept).genus == a.natural.handles);
    changed += a.kept != alone.kept ? 1U : 0U;
    std::vector<std::uint32_t> from;
    const PruneResult b = prune_cell({shuffled(cell.complex, random, from), cell.shape}, {});
    for (std::uint32_t t = 0; t < from.size(); ++t) CHECK(b.kept[t] == a.kept[from[t]]);
    CHECK(b.natural.joins == a.natural.joins);
    NaturalOptions without;
    without.look_around = InCells::off;
    CHECK(prune_cell(cell, without).kept == alone.kept);
  }
  MESSAGE("changed " << changed << " of 300");
  CHECK(changed > 20);
  CHECK(changed < 280);
}

TEST_CASE("whether walls are looked for does not depend on what memory knows of the hull") {
  // Of 150,000 random cells those in which they are, one of them beside a hole that is closed over.
  std::size_t matter = 0;
  for (const std::uint32_t seed : {1414U, 25069U, 35624U, 66704U, 78172U, 115330U, 141784U}) {
    CAPTURE(seed);
    PlacedCell cell = placed_cell(seed);
    NaturalOptions options;
    options.smooth_weight = seed > 100000 ? 1 : 3;
    CellRequests none;
    none.walls = false;
    const Flags kept = prune_cell(cell, options).kept;
    matter += kept != prune(cell.complex, cell.shape, {PruneMode::natural, options}, none).kept ? 1 : 0;
    CellMemory memory;
    cell.shape.memory = &memory;
    interior_places(cell.complex, cell.shape, Ground(cell.complex), -kCertain);
    REQUIRE(memory.hull_parts != kNone);
    CHECK(kept == prune_cell(cell, options).kept);
  }
  CHECK(matter > 5);
}

TEST_CASE("random cells: with good links and ground everywhere a set is solid") {
  std::size_t told = 0, solid = 0;
  for (std::uint32_t seed = 0; seed < 600; ++seed) {
    CAPTURE(seed);
    const PlacedCell cell = placed_cell(seed);
    const PruneResult result = prune_cell(cell, options_for(seed));
    Flags largest = result.kept;
    keep_largest_solid_subset(cell.complex, largest);
    solid += largest == result.kept ? 1U : 0U;
    if (result.natural.after.bad_links != 0 || !has_ground_everywhere(cell.complex, result.kept)) continue;
    ++told;
    CHECK(largest == result.kept);
  }
  CHECK(told > 100);
  CHECK(solid < 600);
}

TEST_CASE("random cells: what joins two sections is undone by a wish") {
  std::size_t undone = 0;
  for (std::uint32_t seed = 600; seed < 800; ++seed) {
    CAPTURE(seed);
    const PlacedCell cell = placed_cell(seed);
    const PruneResult free = prune_cell(cell, {-1, -1, 1});
    if (free.natural.after.sections != 2 || free.natural.after.bodies != 1) continue;
    // The vertices of the two sections.
    const BruteSolid brute(cell.complex);
    const Groups sections = brute.bodies(Flags(free.kept.size(), 0));
    std::vector<std::set<std::uint32_t>> sides(2);
    const std::vector<std::size_t> ground = brute.ground();
    for (const std::size_t p : ground)
      sides[sections.of(p) == sections.of(ground[0]) ? 0 : 1].insert(brute.pieces()[p].begin(),
                                                                     brute.pieces()[p].end());
    const JoinWish wish{{sides[0].begin(), sides[0].end()}, {sides[1].begin(), sides[1].end()}, false};
    const PruneResult apart = prune_cell(cell, {-1, -1, 1}, {&wish, 1});
    CHECK(apart.natural.after.bodies == 2);
    CHECK(apart.natural.grown);
    CHECK(verify_natural(cell.complex, apart));
    ++undone;
  }
  CHECK(undone > 10);
}

TEST_CASE("verify_natural finds each kind of damage") {
  PlacedCell cell;
  cell.complex =
      make_cell({{0, 1, 2, 3}, {1, 2, 3, 4}, {2, 3, 4, 5}}, {1, 1, 1, 2, 2, 2}, {{0, 1, 2}, {3, 4, 5}});
  cell.shape.points = {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 1}, {9, 0, 1}, {0, 9, 1}};
  cell.shape.faces = {{{0, 0, 1}, 0}, {{0, 0, -1}, 1}};
  const PruneResult good = prune_cell(cell, {});
  CHECK(good.r3 == 3);
  REQUIRE(verify_natural(cell.complex, good));
  const auto is_found = [&](auto damage) {
    PruneResult bad = good;
    damage(bad);
    return !verify_natural(cell.complex, bad);
  };
  CHECK(is_found([](PruneResult& r) { r.kept.pop_back(); }));
  CHECK(is_found([](PruneResult& r) { r.r3 = 2; }));
  CHECK(is_found([](PruneResult& r) { r.r2 = r.r1 + 1; }));
  CHECK(is_found([](PruneResult& r) { r.r1 = 2; }));
  CHECK(is_found([](PruneResult& r) { r.natural.after.bodies = 2; }));
  CHECK(is_found([](PruneResult& r) { r.kept[1] = 0, r.r3 = 2; }));  // not the reported topology
  // The same where the upper triangle is outside: it does not conform.
  PruneResult outside = good;
  const CellComplex half = make_cell(cell.complex.mesh.vertices, cell.complex.face_masks, {{0, 1, 2}});
  outside.natural.after = count_topology(half, Ground(half), good.kept);
  CHECK_FALSE(verify_natural(half, outside));
  // A body on no section has a wall without boundary.
  PruneResult island = good;
  const CellComplex bare = make_cell({{0, 1, 2, 3}}, {0, 0, 0, 0}, {});
  island.kept = {1};
  island.r0 = island.r1 = island.r2 = island.r3 = 1;
  island.natural.after = count_topology(bare, Ground(bare), island.kept);
  CHECK_FALSE(verify_natural(bare, island));
}
