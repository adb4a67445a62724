// The judge of joins that bench_joins uses, on solids whose pieces can be told by hand.
#include "bench/cell_truth.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "inspect/solids.h"

namespace {

using namespace crossloft;
using bench::CellTruth;

/// A contour: where it is, and the piece of the cell's surface that its vertices are on.
struct SeenContour {
  std::uint32_t plane = 0;
  Vec3 middle;
  std::uint32_t piece = kNone;
};

/// All contours of the sections whose vertices are on the cell's boundary; each is on one piece.
std::vector<SeenContour> contours_of(const Sections& sections, const CellTruth& truth, Vec3 in_cell) {
  const CellTruth::Sides cell = truth.sides_of(in_cell);
  std::vector<SeenContour> seen;
  for (std::uint32_t p = 0; p < sections.planes.size(); ++p) {
    const PlaneSection& plane = sections.planes[p];
    std::uint32_t count = 0;
    for (const ContourEdge& e : plane.edges) count = std::max(count, e.contour + 1);
    for (std::uint32_t c = 0; c < count; ++c) {
      std::set<std::uint32_t> pieces;
      Vec3 sum;
      double n = 0;
      for (const ContourEdge& e : plane.edges)
        if (e.contour == c) {
          pieces.insert(truth.piece_at(cell, plane.vertices[e.a]));
          sum = sum + plane.vertices[e.a], ++n;
        }
      REQUIRE(pieces.size() == 1);
      seen.push_back({p, (1 / n) * sum, *pieces.begin()});
    }
  }
  return seen;
}

}  // namespace

TEST_CASE("a torus by two planes through its hole: two tubes between them, one beyond") {
  const Surface ring = torus(1, 0.4, 96, 48);
  const std::vector<CuttingPlane> planes{{{1, 0, 0}, -0.31}, {{1, 0, 0}, 0.29}};
  const auto sections = slice(ring, planes);
  REQUIRE(sections.ok());
  const CellTruth truth(ring, planes);

  const auto between = contours_of(*sections, truth, {0, 0, 0});
  REQUIRE(between.size() == 4);
  for (const SeenContour& a : between)
    for (const SeenContour& b : between) {
      CHECK(a.piece != kNone);
      CHECK((a.piece == b.piece) == (a.middle.y * b.middle.y > 0));
    }
  for (const SeenContour& a : contours_of(*sections, truth, {2, 0, 0})) {
    CHECK((a.piece == kNone) == (a.plane == 1));  // the other plane is not at this cell
    for (const SeenContour& b : contours_of(*sections, truth, {2, 0, 0}))
      if (a.plane == 0 && b.plane == 0) CHECK(a.piece == b.piece);
  }
}

TEST_CASE("a hollow ball with a ball in it, by one plane: three pieces on either side") {
  const Surface shells = nested_shells(24);
  const std::vector<CuttingPlane> planes{{{0.1, 0.2, 1}, 0.03}};
  const auto sections = slice(shells, planes);
  REQUIRE(sections.ok());
  const CellTruth truth(shells, planes);
  for (const double z : {-2.0, 2.0}) {
    std::set<std::uint32_t> pieces;
    for (const SeenContour& c : contours_of(*sections, truth, {0, 0, z})) pieces.insert(c.piece);
    CHECK(pieces.size() == 3);
    CHECK(pieces.count(kNone) == 0);
  }
}

TEST_CASE("places nearer than the tolerance are one, also across the borders of boxes") {
  bench::Places places(0.01);
  const std::uint32_t first = places.add({0.0999, 0.2001, -0.0001});
  CHECK(places.add({0.1001, 0.1999, 0.0001}) == first);
  CHECK(places.find({0.12, 0.2, 0}) == kNone);
  CHECK(places.add({0.12, 0.2, 0}) != first);
  CHECK(places.size() == 2);
}
