// Points in sections, against all triangles of the face and all edges of the contour.
#include "prune/section_rows.h"

#include <doctest/doctest.h>

#include <cmath>

#include "cells.h"

namespace {

using namespace crossloft;
using namespace crossloft::test;

using Corners = std::array<Vec3, 3>;

/// Internal triangles of each face.
std::vector<std::vector<Corners>> triangles(const PlacedCell& cell) {
  std::vector<std::vector<Corners>> list(cell.shape.faces.size());
  const CellComplex& c = cell.complex;
  for (std::uint32_t t = 0; t < c.mesh.size(); ++t)
    for (unsigned i = 0; i < 4; ++i) {
      if (c.facets[t][i] != FacetKind::internal) continue;
      Corners at;
      std::vector<std::uint64_t> common(c.words, ~std::uint64_t{0});
      for (unsigned k = 0; k < 3; ++k) {
        const std::uint32_t v = c.mesh.vertices[t][kFacetSlots[i][k]];
        at[k] = cell.shape.points[v];
        for (std::uint32_t w = 0; w < c.words; ++w) common[w] &= c.faces_of(v)[w];
      }
      for (std::uint32_t f = 0; f < 64 * c.words; ++f)
        if ((common[f / 64] >> (f % 64) & 1U) != 0) list[f].push_back(at);
    }
  return list;
}

/// 1 inside, -1 outside, 0 too near to a side to tell by rounded numbers.
int place(const Corners& t, Vec3 normal, Vec3 p) {
  int inside = 0, sides[3];
  for (unsigned k = 0; k < 3; ++k) {
    const Vec3 along = t[(k + 1) % 3] - t[k];
    const double side = dot(cross(along, p - t[k]), normal) / norm(along);
    sides[k] = side > 1e-6 ? 1 : side < -1e-6 ? -1 : 0;
    inside += sides[k];
  }
  if (inside == 3 || inside == -3) return 1;
  const bool positive = sides[0] > 0 || sides[1] > 0 || sides[2] > 0;
  const bool negative = sides[0] < 0 || sides[1] < 0 || sides[2] < 0;
  return positive && negative ? -1 : 0;
}

struct Answers {
  int inside = 0, outside = 0;
};

void check_faces(const PlacedCell& cell, std::mt19937& random, Answers& answers) {
  const std::vector<SectionRows> rows = section_rows(cell.complex, Ground(cell.complex), cell.shape);
  const auto all = triangles(cell);
  REQUIRE(rows.size() == cell.shape.faces.size());
  const auto& points = cell.shape.points;
  for (std::size_t f = 0; f < rows.size(); ++f) {
    CHECK(rows[f].empty() == all[f].empty());
    const FacePlane& plane = cell.shape.faces[f];
    for (int i = 0; i < 20; ++i) {
      // The foot of a random mean of three points.
      Vec3 p = 1.0 / 3 *
               (points[random() % points.size()] + points[random() % points.size()] +
                points[random() % points.size()]);
      p = p + 0.01 * Vec3{static_cast<double>(random() % 100), static_cast<double>(random() % 100), 0};
      p = p - plane.height(p) * plane.normal;
      bool inside = false, near = false;
      for (const Corners& t : all[f]) {
        const int at = place(t, plane.normal, p);
        inside |= at == 1;
        near |= at == 0;
      }
      if (near) continue;
      CAPTURE(f);
      CHECK(rows[f].contains(p) == inside);
      ++(inside ? answers.inside : answers.outside);
    }
  }
}

}  // namespace

TEST_CASE("random faces, also oblique and beyond the 64th: what the triangles of the section say") {
  Answers answers;
  for (std::uint32_t seed = 0; seed < 120; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    PlacedCell cell = placed_cell(seed);
    check_faces(cell, random, answers);
    cell.shape = turned(cell.shape, random);
    check_faces(cell, random, answers);
    check_faces(with_many_faces(cell), random, answers);
  }
  MESSAGE("inside " << answers.inside << ", outside " << answers.outside);
  CHECK(answers.inside > 2000);
  CHECK(answers.outside > 2000);
}

TEST_CASE("long contours, each axis dropped: even-odd along the other way") {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
    // Two star-shaped contours with random radii, one perhaps within the other, perhaps across it.
    std::vector<SectionRows::Segment> contour;
    for (int ring = 0; ring < 2; ++ring) {
      const std::uint32_t n = 3 + random() % 200;
      const double x = uniform(), y = uniform();
      std::vector<std::array<double, 2>> at;
      for (std::uint32_t i = 0; i < n; ++i) {
        const double angle = 2 * 3.141592653589793 * i / n, radius = 0.3 + uniform();
        at.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
      }
      for (std::uint32_t i = 0; i < n; ++i) {
        const auto &a = at[i], &b = at[(i + 1) % n];
        contour.push_back(i % 2 == 0 ? SectionRows::Segment{a[0], a[1], b[0], b[1]}
                                     : SectionRows::Segment{b[0], b[1], a[0], a[1]});
      }
    }
    for (int axis = 0; axis < 3; ++axis) {
      const SectionRows rows(axis, contour);
      int inside_count = 0;
      for (int i = 0; i < 200; ++i) {
        const double u = 4 * uniform() - 1.5, v = 4 * uniform() - 1.5;
        bool inside = false;  // along u = const, upwards
        for (const auto& s : contour)
          if ((s[0] <= u) != (s[2] <= u)) inside ^= v < s[1] + (u - s[0]) / (s[2] - s[0]) * (s[3] - s[1]);
        const double away = 7;
        CHECK(rows.contains(axis == 0   ? Vec3{away, u, v}
                            : axis == 1 ? Vec3{v, away, u}
                                        : Vec3{u, v, away}) == inside);
        inside_count += inside ? 1 : 0;
      }
      CHECK(inside_count > 5);
      CHECK(inside_count < 195);
    }
  }
}

TEST_CASE("flat contours, whose pieces all cross each row: even-odd along the flat way, within rounding") {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
    // A zigzag along u, back along its lower side; every other time along v.
    const bool along_v = seed % 2 == 1;
    const std::uint32_t n = seed < 10 ? 1000 : 60;
    const double flat = 1e-5;
    std::vector<std::array<double, 2>> at{{1, 0}, {0, 0}};
    for (std::uint32_t i = 0; i <= n; ++i)
      at.push_back({static_cast<double>(i) / n, flat * (0.2 + 0.8 * uniform() * (i % 2))});
    std::vector<SectionRows::Segment> contour;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const auto &a = at[i], &b = at[(i + 1) % at.size()];
      contour.push_back(along_v ? SectionRows::Segment{a[1], a[0], b[1], b[0]}
                                : SectionRows::Segment{a[0], a[1], b[0], b[1]});
    }
    const SectionRows rows(2, contour);
    int inside_count = 0;
    for (int i = 0; i < 500; ++i) {
      const double x = 1.2 * uniform() - 0.1, y = flat * (1.4 * uniform() - 0.2);
      bool inside = false, near = false;  // along x = const, upwards
      for (std::size_t k = 0; k < at.size(); ++k) {
        const auto &a = at[k], &b = at[(k + 1) % at.size()];
        if ((a[0] <= x) == (b[0] <= x)) continue;
        const double height = a[1] + (x - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
        inside ^= y < height;
        near |= std::fabs(y - height) < 1e-9 * flat;
      }
      if (near) continue;
      CHECK((along_v ? rows.contains(y, x) : rows.contains(x, y)) == inside);
      inside_count += inside ? 1 : 0;
    }
    CHECK(inside_count > 50);
    CHECK(inside_count < 450);
  }
}

TEST_CASE("no section has no inside") {
  CHECK(SectionRows(2, {}).empty());
  CHECK_FALSE(SectionRows(2, {}).contains({0, 0, 0}));
  CHECK_FALSE(SectionRows(0, std::vector{SectionRows::Segment{1, 5, 2, 5}}).contains({0, 1.5, 5}));  // flat
}
