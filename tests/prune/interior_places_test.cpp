/// Places for points inside a cell.

#include <doctest/doctest.h>

#include <algorithm>

#include "cells.h"
#include "prune/confidence.h"
#include "prune/interior_places.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

constexpr std::int32_t kLeast = -kCertain / 2;

std::vector<Vec3> places_of(const PlacedCell& cell, std::int32_t least = kLeast) {
  std::vector<Vec3> places = interior_places(cell.complex, cell.shape, Ground(cell.complex), least);
  std::sort(places.begin(), places.end(), [](const Vec3& p, const Vec3& q) {
    return std::array{p.x, p.y, p.z} < std::array{q.x, q.y, q.z};
  });
  return places;
}

}  // namespace

TEST_CASE("random cells: places are inside, and do not depend on the numbers of the tetrahedra") {
  std::size_t found = 0;
  for (std::uint32_t seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    PlacedCell cell = turned_cell(seed, random);
    std::vector<std::uint32_t> from;
    const PlacedCell other{shuffled(cell.complex, random, from), cell.shape};
    const std::vector<Vec3> places = places_of(cell);
    CHECK(places == places_of(other));
    for (const Vec3& p : places)
      for (const FacePlane& face : cell.shape.faces) CHECK(face.height(p) > 0);
    found += places.size();
  }
  CHECK(found > 100);
}

TEST_CASE("random cells: a cell without external tetrahedra is left as it is, surer ways are fewer") {
  std::size_t fewer = 0;
  for (std::uint32_t seed = 300; seed < 600; ++seed) {
    CAPTURE(seed);
    const PlacedCell cell = placed_cell(seed);
    const std::vector<std::uint8_t> r1 = r1_of(cell.complex);
    const std::size_t all = places_of(cell, -kCertain).size(), sure = places_of(cell, kCertain).size();
    if (std::count(r1.begin(), r1.end(), 0) == 0) CHECK(all == 0);
    CHECK(sure <= all);
    fewer += sure < all ? 1U : 0U;
  }
  CHECK(fewer > 0);
}
