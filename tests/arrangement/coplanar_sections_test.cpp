#include "../../arrangement/coplanar_sections.h"

#include <doctest/doctest.h>

#include <utility>

#include "../../geom/frame.h"

using namespace crossloft;

namespace {

/// A section from (u, v) coordinates in a tilted plane, so that no axis is special.
const LatticePlane kPlane = plane_through({3, -7, 2}, {1, 2, 3}, {0, 0, 0});

void add(LatticeSection& s, const std::vector<std::pair<int, int>>& corners) {
  const auto first = static_cast<std::uint32_t>(s.vertices.size()),
             n = static_cast<std::uint32_t>(corners.size());
  for (std::uint32_t i = 0; i < n; ++i) {
    LatticeVector x = kPlane.origin;
    for (std::size_t k = 0; k < 3; ++k)
      x[k] += 1000 * (corners[i].first * kPlane.e1[k] + corners[i].second * kPlane.e2[k]);
    s.vertices.push_back(make_point(x));
    s.input.push_back({static_cast<double>(x[0]), static_cast<double>(x[1]), static_cast<double>(x[2])});
    s.walls.push_back({first + i, first + (i + 1) % n, 0, 0, i});
  }
}

LatticeSection section(const std::vector<std::pair<int, int>>& corners) {
  LatticeSection s;
  add(s, corners);
  tidy(s);
  return s;
}

SectionRelation both_ways(const LatticeSection& a, const LatticeSection& b) {
  const SectionRelation r = relation(kPlane, a, b, 10);
  CHECK(relation(kPlane, b, a, 10) == r);
  return r;
}

}  // namespace

TEST_CASE("tidy sorts, merges and cancels") {
  LatticeSection s;
  add(s, {{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  add(s, {{2, 0}, {4, 0}, {4, 2}, {2, 2}});  // shares an edge
  add(s, {{9, 9}, {8, 8}});                  // there and back
  tidy(s);
  CHECK(s.vertices.size() == 6);
  CHECK(s.walls.size() == 6);
  for (std::size_t v = 1; v < s.vertices.size(); ++v)
    CHECK(compare_lex(s.vertices[v - 1], s.vertices[v]) < 0);
  for (std::size_t v = 0; v < s.vertices.size(); ++v) CHECK(s.input[v].x == s.vertices[v].x);
  for (const WallEdge& w : s.walls) CHECK(w.a < w.b);
}

TEST_CASE("sections against a square") {
  const LatticeSection square = section({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  CHECK(both_ways(square, square) == SectionRelation::same);
  CHECK(both_ways(square, section({{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}})) == SectionRelation::same);
  CHECK(both_ways(square, section({{5, 0}, {9, 0}, {9, 4}})) == SectionRelation::apart);
  CHECK(both_ways(square, section({{4, 0}, {8, 0}, {8, 4}, {4, 4}})) == SectionRelation::apart);
  CHECK(both_ways(square, section({{4, 4}, {8, 4}, {8, 8}})) == SectionRelation::apart);
  CHECK(both_ways(square, section({{4, 1}, {8, 1}, {8, 3}})) == SectionRelation::apart);
  CHECK(both_ways(square, section({{2, 2}, {8, 2}, {8, 8}})) == SectionRelation::overlapping);
  CHECK(both_ways(square, section({{1, 1}, {3, 1}, {3, 3}})) == SectionRelation::overlapping);
  CHECK(both_ways(square, section({{0, 0}, {4, 0}, {4, 4}})) == SectionRelation::overlapping);
  CHECK(both_ways(square, section({{0, 0}, {4, 0}, {4, 8}, {0, 8}})) == SectionRelation::overlapping);
  CHECK(both_ways(square, section({{0, -1}, {4, -1}, {4, 5}, {0, 5}})) == SectionRelation::overlapping);
  CHECK(both_ways(square, LatticeSection{}) == SectionRelation::apart);
}

TEST_CASE("sections overlap in a square that they enter and leave through each other's vertices") {
  // Edge (1,1)(-9,1) of the first runs through a vertex of the second, and so on: no two edges cross, no
  // vertex and no middle of an edge is inside.
  const LatticeSection a = section({{0, 0}, {10, 0}, {10, 2}, {1, 1}, {-9, 1}, {-9, -1}});
  const LatticeSection b = section({{1, 0}, {1, 10}, {-1, 10}, {0, 1}, {0, -9}, {2, -9}});
  CHECK(both_ways(a, b) == SectionRelation::overlapping);
}

TEST_CASE("sections with one whole contour in common overlap, those that share borders alone are apart") {
  LatticeSection a = section({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), b = a;
  add(a, {{6, 0}, {8, 0}, {8, 2}});
  add(b, {{6, 6}, {8, 6}, {8, 8}});
  tidy(a), tidy(b);
  CHECK(both_ways(a, b) == SectionRelation::overlapping);

  LatticeSection ring = section({{0, 0}, {6, 0}, {6, 6}, {0, 6}});
  add(ring, {{2, 2}, {4, 2}, {4, 4}, {2, 4}});
  tidy(ring);
  CHECK(both_ways(ring, section({{2, 2}, {4, 2}, {4, 4}, {3, 4}, {2, 4}})) == SectionRelation::apart);
  CHECK(both_ways(ring, section({{2, 2}, {4, 2}, {4, 4}, {2, 6}})) == SectionRelation::overlapping);
}

TEST_CASE("vertices within the tolerance are the same ones") {
  const LatticeSection square = section({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  LatticeSection moved = square;
  for (LatticePoint& p : moved.vertices)
    p = {p.x + 7, p.y + 3, p.z, nullptr};  // along the plane: 3 * 7 - 7 * 3 = 0
  CHECK(both_ways(square, moved) == SectionRelation::same);
  CHECK(relation(kPlane, square, moved, 1) == SectionRelation::overlapping);
}
