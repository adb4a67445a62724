// Confidences against their definition, written down with distances to triangles.
#include "prune/confidence.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "brute_solid.h"
#include "cells.h"

namespace {

using namespace crossloft;
using namespace crossloft::test;

double distance_to_segment(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 along = b - a;
  const double t = dot(p - a, along) / dot(along, along);
  return t < 0 ? norm(p - a) : t > 1 ? norm(p - b) : norm(p - a - t * along);
}

/// The section of each face as triangles of points.
class SlowMeter {
 public:
  explicit SlowMeter(const PlacedCell& cell) : cell_(cell), sections_(cell.shape.faces.size()) {
    const CellComplex& c = cell.complex;
    for (std::uint32_t t = 0; t < c.mesh.size(); ++t)
      for (unsigned i = 0; i < 4; ++i) {
        if (c.facets[t][i] != FacetKind::internal) continue;
        std::array<std::uint32_t, 3> v;
        for (unsigned k = 0; k < 3; ++k) v[k] = c.mesh.vertices[t][kFacetSlots[i][k]];
        for (std::uint32_t f = 0; f < sections_.size(); ++f)
          if (on_face(v[0], f) && on_face(v[1], f) && on_face(v[2], f)) sections_[f].push_back(v);
      }
  }

  /// Not rounded. `near`: a foot is too close to a contour to tell.
  double measure(std::uint32_t t, bool& near) const {
    const auto& v = cell_.complex.mesh.vertices[t];
    Vec3 centroid;
    for (const std::uint32_t x : v) centroid = centroid + 0.25 * point(x);
    double mean = 0.4 * at(centroid, t, near);
    for (const std::uint32_t x : v) mean += 0.15 * at(0.5 * (centroid + point(x)), t, near);
    return mean;
  }

 private:
  Vec3 point(std::uint32_t v) const { return cell_.shape.points[v]; }
  bool on_face(std::uint32_t v, std::uint32_t f) const {
    return f < 64 && (cell_.complex.face_masks[v] >> f & 1U) != 0;
  }

  bool is_inside(std::uint32_t f, Vec3 p, bool& near) const {
    for (const auto& v : sections_[f]) {
      double signs[3];
      for (unsigned k = 0; k < 3; ++k) {
        const Vec3 a = point(v[k]), b = point(v[(k + 1) % 3]);
        near |= distance_to_segment(p, a, b) < 1e-6;
        signs[k] = dot(cross(b - a, p - a), cell_.shape.faces[f].normal);
      }
      if ((signs[0] > 0) == (signs[1] > 0) && (signs[1] > 0) == (signs[2] > 0)) return true;
    }
    return false;
  }

  double at(Vec3 p, std::uint32_t t, bool& near) const {
    double in = 1e300, out = 1e300;
    for (std::uint32_t f = 0; f < sections_.size(); ++f) {
      const FacePlane& face = cell_.shape.faces[f];
      const double height = std::fabs(face.height(p));
      double& d = is_inside(f, p - face.height(p) * face.normal, near) ? in : out;
      d = std::min(d, height);
    }
    const auto& v = cell_.complex.mesh.vertices[t];
    for (const std::uint32_t x : v) {
      in = std::min(in, norm(p - point(x)));
      out = std::min(out, norm(p - point(x)));
    }
    for (unsigned e = 0; e < 6; ++e) {
      const EdgeKind kind = cell_.complex.edges[t][e];
      const double d = distance_to_segment(p, point(v[kEdgeSlots[e][0]]), point(v[kEdgeSlots[e][1]]));
      if (kind == EdgeKind::contour || kind == EdgeKind::internal) in = std::min(in, d);
      if (kind == EdgeKind::contour) out = std::min(out, d);
    }
    return (out - in) / (out + in);
  }

  const PlacedCell& cell_;
  std::vector<std::vector<std::array<std::uint32_t, 3>>> sections_;
};

}  // namespace

TEST_CASE("random cells: the definition, within rounding") {
  int compared = 0, positive = 0, negative = 0;
  for (std::uint32_t seed = 0; seed < 150; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    PlacedCell cell = placed_cell(seed);
    if (seed % 2 != 0) cell.shape = turned(cell.shape, random);
    const Flags r1 = r1_of(cell.complex);
    const SlowMeter slow(cell);
    const std::vector<std::int32_t> fast = confidences(cell.complex, cell.shape, r1);
    REQUIRE(fast.size() == r1.size());
    for (std::uint32_t t = 0; t < r1.size(); ++t) {
      CAPTURE(t);
      CHECK(std::abs(fast[t]) <= kCertain);
      if (r1[t] == 0) {
        CHECK(fast[t] == -kCertain);
        continue;
      }
      bool near = false;
      const double expected = kCertain * slow.measure(t, near);
      if (near) continue;
      CHECK(std::fabs(fast[t] - expected) < 1);
      ++compared;
      ++(fast[t] > 0 ? positive : negative);
    }
  }
  MESSAGE("compared " << compared << ", positive " << positive << ", others " << negative);
  CHECK(compared > 2000);
  CHECK(positive > 100);
  CHECK(negative > 100);
}

TEST_CASE("random cells: confidences are in their bounds, and are these once they are known") {
  std::size_t near_sections = 0, far = 0;
  for (std::uint32_t seed = 0; seed < 150; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    PlacedCell cell = placed_cell(seed);
    if (seed % 2 != 0) cell.shape = turned(cell.shape, random);
    CellMemory memory;
    cell.shape.memory = &memory;
    const Ground ground(cell.complex);
    ConfidenceMeter meter(cell.complex, ground, cell.shape);
    for (std::uint32_t t = 0; t < cell.complex.mesh.size(); ++t) {
      const ConfidenceBounds bounds = meter.bounds(t);
      const std::int32_t confidence = meter.measure(t);
      CHECK(bounds.low <= confidence);
      CHECK(confidence <= bounds.high);
      near_sections += bounds.low > -kCertain;
      far += bounds.high < kCertain;
      CHECK(meter.bounds(t).low == confidence);
      CHECK(meter.bounds(t).high == confidence);
    }
  }
  CHECK(near_sections > 100);
  CHECK(far > 100);
}

TEST_CASE("random cells: neither numbers nor slots matter, to the last bit") {
  for (std::uint32_t seed = 200; seed < 260; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const PlacedCell cell = placed_cell(seed);
    const CellShape shape = turned(cell.shape, random);
    std::vector<std::uint32_t> from;
    const CellComplex other = shuffled(cell.complex, random, from);
    const auto a = confidences(cell.complex, shape, r1_of(cell.complex));
    const auto b = confidences(other, shape, r1_of(other));
    for (std::uint32_t t = 0; t < from.size(); ++t) CHECK(b[t] == a[from[t]]);
  }
}

TEST_CASE("random cells: a face more without section lowers, other faces' numbers change nothing") {
  int lowered = 0;
  for (std::uint32_t seed = 300; seed < 340; ++seed) {
    CAPTURE(seed);
    PlacedCell cell = placed_cell(seed);
    const Flags r1 = r1_of(cell.complex);
    const auto before = confidences(cell.complex, cell.shape, r1);
    const PlacedCell wide = with_many_faces(cell);
    CHECK(confidences(wide.complex, wide.shape, r1) == before);
    // Through the middle of the cell: no cell has it, but nearer is nearer.
    cell.shape.faces.push_back({{0, 1, 0}, -500});
    const auto after = confidences(cell.complex, cell.shape, r1);
    for (std::uint32_t t = 0; t < r1.size(); ++t) {
      CHECK(after[t] <= before[t]);
      lowered += after[t] < before[t];
    }
  }
  CHECK(lowered > 100);
}

/// With a vertex inside tetrahedron t, which it divides into four.
PlacedCell divided(PlacedCell cell, std::uint32_t t) {
  CellComplex& c = cell.complex;
  const auto v = c.mesh.vertices[t];
  const auto neighbours = c.mesh.neighbours[t];
  const auto facets = c.facets[t];
  const auto edges = c.edges[t];
  const std::array<std::uint32_t, 4> parts{t, c.mesh.size(), c.mesh.size() + 1, c.mesh.size() + 2};
  for (std::uint32_t i = 0; i < 4; ++i) {
    auto corners = v;
    corners[i] = c.vertex_count;
    auto around = parts;
    around[i] = neighbours[i];
    decltype(c.facets)::value_type kinds{};
    kinds[i] = facets[i];
    decltype(c.edges)::value_type edge_kinds{};
    for (std::size_t e = 0; e < 6; ++e)
      if (kEdgeSlots[e][0] != i && kEdgeSlots[e][1] != i) edge_kinds[e] = edges[e];
    if (i > 0) {
      c.mesh.vertices.push_back(corners), c.mesh.neighbours.push_back(around);
      c.facets.push_back(kinds), c.edges.push_back(edge_kinds);
    } else {
      c.mesh.vertices[t] = corners, c.mesh.neighbours[t] = around;
      c.facets[t] = kinds, c.edges[t] = edge_kinds;
    }
    if (neighbours[i] == kNone) continue;
    for (std::uint32_t& back : c.mesh.neighbours[neighbours[i]])
      if (back == t) back = parts[i] | 1U << 31;  // marked: t itself is a part
  }
  for (const std::uint32_t n : neighbours)
    for (std::uint32_t i = 0; n != kNone && i < 4; ++i)
      if (c.mesh.neighbours[n][i] != kNone) c.mesh.neighbours[n][i] &= ~(1U << 31);
  ++c.vertex_count;
  c.face_masks.resize(c.face_masks.size() + c.words, 0);
  const auto& at = cell.shape.points;
  cell.shape.points.push_back(0.25 * (at[v[0]] + at[v[1]] + at[v[2]] + at[v[3]]));
  return cell;
}

TEST_CASE("random cells: with the memory of the cell before it was divided, as without") {
  for (std::uint32_t seed = 400; seed < 440; ++seed) {
    CAPTURE(seed);
    PlacedCell cell = placed_cell(seed);
    CellMemory memory;
    for (std::uint32_t round = 0; round < 3; ++round) {
      const Ground ground(cell.complex);
      const Flags all(cell.complex.mesh.size(), 1);
      cell.shape.memory = nullptr;
      const std::vector<std::int32_t> without = confidences(cell.complex, cell.shape, all);
      cell.shape.memory = &memory;
      ConfidenceMeter meter(cell.complex, ground, cell.shape);
      for (std::uint32_t t = 0; t < all.size(); ++t) CHECK(meter.measure(t) == without[t]);
      cell = divided(cell, seed % cell.complex.mesh.size());
    }
  }
}

TEST_CASE("between two whole sections that are near it is certain, over none at all it is certain not") {
  // A prism of height 1 between triangles of size 1000, in three tetrahedra; its sides are far faces.
  const auto prism = [](const std::set<Triangle>& internal) {
    PlacedCell cell;
    cell.complex = make_cell({{0, 1, 2, 3}, {1, 2, 3, 4}, {2, 3, 4, 5}}, {1, 1, 1, 2, 2, 2}, internal);
    cell.shape.points = {{0, 0, 0}, {1000, 0, 0}, {0, 1000, 0}, {0, 0, 1}, {1000, 0, 1}, {0, 1000, 1}};
    cell.shape.faces = {{{0, 0, 1}, 0}, {{0, 0, -1}, 1}, {{0, 1, 0}, 1000}};
    return confidences(cell.complex, cell.shape, {1, 1, 1});
  };
  for (const std::int32_t c : prism({{0, 1, 2}, {3, 4, 5}})) CHECK(c > kCertain * 0.9);
  for (const std::int32_t c : prism({})) CHECK(c < -kCertain * 0.9);
  // One of the two: what stands on it is more likely than what hangs from the other.
  const auto half = prism({{0, 1, 2}});
  CHECK(half[0] > kCertain * 0.1);
  CHECK(half[2] < -kCertain * 0.1);
  CHECK(half[0] > half[1]);
  CHECK(half[1] > half[2]);
}
