#pragma once
/// Convex cells with points on their faces, and diagrams judged along scan lines.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "../../delaunay/delaunay3.h"
#include "../../delaunay/lattice_predicates.h"
#include "../../moebius/face_diagram.h"
#include "../../moebius/tangent_spheres.h"

namespace crossloft::test {

struct Cell {
  std::vector<LatticePlane> planes;
  std::vector<int> sides;
  std::vector<FaceFrame> frames;
  std::vector<LatticePoint> points;
  std::vector<std::uint64_t> on_faces;
  TetMesh mesh;

  std::uint32_t words() const { return static_cast<std::uint32_t>((planes.size() + 63) / 64); }
  CellSites sites() const { return {points, &mesh, frames, on_faces, words(), {}}; }
  bool contains(const LatticePoint& p) const {
    for (std::size_t f = 0; f < planes.size(); ++f)
      if (side_of_plane(planes[f], p) == -sides[f]) return false;
    return true;
  }
  void add(const LatticePoint& p) { points.push_back(p); }
  /// Masks and triangulation of the points added.
  void finish() {
    on_faces.assign(points.size() * words(), 0);
    for (std::size_t v = 0; v < points.size(); ++v)
      for (std::size_t f = 0; f < planes.size(); ++f)
        if (side_of_plane(planes[f], points[v]) == 0)
          on_faces[v * words() + f / 64] |= std::uint64_t{1} << f % 64;
    const LatticePredicates3 predicates(points);
    Delaunay3 triangulation(predicates);
    triangulation.build();
    mesh = triangulation.tet_mesh();
  }
};

/// The cell of the planes that has the origin inside.
inline Cell cell_of(std::vector<LatticePlane> planes) {
  Cell cell;
  cell.planes = std::move(planes);
  for (const LatticePlane& p : cell.planes) {
    cell.sides.push_back(side_of_plane(p, make_point({0, 0, 0})));
    cell.frames.emplace_back(p, cell.sides.back());
  }
  return cell;
}

inline Cell box_cell(std::int64_t half) {
  std::vector<LatticePlane> planes;
  for (int axis = 0; axis < 3; ++axis)
    for (const std::int64_t at : {-half, half}) planes.push_back(make_axis_plane(axis, at));
  return cell_of(planes);
}

/// `count` planes about `distance` from the origin in random directions.
inline Cell random_cell(std::size_t count, std::int64_t distance, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto draw = [&](std::int64_t range) {
    return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * range + 1)) - range;
  };
  std::vector<LatticePlane> planes;
  while (planes.size() < count) {
    const LatticeVector e1{draw(50), draw(50), draw(50)}, e2{draw(50), draw(50), draw(50)}, n = cross(e1, e2);
    const double length = norm(real(make_point(n)));
    if (length < 500) continue;
    LatticeVector origin{};
    for (std::size_t k = 0; k < 3; ++k)
      origin[k] =
          static_cast<std::int64_t>(static_cast<double>(distance) * static_cast<double>(n[k]) / length);
    planes.push_back(make_lattice_plane(origin, e1, e2));
  }
  return cell_of(planes);
}

/// About n random points on each face, at most `reach` steps of e1 and e2 from its origin.
inline void scatter(Cell& cell, std::size_t n, std::int64_t reach, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto draw = [&] {
    return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * reach + 1)) - reach;
  };
  for (const LatticePlane& plane : cell.planes)
    for (std::size_t left = n, tries = 0; left > 0 && tries < 100 * n; ++tries) {
      const std::int64_t u = draw(), v = draw();
      LatticeVector p{};
      for (std::size_t k = 0; k < 3; ++k) p[k] = plane.origin[k] + u * plane.e1[k] + v * plane.e2[k];
      if (!cell.contains(make_point(p))) continue;
      cell.add(make_point(p));
      --left;
    }
}

using Diagrams = std::vector<std::vector<FaceArc>>;

inline Diagrams all_arcs(const Cell& cell, std::span<const Box2> regions = {}) {
  CellSites sites = cell.sites();
  sites.regions = regions;
  Diagrams arcs(cell.planes.size());
  for (std::uint32_t word = 0; word < sites.words; ++word) {
    CellDiagrams diagrams(sites, word);
    diagrams.arcs([](const TetEdge&) { return ~std::uint64_t{0}; },
                  std::span(arcs).subspan(64 * std::size_t{word}, diagrams.face_count()));
  }
  return arcs;
}

/// The sites of a face by vertex; height 0 on the face.
inline std::vector<FaceSite> sites_of(const Cell& cell, std::uint32_t face) {
  const CellDiagrams diagrams(cell.sites(), face / 64);
  std::vector<FaceSite> sites;
  for (std::uint32_t v = 0; v < cell.points.size(); ++v) sites.push_back(diagrams.site(v, face % 64));
  return sites;
}

/// By brute force; ties go to the lowest vertex.
inline std::uint32_t nearest(const std::vector<FaceSite>& sites, Vec2 a) {
  std::uint32_t best = kNone;
  for (std::uint32_t v = 0; v < sites.size(); ++v)
    if (sites[v].height > 0 &&
        (best == kNone || tangent_radius(sites[v], a) < tangent_radius(sites[best], a)))
      best = v;
  return best;
}

/// A scan line crosses an arc: the cells before and behind it.
struct ScanCrossing {
  double x;
  std::uint32_t before, behind;
};

/// A point of the circle on the arc from one end counter-clockwise to the other, at most half of it: to the
/// right of the chord, in its disk.
inline bool on_short_arc(Vec2 from, Vec2 to, Vec2 p) {
  const Vec2 mid = 0.5 * (from + to), half = 0.5 * (to - from);
  return cross(half, p - from) < 0 && dot(p - mid, p - mid) <= 1.0001 * dot(half, half);
}

/// Whether a point of the curve is on the arc.
inline bool on_arc(const FaceArc& arc, Vec2 p) {
  if (arc.whole) return true;
  if (arc.curve.is_line)
    return (arc.from_infinite || dot(p - arc.from, arc.curve.direction) >= 0) &&
           (arc.to_infinite || dot(arc.to - p, arc.curve.direction) >= 0);
  const Vec2 from = arc.clockwise ? arc.to : arc.from, to = arc.clockwise ? arc.from : arc.to;
  return arc.over_half ? !on_short_arc(to, from, p) : on_short_arc(from, to, p);
}

/// All crossings of the line { y } with the arcs, left to right.
inline std::vector<ScanCrossing> scan(const std::vector<FaceArc>& arcs, double y) {
  std::vector<ScanCrossing> crossings;
  for (const FaceArc& arc : arcs) {
    const std::uint32_t i = arc.sites[0], j = arc.sites[1];
    const auto cross_at = [&](double x, bool upwards) {
      if (on_arc(arc, {x, y})) crossings.push_back({x, upwards ? i : j, upwards ? j : i});
    };
    const MoebiusCurve& curve = arc.curve;
    if (curve.is_line) {
      cross_at(curve.centre.x + (y - curve.centre.y) / curve.direction.y * curve.direction.x,
               curve.direction.y > 0);
      continue;
    }
    const double dy = y - curve.centre.y, rest = (curve.radius - dy) * (curve.radius + dy);
    if (rest <= 0) continue;
    cross_at(curve.centre.x - std::sqrt(rest), arc.clockwise);
    cross_at(curve.centre.x + std::sqrt(rest), !arc.clockwise);
  }
  std::sort(crossings.begin(), crossings.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  return crossings;
}

/// Checks `lines` scan lines through the box: between crossings the nearest site is the one that the arcs on
/// both sides name. Gaps below `tolerance` are passed over. Returns the number of gaps checked.
inline std::size_t check_by_scan(const std::vector<FaceArc>& arcs, const std::vector<FaceSite>& sites,
                                 const Box2& box, std::size_t lines, double tolerance) {
  std::size_t checked = 0, wrong = 0;
  for (std::size_t k = 0; k < lines; ++k) {
    const double part = (static_cast<double>(k) + 0.3819660112501051) / static_cast<double>(lines);
    const double y = box.low.y + part * (box.high.y - box.low.y);
    // The ends of the line have no cell beyond.
    std::vector<ScanCrossing> crossings{{box.low.x, kNone, kNone}};
    for (const ScanCrossing& c : scan(arcs, y))
      if (c.x > box.low.x && c.x < box.high.x) crossings.push_back(c);
    crossings.push_back({box.high.x, kNone, kNone});
    for (std::size_t c = 0; c + 1 < crossings.size(); ++c) {
      const ScanCrossing &left = crossings[c], &right = crossings[c + 1];
      if (right.x - left.x < tolerance) continue;
      const Vec2 middle{0.5 * (left.x + right.x), y};
      const double least = tangent_radius(sites[nearest(sites, middle)], middle);
      for (const std::uint32_t cell : {left.behind, right.before}) {
        if (cell == kNone) continue;
        ++checked;
        wrong += tangent_radius(sites[cell], middle) > least * (1 + 1e-12);
      }
    }
  }
  CHECK(wrong == 0);
  return checked;
}

inline Box2 square(double half) { return {{-half, -half}, {half, half}}; }

}  // namespace crossloft::test
