#include "../../geom/triangle_meeting.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace crossloft;

namespace {

const Corners kBase{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{0, 4, 0}};

Corners spike(const Vec3& tip) { return {tip, Vec3{0.5, 1, 3}, Vec3{1.5, 1, 3}}; }

}  // namespace

TEST_CASE("a tip crosses one unit in the last place below a plane and only touches on it") {
  const double down = std::nextafter(0.0, -1.0);
  CHECK(meeting(kBase, spike({1, 1, 0})) == Meeting::none);
  CHECK(meeting(kBase, spike({1, 1, 0x1p-40})) == Meeting::none);
  CHECK(meeting(kBase, spike({1, 1, down})) == Meeting::crossing);
  CHECK(meeting(spike({1, 1, down}), kBase) == Meeting::crossing);
}

TEST_CASE("an edge crosses one unit beside a triangle's side and only touches on it") {
  const auto post = [](double x) { return Corners{Vec3{x, 0, -1}, Vec3{x, 0, 1}, Vec3{x, -5, 0}}; };
  CHECK(meeting(kBase, post(1)) == Meeting::none);
  const auto shifted = [](double y) { return Corners{Vec3{1, y, -1}, Vec3{1, y, 1}, Vec3{1, -5, 0}}; };
  // y > 0: the post's edge stands inside the base, so it and the base's side cross properly.
  CHECK(meeting(kBase, shifted(std::nextafter(0.0, 1.0))) == Meeting::crossing);
  CHECK(meeting(kBase, shifted(std::nextafter(0.0, -1.0))) == Meeting::none);
}

TEST_CASE("triangles that share a corner or side do not cross there, but beyond it they may") {
  CHECK(meeting(kBase, {kBase[0], Vec3{1, 1, 1}, Vec3{1, 1, -1}}) == Meeting::crossing);
  CHECK(meeting(kBase, {kBase[0], Vec3{-1, 1, 1}, Vec3{-1, 1, -1}}) == Meeting::none);
  CHECK(meeting(kBase, {kBase[0], kBase[1], Vec3{1, 1, 5}}) == Meeting::none);
  CHECK(meeting(kBase, {kBase[0], kBase[1], Vec3{1, -1, 0}}) == Meeting::none);
}

TEST_CASE("a triangle that leans on the other's plane with a corner or side does not pass through") {
  const Corners corner{Vec3{1, 1, 0}, Vec3{1, 1, 1}, Vec3{2, 1, 1}};
  const Corners side{Vec3{1, 1, 0}, Vec3{2, 1, 0}, Vec3{1, 1, 1}};
  const Corners through{Vec3{0.5, 1, 0}, Vec3{3, 1, 0}, Vec3{0.5, 1, -1}};
  for (const Corners& leaning : {corner, side}) {
    CHECK(meeting(kBase, leaning) == Meeting::none);
    CHECK(meeting(leaning, kBase) == Meeting::none);
    CHECK(meeting(through, leaning) == Meeting::none);
  }
  CHECK(meeting(kBase, through) == Meeting::none);
  CHECK(meeting(through, {Vec3{1, 0.5, 0}, Vec3{1, 1.5, -0.5}, Vec3{1, 1.5, 0.5}}) == Meeting::crossing);
}

TEST_CASE("points beside a triangle's plane, corners of it left out") {
  const double up = std::nextafter(0.0, 1.0);
  const auto is_beside = [](const Corners& t, const std::vector<Vec3>& points) {
    return beside(t, points, [&](std::size_t i) { return side_of(t, points[i]); });
  };
  CHECK(is_beside(kBase, {{1, 1, up}, {9, 9, 1}}));
  CHECK(is_beside(kBase, {kBase[0], {1, 1, -up}, kBase[2]}));
  CHECK_FALSE(is_beside(kBase, {{1, 1, up}, {9, 9, 0}}));
  CHECK_FALSE(is_beside(kBase, {{1, 1, up}, {9, 9, -up}}));
  CHECK_FALSE(is_beside(kBase, {kBase[0], kBase[1]}));
  CHECK_FALSE(is_beside({kBase[0], kBase[0], kBase[1]}, {{1, 1, 1}}));
}

TEST_CASE("coplanar triangles in any plane") {
  // Seen along an axis that the plane is parallel to they would be flat.
  for (const Vec3& u : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{1, 1, 0}, Vec3{3, -1, 2}})
    for (const Vec3& v : {Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{1, 0, 0}, Vec3{0, 1, -1}, Vec3{1, 4, 1}}) {
      if (cross(u, v) == Vec3{}) continue;
      const auto at = [&](double a, double b) { return a * u + b * v; };
      const Corners base{at(0, 0), at(4, 0), at(0, 4)};
      CHECK_FALSE(collinear(base));
      CHECK(collinear({at(0, 0), at(1, 1), at(3, 3)}));
      CHECK(contains(base, at(2, 2)));
      CHECK_FALSE(contains(base, at(2, 3)));
      CHECK(meeting(base, {at(1, 1), at(9, 1), at(1, 9)}) == Meeting::overlap);
      CHECK(meeting(base, {at(4, 0), at(4, 4), at(0, 4)}) == Meeting::none);
      CHECK(touch(base, {at(2, 2), at(4, 4), at(2, 4)}, 0));
      CHECK_FALSE(touch(base, {at(3, 3), at(4, 4), at(3, 4)}, 0));
    }
}

TEST_CASE("coplanar triangles overlap or touch") {
  CHECK(meeting(kBase, {kBase[0], kBase[1], Vec3{1, 1, 0}}) == Meeting::overlap);
  CHECK(meeting(kBase, kBase) == Meeting::overlap);
  CHECK(meeting(kBase, {kBase[1], kBase[0], kBase[2]}) == Meeting::overlap);
  CHECK(meeting(kBase, {Vec3{4, 0, 0}, Vec3{4, 4, 0}, Vec3{0, 4, 0}}) == Meeting::none);
  CHECK(meeting(kBase, {Vec3{-1, 1, 0}, Vec3{5, 1, 0}, Vec3{5, 1.5, 0}}) == Meeting::overlap);
  CHECK(meeting(kBase, {Vec3{1, 1, 0}, Vec3{1, 1, 0}, Vec3{2, 1, 0}}) == Meeting::none);
}

TEST_CASE("degenerate triangles pierce but are not pierced") {
  const Corners needle{Vec3{1, 1, -1}, Vec3{1, 1, 1}, Vec3{1, 1, 2}};
  CHECK(collinear(needle));
  CHECK(meeting(needle, kBase) == Meeting::crossing);
  CHECK(meeting(needle, {Vec3{0, 1, 0}, Vec3{2, 1, 0}, Vec3{3, 1, 0}}) == Meeting::none);
}

TEST_CASE("a triangle contains what is exactly in its plane and within its closed sides") {
  for (const Vec3& p : {kBase[0], kBase[2], Vec3{2, 2, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}})
    CHECK(contains(kBase, p));
  for (const Vec3& p :
       {Vec3{1, 1, 0x1p-1074}, Vec3{2, std::nextafter(2.0, 3.0), 0}, Vec3{-0x1p-1074, 1, 0}, Vec3{9, 0, 0}})
    CHECK_FALSE(contains(kBase, p));
  const Corners flat{Vec3{0, 0, 0}, Vec3{1, 1, 1}, Vec3{2, 2, 2}};
  CHECK(contains(flat, flat[1]));
  CHECK_FALSE(contains(flat, {0.5, 0.5, 0.5}));
}

TEST_CASE("touching is anything in common beside shared corners") {
  const double up = std::nextafter(0.0, 1.0);
  CHECK(touch(kBase, spike({1, 1, 0}), 0));
  CHECK_FALSE(touch(kBase, spike({1, 1, up}), 0));
  CHECK(touch(kBase, spike({2, 2, 0}), 0));  // on the border
  CHECK_FALSE(touch(kBase, spike({2, std::nextafter(2.0, 3.0), 0}), 0));
  CHECK(touch(kBase, {kBase[0], Vec3{-1, 0, 2}, Vec3{-1, 1, 2}}, 0));        // equal corners, not shared
  CHECK_FALSE(touch(kBase, {kBase[0], Vec3{-1, 0, 2}, Vec3{-1, 1, 2}}, 1));  // shared
  CHECK(touch(kBase, {kBase[0], Vec3{1, 1, 1}, Vec3{1, 1, -1}}, 1));
  CHECK(touch(kBase, {kBase[0], kBase[1], Vec3{0, 1, 1}}, 1));       // a side of both
  CHECK(touch(kBase, {kBase[0], Vec3{1, 1, 0}, Vec3{1, 1, 3}}, 1));  // an edge of one lies in the other
  CHECK_FALSE(touch(kBase, {kBase[0], Vec3{1, up, 1}, Vec3{1, -1, 1}}, 1));
}

TEST_CASE("touching in one plane") {
  CHECK(touch(kBase, {Vec3{1, 1, 0}, Vec3{2, 1, 0}, Vec3{1, 2, 0}}, 0));
  CHECK(touch(kBase, {Vec3{4, 0, 0}, Vec3{5, 0, 0}, Vec3{5, 1, 0}}, 0));
  CHECK_FALSE(touch(kBase, {Vec3{5, 0, 0}, Vec3{6, 0, 0}, Vec3{5, 1, 0}}, 0));
  CHECK_FALSE(touch(kBase, {kBase[0], Vec3{-1, 0, 0}, Vec3{0, -1, 0}}, 1));
  CHECK(touch(kBase, {kBase[0], Vec3{9, 0, 0}, Vec3{1, -1, 0}}, 1));
  CHECK(touch(kBase, {kBase[0], Vec3{9, 1, 0}, Vec3{1, -1, 0}}, 1));
  CHECK(touch(kBase, {kBase[0], kBase[1], Vec3{1, 1, 0}}, 2));
  CHECK_FALSE(touch(kBase, {kBase[0], kBase[1], Vec3{1, -1, 0}}, 2));
  CHECK_FALSE(touch(kBase, {kBase[0], kBase[1], Vec3{1, 1, 1}}, 2));
}

TEST_CASE("triangles cross where their boundaries do too, from edge to edge") {
  // Both meet the line of both planes from (1, 0, 0) to (3, 0, 0).
  const Corners flat{Vec3{1, -1, 0}, Vec3{1, 1, 0}, Vec3{5, 0, 0}};
  const Corners upright{Vec3{1, 0, -1}, Vec3{1, 0, 1}, Vec3{5, 0, 0}};
  CHECK(meeting(flat, upright) == Meeting::crossing);
  const Corners corners_on_edges{Vec3{1, 0, 0}, Vec3{3, 0, 1}, Vec3{3, 0, -1}};
  CHECK(meeting({Vec3{1, -1, 0}, Vec3{1, 1, 0}, Vec3{3, 0, 0}}, corners_on_edges) == Meeting::crossing);
  CHECK(meeting({Vec3{1, 0, 0}, Vec3{3, 1, 0}, Vec3{3, -1, 0}}, corners_on_edges) == Meeting::crossing);
  CHECK(meeting({Vec3{3, 0, 0}, Vec3{5, 1, 0}, Vec3{5, -1, 0}}, corners_on_edges) == Meeting::none);
  const Corners from_corner{Vec3{1, 0, 0}, Vec3{9, 1, 1}, Vec3{9, 1, -1}};  // which is inside the other
  CHECK(meeting({Vec3{0, -1, 0}, Vec3{0, 1, 0}, Vec3{4, 0, 0}}, from_corner) == Meeting::crossing);
}

namespace {

/// Whether a plane with this normal, not 0, has the triangles on its two closed sides. Whole numbers.
bool separates(const Vec3& normal, const Corners& a, const Corners& b) {
  if (normal == Vec3{}) return false;
  const auto [a_low, a_high] = std::minmax({dot(normal, a[0]), dot(normal, a[1]), dot(normal, a[2])});
  const auto [b_low, b_high] = std::minmax({dot(normal, b[0]), dot(normal, b[1]), dot(normal, b[2])});
  return a_high <= b_low || b_high <= a_low;
}

/// Of triangles in planes that are not parallel the differences a - b fill a polytope, whose facets have
/// these normals. Interiors have common points iff 0 is inside of it.
bool interiors_meet(const Corners& a, const Corners& b) {
  const Vec3 a_normal = cross(a[1] - a[0], a[2] - a[0]), b_normal = cross(b[1] - b[0], b[2] - b[0]);
  if (cross(a_normal, b_normal) == Vec3{}) return false;
  if (separates(a_normal, a, b) || separates(b_normal, a, b)) return false;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (separates(cross(a[(i + 1) % 3] - a[i], b[(k + 1) % 3] - b[k]), a, b)) return false;
  return true;
}

bool edge_pierces(const Corners& a, const Corners& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (piercing(a[k], a[(k + 1) % 3], b) == Piercing::pierces) return true;
  return false;
}

}  // namespace

// Corners in the other's plane, shared corners and coplanar triangles are frequent on small grids.
TEST_CASE("random triangles cross iff no plane separates their interiors") {
  std::mt19937 random(5);
  for (int n = 0; n < 200000; ++n) {
    CAPTURE(n);
    const unsigned size = n % 2 == 0 ? 5 : 9;
    const auto draw = [&] { return static_cast<double>(random() % size); };
    Corners a, b;
    for (Corners* t : {&a, &b})
      for (Vec3& p : *t) p = {draw(), draw(), draw()};
    if (n % 3 == 0) b[1] = a[2];
    const bool degenerate = collinear(a) || collinear(b);
    const bool crossing = degenerate ? edge_pierces(a, b) || edge_pierces(b, a) : interiors_meet(a, b);
    const Meeting found = meeting(a, b);
    REQUIRE((found == Meeting::crossing) == crossing);
    const Sides a_side{side_of(b, a[0]), side_of(b, a[1]), side_of(b, a[2])};
    const Sides b_side{side_of(a, b[0]), side_of(a, b[1]), side_of(a, b[2])};
    REQUIRE(meeting(a, a_side, b, b_side) == found);
  }
}
