#include "triangle_meeting.h"

#include <algorithm>

#include "double_filters.h"
#include "predicates.h"

namespace crossloft {
namespace {

using Signs = Sides;

constexpr int next(int k) { return k == 2 ? 0 : k + 1; }

/// As merged ones have (reconstruct/merge_places.h): no plane, no inside, and exact arithmetic would find that
/// out the long way.
bool has_equal(const Corners& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// Side of the triangle's plane; equal corners are the frequent zero and need no arithmetic. The filter is
/// here so that what it computes of the triangle is shared by three questions.
inline int side(const Corners& t, const Vec3& p) {
  if (p == t[0] || p == t[1] || p == t[2]) return 0;
  const int sign = orient3d_filter(t[0], t[1], t[2], p);
  return sign != 0 || has_equal(t) ? sign : orient3d(t[0], t[1], t[2], p);
}

/// On which side of each edge of t the line pq passes; the same three signs mean through the interior.
Signs line_sides(const Vec3& p, const Vec3& q, const Corners& t) {
  Signs s{};
  for (int k = 0; k < 3; ++k) {
    const Vec3 &a = t[k], &b = t[next(k)];
    s[k] = p == a || p == b || q == a || q == b ? 0 : orient3d(p, q, a, b);
  }
  return s;
}

bool all_equal(const Signs& s, int sign) { return s[0] == sign && s[1] == sign && s[2] == sign; }
bool one_sided(const Signs& s) { return s[0] != 0 && all_equal(s, s[0]); }
/// On one closed side of a plane, and not all in it.
bool leans(const Signs& s) {
  const auto [low, high] = std::minmax({s[0], s[1], s[2]});
  return low != high && low * high == 0;
}

bool through_interior(const Vec3& p, const Vec3& q, const Corners& t) {
  return one_sided(line_sides(p, q, t));
}

/// An edge of `a`, whose corners have the sides `s` of t's plane, passes through t's interior.
bool edge_pierces(const Corners& a, const Signs& s, const Corners& t) {
  for (int k = 0; k < 3; ++k)
    if (s[k] * s[next(k)] < 0 && through_interior(a[k], a[next(k)], t)) return true;
  return false;
}

/// Its corners from the given one on.
struct Turned {
  const Vec3 &first, &second, &third;
  Turned(const Corners& t, int k) : first(t[k]), second(t[next(k)]), third(t[next(next(k))]) {}
};

/// The only one of its side, and the others are on the other side or in the plane. REQUIRES: corners on both
/// sides.
int lone(const Signs& s) {
  const int above = (s[0] > 0) + (s[1] > 0) + (s[2] > 0);
  const int sign = above == 1 ? 1 : -1;
  return s[0] == sign ? 0 : s[1] == sign ? 1 : 2;
}

/// Triangles of which each has corners strictly on both sides of the other's plane. What the interior of each
/// has in common with the line l = Na x Nb of both planes is an open interval, from one edge at its lone
/// corner to the other edge there; the question is whether these two have common points.
///
/// With the lone corners p (on the side i of b's plane) and q (on the side k of a's), edges e = a' - p and f
/// = b' - q that meet l in P and Q: orient3d(p, a', q, b') = det(e, q - p, f) = (Q - P).(f x e), up to
/// positive factors, and l.(f x e) = (Na.f)(Nb.e), which has the sign i k: that tells the order of P and Q
/// along l. The edge to the second corner is the one that meets l later iff i > 0; for b, iff k < 0, as for
/// it the line is -l. All of that holds too where a' or b' is on l. (Source: Guigue and Devillers, Fast and
/// robust triangle-triangle overlap test, 2003, whose two questions these are.)
bool intervals_meet(const Corners& a, const Signs& a_side, const Corners& b, const Signs& b_side) {
  const int i = lone(a_side), k = lone(b_side);
  const Turned p(a, i), q(b, k);
  const int turn = a_side[i] * b_side[k];
  const auto order = [&](const Vec3& on_a, const Vec3& on_b) {
    return turn * orient3d(p.first, on_a, q.first, on_b);  // +1 if that on b is later
  };
  const bool a_up = a_side[i] > 0, b_up = b_side[k] < 0;
  const Vec3 &a_low = a_up ? p.third : p.second, &a_high = a_up ? p.second : p.third;
  const Vec3 &b_low = b_up ? q.third : q.second, &b_high = b_up ? q.second : q.third;
  return order(a_high, b_low) < 0 && order(a_low, b_high) > 0;
}

/// Likewise of triangles that share a corner, the only one in the other's plane: the opposite edges meet l in
/// X and Y beside the corner, and the question is whether on the same side of it. X, of the edge bc, is where
/// a is iff it passes the edge from the corner as a line through a's inside does.
bool opposite_edges_meet(const Turned& a, const Turned& b, int side_of_second) {
  return orient3d(b.second, b.third, a.first, a.second) == -side_of_second;
}

/// The only zero; -1 if there is none or several.
int only_zero(const Signs& s) {
  const int zeros = (s[0] == 0) + (s[1] == 0) + (s[2] == 0);
  return zeros != 1 ? -1 : s[0] == 0 ? 0 : s[1] == 0 ? 1 : 2;
}

/// REQUIRES: each has corners on both sides, or is degenerate as the other sees it: all signs are 0.
bool cross_each_other(const Corners& a, const Signs& a_side, const Corners& b, const Signs& b_side) {
  if (all_equal(a_side, 0)) return edge_pierces(b, b_side, a);
  if (all_equal(b_side, 0)) return edge_pierces(a, a_side, b);
  const int i = only_zero(a_side), k = only_zero(b_side);
  if (i >= 0 && k >= 0 && a[i] == b[k]) return opposite_edges_meet({a, i}, {b, k}, b_side[next(k)]);
  return intervals_meet(a, a_side, b, b_side);
}

/// A plane seen along an axis that is not parallel to it: turns of its points need two coordinates only,
/// which is a fraction of the work of three where points are in one plane and no filter can tell.
struct PlaneView {
  int axis = 0;
  Vec2 seen(const Vec3& p) const {
    return axis == 0 ? Vec2{p.y, p.z} : axis == 1 ? Vec2{p.z, p.x} : Vec2{p.x, p.y};
  }
  int turn(const Vec3& p, const Vec3& q, const Vec3& r) const { return orient2d(seen(p), seen(q), seen(r)); }
};

/// A view of the triangle's plane; false if the corners are collinear, as they are if they look so along all
/// axes.
bool find_view(const Corners& t, PlaneView& view) {
  if (has_equal(t)) return false;
  for (view.axis = 0; view.axis < 3; ++view.axis)
    if (view.turn(t[0], t[1], t[2]) != 0) return true;
  return false;
}

/// Some edge of a, counter-clockwise by `turn`, has all of b on its outer side or on itself.
bool edge_separates(const PlaneView& view, const Corners& a, const Corners& b, int turn) {
  for (int k = 0; k < 3; ++k) {
    const auto inside = [&](const Vec3& p) { return view.turn(a[k], a[next(k)], p) * turn > 0; };
    if (!inside(b[0]) && !inside(b[1]) && !inside(b[2])) return true;
  }
  return false;
}

/// Open convex polygons are disjoint iff an edge of one separates them.
bool coplanar_overlap(const Corners& a, const Corners& b) {
  PlaneView view;
  if (!find_view(a, view)) return false;
  const int turn_a = view.turn(a[0], a[1], a[2]), turn_b = view.turn(b[0], b[1], b[2]);
  return turn_b != 0 && !edge_separates(view, a, b, turn_a) && !edge_separates(view, b, a, turn_b);
}

/// Some edge of a has all of b strictly on its outer side. REQUIRES: both turn counter-clockwise.
bool strictly_separated_by_edge(const PlaneView& view, const Corners& a, const Corners& b) {
  for (int k = 0; k < 3; ++k)
    if (view.turn(a[k], a[next(k)], b[0]) < 0 && view.turn(a[k], a[next(k)], b[1]) < 0 &&
        view.turn(a[k], a[next(k)], b[2]) < 0)
      return true;
  return false;
}

/// The direction from the first corner to p is in the closed angle there. REQUIRES: counter-clockwise.
bool in_angle(const PlaneView& view, const Corners& t, const Vec3& p) {
  return view.turn(t[0], t[1], p) >= 0 && view.turn(t[0], p, t[2]) >= 0;
}

bool angles_meet(const PlaneView& view, const Corners& a, const Corners& b) {
  return in_angle(view, a, b[1]) || in_angle(view, a, b[2]) || in_angle(view, b, a[1]) ||
         in_angle(view, b, a[2]);
}

bool coplanar_touch(Corners a, Corners b, int shared) {
  PlaneView view;
  if (!find_view(a, view)) return true;
  const int turn_a = view.turn(a[0], a[1], a[2]), turn_b = view.turn(b[0], b[1], b[2]);
  if (turn_b == 0) return true;
  if (shared == 2) return turn_a == turn_b;
  if (turn_a < 0) std::swap(a[1], a[2]);
  if (turn_b < 0) std::swap(b[1], b[2]);
  if (shared == 1) return angles_meet(view, a, b);
  return !strictly_separated_by_edge(view, a, b) && !strictly_separated_by_edge(view, b, a);
}

/// Edges of `a` that are not in the other's plane. With a shared corner the opposite edge alone: what the
/// triangles have in common is a segment that starts there and ends at the opposite edge of one of them.
bool edge_meets(const Corners& a, const Signs& a_side, const Corners& b, int shared) {
  for (int k = 0; k < 3; ++k) {
    if (shared == 1 && k != 1) continue;
    const bool within = a_side[k] == 0 && a_side[next(k)] == 0;
    if (!within && piercing(a[k], a[next(k)], b) != Piercing::misses) return true;
  }
  return false;
}

}  // namespace

int side_of(const Corners& t, const Vec3& p) { return side(t, p); }

// Leaning on the other's plane a triangle has no inner point in it, so that nothing passes through.
bool may_meet(const Sides& sides) { return !one_sided(sides) && !leans(sides); }

Meeting meeting(const Corners& a, const Sides& a_side, const Corners& b, const Sides& b_side) {
  if (!may_meet(b_side)) return Meeting::none;
  if (all_equal(b_side, 0) && coplanar_overlap(a, b)) return Meeting::overlap;
  return may_meet(a_side) && cross_each_other(a, a_side, b, b_side) ? Meeting::crossing : Meeting::none;
}

Meeting meeting(const Corners& a, const Corners& b) {
  const Signs b_side{side(a, b[0]), side(a, b[1]), side(a, b[2])};
  if (!may_meet(b_side)) return Meeting::none;
  if (all_equal(b_side, 0) && coplanar_overlap(a, b)) return Meeting::overlap;
  const Signs a_side{side(b, a[0]), side(b, a[1]), side(b, a[2])};
  if (!may_meet(a_side)) return Meeting::none;
  return cross_each_other(a, a_side, b, b_side) ? Meeting::crossing : Meeting::none;
}

bool touch(const Corners& a, const Corners& b, int shared) {
  const Signs b_side{side(a, b[0]), side(a, b[1]), side(a, b[2])};
  if (one_sided(b_side)) return false;
  if (all_equal(b_side, 0)) return coplanar_touch(a, b, shared);
  if (shared == 2) return false;
  const Signs a_side{side(b, a[0]), side(b, a[1]), side(b, a[2])};
  return edge_meets(a, a_side, b, shared) || edge_meets(b, b_side, a, shared);
}

Piercing piercing(const Vec3& p, const Vec3& q, const Corners& t) {
  const int product = side(t, p) * side(t, q);
  if (product > 0) return Piercing::misses;
  const Signs s = line_sides(p, q, t);
  const auto [low, high] = std::minmax({s[0], s[1], s[2]});
  if (low < 0 && high > 0) return Piercing::misses;
  return product < 0 && low == high ? Piercing::pierces : Piercing::touches;
}

bool contains(const Corners& t, const Vec3& p) {
  if (p == t[0] || p == t[1] || p == t[2]) return true;
  PlaneView view;
  if (side(t, p) != 0 || !find_view(t, view)) return false;
  const int turn = view.turn(t[0], t[1], t[2]);
  for (int k = 0; k < 3; ++k)
    if (view.turn(t[k], t[next(k)], p) * turn < 0) return false;
  return true;
}

bool collinear(const Corners& t) {
  PlaneView view;
  return !find_view(t, view);
}

}  // namespace crossloft
