#include "../../geom/tetrahedron_meeting.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

using namespace crossloft;

namespace {

using Ints = std::array<LatticeVector, 4>;

LatticeTet tet(const Ints& c) {
  return {make_point(c[0]), make_point(c[1]), make_point(c[2]), make_point(c[3])};
}

const Ints kCorner{{{0, 0, 0}, {12, 0, 0}, {0, 12, 0}, {0, 0, 12}}};

Ints moved(Ints t, const LatticeVector& by) {
  for (LatticeVector& c : t)
    for (std::size_t k = 0; k < 3; ++k) c[k] += by[k];
  return t;
}

Vec3 real(const LatticePoint& p) { return {p.x, p.y, p.z}; }

/// The least height of p over the four facets, negative outside; in units of volume.
double depth(const LatticeTet& t, const Vec3& p) {
  std::array<Vec3, 4> c{real(t[0]), real(t[1]), real(t[2]), real(t[3])};
  const auto volume = [&] { return dot(c[1] - c[0], cross(c[2] - c[0], c[3] - c[0])); };
  const double whole = volume();
  double least = 1e300;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 kept = c[i];
    c[i] = p;
    least = std::min(least, whole < 0 ? -volume() : volume());
    c[i] = kept;
  }
  return least;
}

/// Corners of the intersection that are a's corners or on its edges, with rounding.
void add_corners(const LatticeTet& a, const LatticeTet& b, std::vector<Vec3>& found) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t f = 0; f < 4; ++f) {
        const Vec3 p = real(a[i]), q = real(a[j]), o = real(b[(f + 1) % 4]);
        const Vec3 n = cross(real(b[(f + 2) % 4]) - o, real(b[(f + 3) % 4]) - o);
        const double u = dot(n, p - o), v = dot(n, q - o);
        const Vec3 at = u == v || i == j ? p : p + u / (u - v) * (q - p);
        if (depth(a, at) > -1e-6 && depth(b, at) > -1e-6) found.push_back(at);
      }
}

/// The intersection has an interior iff the mean of its corners is in it.
bool share_interior(const LatticeTet& a, const LatticeTet& b) {
  std::vector<Vec3> corners;
  add_corners(a, b, corners);
  add_corners(b, a, corners);
  Vec3 mean{0, 0, 0};
  for (const Vec3& c : corners) mean = mean + 1.0 / static_cast<double>(corners.size()) * c;
  return !corners.empty() && depth(a, mean) > 1e-4 && depth(b, mean) > 1e-4;
}

}  // namespace

TEST_CASE("a unit decides between touching and overlapping") {
  const LatticeTet a = tet(kCorner);
  CHECK(overlap(a, a));
  CHECK_FALSE(overlap(a, tet(moved(kCorner, {12, 0, 0}))));
  CHECK(overlap(a, tet(moved(kCorner, {11, 0, 0}))));
  // Through a facet from outside: a tip on it, and one unit in.
  CHECK_FALSE(overlap(a, tet({{{4, 4, 4}, {20, 20, 10}, {20, 10, 20}, {10, 20, 20}}})));
  CHECK(overlap(a, tet({{{4, 4, 3}, {20, 20, 10}, {20, 10, 20}, {10, 20, 20}}})));
  // A common facet, a common edge.
  CHECK_FALSE(overlap(a, tet({{{12, 0, 0}, {0, 12, 0}, {0, 0, 12}, {12, 12, 12}}})));
  CHECK_FALSE(overlap(a, tet({{{0, 0, 0}, {12, 0, 0}, {0, -9, 3}, {0, -9, -3}}})));
}

TEST_CASE("edges that pass each other crosswise are apart by no facet's plane") {
  const Ints low{{{-9, 0, 0}, {9, 0, 0}, {0, -2, -9}, {0, 2, -9}}};
  for (const std::int64_t gap : {-1, 0, 1}) {
    const Ints high{{{0, -9, gap}, {0, 9, gap}, {-2, 0, 9 + gap}, {2, 0, 9 + gap}}};
    CHECK(overlap(tet(low), tet(high)) == (gap < 0));
    CHECK(overlap(tet(high), tet(low)) == (gap < 0));
  }
}

TEST_CASE("random small tetrahedra: who shares inner points overlaps, and nobody else") {
  std::mt19937_64 random(7);
  MESSAGE("seed 7");
  int overlapping = 0, apart = 0;
  for (int run = 0; run < 5000; ++run) {
    const auto draw = [&] {
      Ints t;
      for (LatticeVector& c : t)
        for (std::int64_t& x : c) x = static_cast<std::int64_t>(random() % 6);
      return t;
    };
    const LatticeTet a = tet(draw()), b = tet(draw());
    if (orient3d(a[0], a[1], a[2], a[3]) == 0 || orient3d(b[0], b[1], b[2], b[3]) == 0) continue;
    CAPTURE(run);
    const bool found = overlap(a, b);
    CHECK(found == overlap(b, a));
    CHECK(found == share_interior(a, b));
    ++(found ? overlapping : apart);
  }
  CHECK(apart > 1000);
  CHECK(overlapping > 1000);
}
