// The checks of pruning's input and output find what is broken.
#include "prune/verify.h"

#include <doctest/doctest.h>

#include "cells.h"

namespace {

using namespace crossloft;
using namespace crossloft::test;

/// A prism between the triangles 0 1 2 (face 0) and 3 4 5 (face 1) in three tetrahedra: T_vf, T_ee, T_vf.
CellComplex prism(bool top_internal = true) {
  std::set<Triangle> internal{{0, 1, 2}};
  if (top_internal) internal.insert({3, 4, 5});
  return make_cell({{0, 1, 2, 3}, {1, 2, 3, 4}, {2, 3, 4, 5}}, {1, 1, 1, 2, 2, 2}, internal);
}

}  // namespace

TEST_CASE("a good cell passes, each kind of damage is found") {
  CHECK(verify(prism()));
  const auto broken = [](auto damage) {
    CellComplex cell = prism();
    damage(cell);
    return !verify(cell);
  };
  CHECK(broken([](CellComplex& c) { c.facets.pop_back(); }));
  CHECK(broken([](CellComplex& c) { c.face_masks.pop_back(); }));
  CHECK(broken([](CellComplex& c) { c.mesh.vertices[0][0] = 6; }));
  CHECK(broken([](CellComplex& c) { c.mesh.vertices[0][0] = 1; }));
  CHECK(broken([](CellComplex& c) { c.mesh.neighbours[0][0] = 2; }));
  CHECK(broken([](CellComplex& c) { c.facets[0][3] = FacetKind::free; }));
  CHECK(broken([](CellComplex& c) { c.facets[0][2] = FacetKind::internal; }));
  CHECK(broken([](CellComplex& c) { c.edges[0][0] = EdgeKind::free; }));
  CHECK(broken(
      [](CellComplex& c) { c.edges[0][3] = EdgeKind::external; }));  // 1-2, which tetrahedron 1 has too
}

TEST_CASE("a good result passes, each kind of damage is found") {
  const CellComplex cell = prism();
  const PruneResult good = prune(cell, PruneMode::joint);
  CHECK(good.r3 == 3);
  CHECK(verify(cell, good));
  PruneResult bad = good;
  bad.r3 = 2;
  CHECK_FALSE(verify(cell, bad));
  bad = good;
  bad.kept[2] = 0;  // the middle one has no ground at 3-4 any more
  bad.r2 = bad.r3 = 2;
  CHECK_FALSE(verify(cell, bad));
  bad = good;
  bad.kept.pop_back();
  CHECK_FALSE(verify(cell, bad));
  // The same result where the upper triangle is outside: its tetrahedra don't conform.
  CHECK_FALSE(verify(prism(false), good));
}
