#include "../../arrangement/section_locator.h"

#include <doctest/doctest.h>

#include <random>

using namespace crossloft;

namespace {

/// The lattice point at (u, v) of a plane.
LatticePoint at(const LatticePlane& plane, std::int64_t u, std::int64_t v) {
  LatticeVector c;
  for (std::size_t k = 0; k < 3; ++k) c[k] = plane.origin[k] + u * plane.e1[k] + v * plane.e2[k];
  return make_point(c);
}

struct Polygon {
  std::vector<std::array<std::int64_t, 2>> corners;  ///< plane coordinates
  std::vector<LatticePoint> points;
  std::vector<WallEnds> walls;

  void close(const LatticePlane& plane) {
    const auto first = static_cast<std::uint32_t>(points.size());
    for (std::size_t i = first; i < corners.size(); ++i) points.push_back(at(plane, corners[i][0], corners[i][1]));
    const auto n = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t i = first; i < n; ++i) walls.push_back({i, i + 1 < n ? i + 1 : first});
  }
};

std::int64_t turn(std::array<std::int64_t, 2> a, std::array<std::int64_t, 2> b, std::array<std::int64_t, 2> c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Even-odd by a ray along +u in small integers; boundary first.
SectionLocator::Place brute_force(const Polygon& polygon, std::array<std::int64_t, 2> p) {
  bool inside = false;
  for (const WallEnds& w : polygon.walls) {
    auto a = polygon.corners[w.a], b = polygon.corners[w.b];
    const bool between = std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]) &&
                         std::min(a[1], b[1]) <= p[1] && p[1] <= std::max(a[1], b[1]);
    if (between && turn(a, b, p) == 0) return SectionLocator::Place::boundary;
    if (a[1] > b[1]) std::swap(a, b);
    if (a[1] <= p[1] && p[1] < b[1] && turn(a, b, p) > 0) inside = !inside;
  }
  return inside ? SectionLocator::Place::inside : SectionLocator::Place::outside;
}

/// True iff the open step from p to q passes through a wall: then the place of q says nothing about that near p.
bool passes_wall(const Polygon& polygon, std::array<std::int64_t, 2> p, std::array<std::int64_t, 2> q) {
  for (const WallEnds& w : polygon.walls) {
    const auto a = polygon.corners[w.a], b = polygon.corners[w.b];
    if (turn(a, b, p) * turn(a, b, q) < 0 && turn(p, q, a) * turn(p, q, b) <= 0) return true;
  }
  return false;
}

/// Planes of every dominant axis and sign.
std::vector<LatticePlane> planes() {
  return {make_axis_plane(0, 3),
          make_axis_plane(1, -4),
          make_axis_plane(2, 5),
          make_lattice_plane({1, 2, 3}, {1, 0, 5}, {0, 1, -7}),
          make_lattice_plane({1, 2, 3}, {0, 1, -7}, {1, 0, 5}),
          make_lattice_plane({-9, 2, 3}, {11, 2, 5}, {3, -8, 1})};
}

/// A comb with a hole, full of walls and vertices on common levels.
Polygon comb(const LatticePlane& plane) {
  Polygon p;
  p.corners = {{0, 0}, {9, 0}, {9, 6}, {8, 6}, {8, 2}, {6, 2}, {6, 6}, {3, 6}, {3, 3}, {2, 6}, {1, 3}, {0, 6}};
  p.close(plane);
  p.corners.insert(p.corners.end(), {{4, 3}, {5, 3}, {5, 5}, {4, 4}});
  p.close(plane);
  return p;
}

}  // namespace

TEST_CASE("locate agrees with a plain even-odd count at every lattice point") {
  for (const LatticePlane& plane : planes()) {
    const Polygon polygon = comb(plane);
    const SectionLocator locator(plane, polygon.points, polygon.walls);
    for (std::int64_t u = -2; u <= 11; ++u)
      for (std::int64_t v = -2; v <= 8; ++v)
        CHECK(locator.locate(at(plane, u, v)) == brute_force(polygon, {u, v}));
  }
}

TEST_CASE("inside_toward agrees with the place of a point a step further") {
  for (const LatticePlane& plane : planes()) {
    Polygon fine = comb(plane);  // four times as large, so that a lattice step is small against the contour
    for (std::size_t i = 0; i < fine.corners.size(); ++i) {
      for (auto& c : fine.corners[i]) c *= 4;
      fine.points[i] = at(plane, fine.corners[i][0], fine.corners[i][1]);
    }
    const SectionLocator locator(plane, fine.points, fine.walls);
    for (std::int64_t u = -1; u <= 38; ++u)
      for (std::int64_t v = -1; v <= 26; ++v)
        for (const auto& d : {std::array<std::int64_t, 2>{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}}) {
          const auto near = brute_force(fine, {u + d[0], v + d[1]});
          if (near == SectionLocator::Place::boundary) continue;  // along a wall the answer is open
          if (passes_wall(fine, {u, v}, {u + d[0], v + d[1]})) continue;
          CAPTURE(u);
          CAPTURE(v);
          CAPTURE(d[0]);
          CAPTURE(d[1]);
          CHECK(locator.inside_toward(at(plane, u, v), at(plane, u + d[0], v + d[1])) ==
                (near == SectionLocator::Place::inside));
        }
  }
}

TEST_CASE("inside_left follows the direction of the wall, not of the plane") {
  for (const LatticePlane& plane : planes()) {
    Polygon polygon = comb(plane);  // outer contour counter-clockwise, hole too
    const SectionLocator locator(plane, polygon.points, polygon.walls);
    for (std::uint32_t w = 0; w < polygon.walls.size(); ++w) CHECK(locator.inside_left(w) == (w < 12));
    for (WallEnds& w : polygon.walls) std::swap(w.a, w.b);
    const SectionLocator reversed(plane, polygon.points, polygon.walls);
    for (std::uint32_t w = 0; w < polygon.walls.size(); ++w) CHECK(reversed.inside_left(w) == (w >= 12));
  }
}

TEST_CASE("conflicts are the pairs that share a point which is no end of both") {
  const std::uint64_t seed = 20240901;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const LatticePlane plane = make_lattice_plane({1, 2, 3}, {1, 0, 5}, {0, 1, -7});
  for (int round = 0; round < 200; ++round) {
    Polygon soup;
    for (int i = 0; i < 24; ++i) {
      soup.corners.push_back({static_cast<std::int64_t>(random() % 9), static_cast<std::int64_t>(random() % 9)});
      soup.points.push_back(at(plane, soup.corners.back()[0], soup.corners.back()[1]));
      if (i % 2 == 1 && soup.corners[soup.corners.size() - 2] != soup.corners.back())
        soup.walls.push_back({static_cast<std::uint32_t>(i - 1), static_cast<std::uint32_t>(i)});
    }
    std::vector<std::array<std::uint32_t, 2>> expected;
    for (std::uint32_t v = 0; v < soup.walls.size(); ++v)
      for (std::uint32_t w = v + 1; w < soup.walls.size(); ++w) {
        // Points of [0,8]^2 with steps of 1/840 are too many; decide by cases in integers instead.
        const auto a = soup.corners[soup.walls[v].a], b = soup.corners[soup.walls[v].b],
                   c = soup.corners[soup.walls[w].a], d = soup.corners[soup.walls[w].b];
        const auto sign = [](std::int64_t x) { return x > 0 ? 1 : x < 0 ? -1 : 0; };
        const auto within = [](auto p, auto q, auto x) {  // strictly inside segment pq, given collinear
          return (x[0] - p[0]) * (x[0] - q[0]) + (x[1] - p[1]) * (x[1] - q[1]) < 0;
        };
        const int abc = sign(turn(a, b, c)), abd = sign(turn(a, b, d)), cda = sign(turn(c, d, a)),
                  cdb = sign(turn(c, d, b));
        bool conflict = abc * abd < 0 && cda * cdb < 0;
        conflict |= (abc == 0 && within(a, b, c)) || (abd == 0 && within(a, b, d));
        conflict |= (cda == 0 && within(c, d, a)) || (cdb == 0 && within(c, d, b));
        conflict |= (a == c && b == d) || (a == d && b == c);
        if (conflict) expected.push_back({v, w});
      }
    const SectionLocator locator(plane, soup.points, soup.walls);
    CHECK(locator.conflicts() == expected);
  }
}

TEST_CASE("flat sections, whose walls are all at each level: strips of the other axis answer the same") {
  for (const LatticePlane& plane : planes())
    for (const bool along_v : {false, true}) {
      CAPTURE(along_v);
      // A zigzag over a straight side, and walls across it that conflict with all in their way.
      constexpr std::int64_t kLength = 300;
      Polygon zigzag;
      for (std::int64_t i = 0; i <= kLength; ++i) zigzag.corners.push_back({i, 4 + 4 * (i % 2)});
      zigzag.corners.push_back({kLength, 0});
      zigzag.corners.push_back({0, 0});
      if (along_v)
        for (auto& [u, v] : zigzag.corners) std::swap(u, v);
      zigzag.close(plane);
      const SectionLocator locator(plane, zigzag.points, zigzag.walls);
      for (std::int64_t i = -1; i <= kLength + 1; ++i)
        for (std::int64_t k = -1; k <= 9; ++k) {
          const std::array<std::int64_t, 2> p = along_v ? std::array{k, i} : std::array{i, k};
          CHECK(locator.locate(at(plane, p[0], p[1])) == brute_force(zigzag, p));
        }
      for (std::uint32_t w = 0; w < zigzag.walls.size(); ++w) CHECK(locator.inside_left(w) == along_v);
      CHECK(locator.conflicts().empty());
      const auto last = static_cast<std::uint32_t>(zigzag.points.size());
      const std::int64_t level = 6;
      for (const std::int64_t end : {std::int64_t{-1}, kLength + 1})
        zigzag.points.push_back(along_v ? at(plane, level, end) : at(plane, end, level));
      zigzag.walls.push_back({last, last + 1});
      CHECK(SectionLocator(plane, zigzag.points, zigzag.walls).conflicts().size() == kLength + 0U);
      CHECK(SectionLocator(plane, zigzag.points, zigzag.walls).near_touches(0.5).empty());
    }
}

TEST_CASE("rectangles with many points on each side: the same answers from the strips of both axes") {
  constexpr std::int64_t kLong = 4000, kShort = 300;
  for (const LatticePlane& plane : planes()) {
    Polygon sides;
    for (std::int64_t i = 0; i < kLong; ++i) sides.corners.push_back({i, 0});
    for (std::int64_t i = 0; i < kShort; ++i) sides.corners.push_back({kLong, i});
    for (std::int64_t i = kLong; i > 0; --i) sides.corners.push_back({i, kShort});
    for (std::int64_t i = kShort; i > 0; --i) sides.corners.push_back({0, i});
    sides.close(plane);
    const SectionLocator locator(plane, sides.points, sides.walls);
    for (std::int64_t u = -1; u <= kLong + 1; u += u < 3 || u > kLong - 3 ? 1 : 211)
      for (std::int64_t v = -1; v <= kShort + 1; v += v < 3 || v > kShort - 3 ? 1 : 37)
        CHECK(locator.locate(at(plane, u, v)) == brute_force(sides, {u, v}));
    for (std::uint32_t w = 0; w < sides.walls.size(); ++w) CHECK(locator.inside_left(w));
    CHECK(locator.conflicts().empty());
    const auto last = static_cast<std::uint32_t>(sides.points.size());
    sides.points.insert(sides.points.end(), {at(plane, 3, -1), at(plane, kLong + 1, 7), at(plane, 5, 0)});
    sides.walls.push_back({last, last + 1});  // across two sides
    sides.walls.push_back({last + 2, 9});     // along four walls
    SectionLocator::Pairs along, across;
    for (const auto& pair : SectionLocator(plane, sides.points, sides.walls).conflicts())
      (pair[1] == last + 1 ? along : across).push_back(pair);
    CHECK(along == SectionLocator::Pairs{{5, last + 1}, {6, last + 1}, {7, last + 1}, {8, last + 1}});
    REQUIRE(across.size() == 2);
    CHECK(across[0][0] < kLong);
    CHECK(across[1][0] == kLong + 6);
  }
}

TEST_CASE("a plane without contours has nothing inside") {
  const LatticePlane plane = make_axis_plane(2, 5);
  const SectionLocator locator(plane, {}, {});
  CHECK(locator.locate(at(plane, 1, 2)) == SectionLocator::Place::outside);
  CHECK(locator.conflicts().empty());
}
