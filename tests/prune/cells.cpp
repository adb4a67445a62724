#include "cells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "geom/lattice.h"

namespace crossloft::test {
namespace {

Triangle facet_of(const Tet& tet, unsigned facet) {
  Triangle t{};
  for (unsigned i = 0; i < 3; ++i) t[i] = tet[kFacetSlots[facet][i]];
  std::sort(t.begin(), t.end());
  return t;
}

struct Point {
  LatticeVector at;
  std::uint64_t faces;

  friend auto operator<=>(const Point&, const Point&) = default;
};

constexpr std::int64_t kSize = 1009;

std::int64_t coordinate(std::mt19937& random) {
  return 1 + static_cast<std::int64_t>(random() % (kSize - 1));
}

/// On a face of the box or, one time in eight each, on an edge of it or in a corner.
Point box_point(std::mt19937& random) {
  Point p{{coordinate(random), coordinate(random), coordinate(random)}, 0};
  const std::uint32_t first = random() % 3, toss = random() % 8;
  const std::uint32_t pinned = toss == 0 ? 3 : toss == 1 ? 2 : 1;
  for (std::uint32_t i = 0; i < pinned; ++i) {
    const std::uint32_t axis = (first + i) % 3, side = random() % 2;
    p.at[axis] = side * kSize;
    p.faces |= std::uint64_t{1} << (2 * axis + side);
  }
  return p;
}

/// On one of the planes z = 0 and z = slope x + height.
Point two_plane_point(std::mt19937& random, std::int64_t slope, std::int64_t height) {
  const std::int64_t x = coordinate(random), y = coordinate(random);
  return random() % 2 == 0 ? Point{{x, y, 0}, 1} : Point{{x, y, slope * x + height}, 2};
}

enum class Hull { slab, wedge, box };

struct Points {
  Hull hull;
  std::vector<Point> list;
};

Points random_points(std::mt19937& random) {
  const std::uint32_t toss = random() % 6, count = 8 + random() % 11;
  const Hull hull = toss == 0 ? Hull::slab : toss == 1 ? Hull::wedge : Hull::box;
  std::set<Point> points;
  while (points.size() < count) {
    points.insert(hull == Hull::slab    ? two_plane_point(random, 0, 300)
                  : hull == Hull::wedge ? two_plane_point(random, 1, 0)
                                        : box_point(random));
  }
  return {hull, {points.begin(), points.end()}};
}

FacePlane face(Vec3 inward, Vec3 on) {
  const Vec3 unit = 1 / norm(inward) * inward;
  return {unit, -dot(unit, on)};
}

/// By bit of the face masks; a slab's and a wedge's other faces after them.
std::vector<FacePlane> faces_of(Hull hull) {
  const Vec3 low{0, 0, 0}, high{kSize, kSize, kSize};
  const std::vector<FacePlane> sides{face({1, 0, 0}, low), face({-1, 0, 0}, high), face({0, 1, 0}, low),
                                     face({0, -1, 0}, high)};
  std::vector<FacePlane> faces{face({0, 0, 1}, low)};
  if (hull == Hull::box) {
    faces.insert(faces.begin(), sides.begin(), sides.end());
    faces.push_back(face({0, 0, -1}, high));
    return faces;
  }
  faces.push_back(hull == Hull::slab ? face({0, 0, -1}, {0, 0, 300}) : face({1, 0, -1}, low));
  faces.insert(faces.end(), sides.begin(), sides.end());
  return faces;
}

CellShape shape_of(const Points& points) {
  CellShape shape{{}, faces_of(points.hull)};
  for (const Point& p : points.list) {
    shape.points.push_back(
        {static_cast<double>(p.at[0]), static_cast<double>(p.at[1]), static_cast<double>(p.at[2])});
  }
  return shape;
}

/// Every tetrahedron with an empty sphere; nothing if a fifth point is on one.
std::optional<std::vector<Tet>> delaunay(const std::vector<Point>& points) {
  std::vector<LatticePoint> p;
  for (const Point& point : points) p.push_back(make_point(point.at));
  const auto n = static_cast<std::uint32_t>(p.size());
  std::vector<Tet> tets;
  for (std::uint32_t a = 0; a < n; ++a) {
    for (std::uint32_t b = a + 1; b < n; ++b) {
      for (std::uint32_t c = b + 1; c < n; ++c) {
        for (std::uint32_t d = c + 1; d < n; ++d) {
          const int side = orient3d(p[a], p[b], p[c], p[d]);
          if (side == 0) continue;
          const Tet tet = side > 0 ? Tet{a, b, c, d} : Tet{b, a, c, d};
          int largest = -1;
          for (std::uint32_t e = 0; e < n && largest < 1; ++e) {
            if (e == a || e == b || e == c || e == d) continue;
            largest = std::max(largest, insphere(p[tet[0]], p[tet[1]], p[tet[2]], p[tet[3]], p[e]));
          }
          if (largest == 0) return std::nullopt;
          if (largest < 0) tets.push_back(tet);
        }
      }
    }
  }
  return tets;
}

bool centre_in_ball(const std::vector<Point>& points, const Triangle& t, const LatticeVector& centre,
                    std::int64_t radius) {
  std::int64_t distance = 0;
  for (unsigned k = 0; k < 3; ++k) {
    const std::int64_t d = points[t[0]].at[k] + points[t[1]].at[k] + points[t[2]].at[k] - 3 * centre[k];
    distance += d * d;
  }
  return distance < 9 * radius * radius;
}

std::set<Triangle> all_triangles(const std::vector<Tet>& tets) {
  std::set<Triangle> all;
  for (const Tet& tet : tets) {
    for (unsigned i = 0; i < 4; ++i) all.insert(facet_of(tet, i));
  }
  return all;
}

/// `share` of 1000 triangles.
std::set<Triangle> random_triangles(std::mt19937& random, const std::vector<Tet>& tets, std::uint32_t share) {
  std::set<Triangle> some;
  for (const Triangle& t : all_triangles(tets)) {
    if (random() % 1000 < share) some.insert(t);
  }
  return some;
}

std::set<Triangle> random_sections(std::mt19937& random, const std::vector<Point>& points,
                                   const std::vector<Tet>& tets) {
  const bool by_ball = random() % 2 == 0;
  const std::uint32_t share = 600 + random() % 500;  // of 1000
  const LatticeVector centre{coordinate(random), coordinate(random), coordinate(random)};
  if (!by_ball) return random_triangles(random, tets, share);
  std::set<Triangle> internal;
  for (const Triangle& t : all_triangles(tets)) {
    if (centre_in_ball(points, t, centre, share)) internal.insert(t);
  }
  return internal;
}

void set_neighbours(TetMesh& mesh) {
  std::map<Triangle, std::pair<std::uint32_t, unsigned>> open;
  mesh.neighbours.assign(mesh.size(), {kNone, kNone, kNone, kNone});
  for (std::uint32_t t = 0; t < mesh.size(); ++t) {
    for (unsigned i = 0; i < 4; ++i) {
      const auto [entry, is_new] = open.emplace(facet_of(mesh.vertices[t], i), std::pair(t, i));
      if (is_new) continue;
      mesh.neighbours[t][i] = entry->second.first;
      mesh.neighbours[entry->second.first][entry->second.second] = t;
    }
  }
}

}  // namespace

CellComplex make_cell(const std::vector<Tet>& tets, const std::vector<std::uint64_t>& masks,
                      const std::set<Triangle>& internal) {
  CellComplex cell;
  cell.mesh.vertices = tets;
  cell.vertex_count = static_cast<std::uint32_t>(masks.size());
  cell.face_masks = masks;
  set_neighbours(cell.mesh);
  cell.facets.assign(tets.size(), {});
  cell.edges.assign(tets.size(), {});
  std::map<std::set<std::uint32_t>, std::set<FacetKind>> around;  // of an edge
  for (std::uint32_t t = 0; t < tets.size(); ++t) {
    for (unsigned i = 0; i < 4; ++i) {
      const Triangle f = facet_of(tets[t], i);
      if ((masks[f[0]] & masks[f[1]] & masks[f[2]]) == 0) continue;
      cell.facets[t][i] = internal.count(f) != 0 ? FacetKind::internal : FacetKind::external;
      for (unsigned k = 0; k < 3; ++k) around[{f[k], f[(k + 1) % 3]}].insert(cell.facets[t][i]);
    }
  }
  for (std::uint32_t t = 0; t < tets.size(); ++t) {
    for (unsigned e = 0; e < 6; ++e) {
      const std::uint32_t a = tets[t][kEdgeSlots[e][0]], b = tets[t][kEdgeSlots[e][1]];
      if ((masks[a] & masks[b]) == 0) continue;
      const auto& kinds = around[{a, b}];
      cell.edges[t][e] = kinds.count(FacetKind::internal) == 0   ? EdgeKind::external
                         : kinds.count(FacetKind::external) != 0 ? EdgeKind::contour
                                                                 : EdgeKind::internal;
    }
  }
  return cell;
}

CellComplex random_cell(std::uint32_t seed) { return placed_cell(seed).complex; }

PlacedCell placed_cell(std::uint32_t seed) {
  std::mt19937 random(seed);
  for (;;) {
    const Points points = random_points(random);
    const auto tets = delaunay(points.list);
    if (!tets) continue;
    std::vector<std::uint64_t> masks;
    for (const Point& p : points.list) masks.push_back(p.faces);
    return {make_cell(*tets, masks, random_sections(random, points.list, *tets)), shape_of(points)};
  }
}

CellComplex deep_cell(std::uint32_t seed) {
  std::mt19937 random(seed);
  for (;;) {
    std::set<Point> points;
    while (points.size() < 13) points.insert(two_plane_point(random, 0, 300));
    for (std::uint32_t i = 0, n = 6 + random() % 5; i < n; ++i) {
      points.insert({{coordinate(random), coordinate(random), 1 + coordinate(random) % 298}, 0});
    }
    const std::vector<Point> list(points.begin(), points.end());
    const auto tets = delaunay(list);
    if (!tets) continue;
    std::vector<std::uint64_t> masks;
    for (const Point& p : list) masks.push_back(p.faces);
    return make_cell(*tets, masks, random_triangles(random, *tets, 850));
  }
}

CellShape turned(const CellShape& shape, std::mt19937& random) {
  // By the unit quaternion (a, b, c, d).
  std::array<double, 4> q{};
  double square = 0;
  for (double& x : q) {
    x = 1 + static_cast<double>(random() % 1000);
    square += x * x;
  }
  for (double& x : q) x /= std::sqrt(square);
  const auto [a, b, c, d] = q;
  const auto turn = [&, a = a, axis = Vec3{b, c, d}](Vec3 p) {
    const Vec3 side = cross(axis, p);
    return p + 2 * (a * side + cross(axis, side));
  };
  CellShape result;
  for (const Vec3& p : shape.points) result.points.push_back(turn(p));
  for (const FacePlane& f : shape.faces) result.faces.push_back({turn(f.normal), f.offset});
  return result;
}

PlacedCell turned_cell(std::uint32_t seed, std::mt19937& random) {
  PlacedCell cell = placed_cell(seed);
  cell.shape = turned(cell.shape, random);
  return cell;
}

PlacedCell with_many_faces(const PlacedCell& cell) {
  constexpr unsigned kMore = 70;
  PlacedCell wide = cell;
  wide.complex.words = 2;
  wide.complex.face_masks.clear();
  for (const std::uint64_t mask : cell.complex.face_masks) {
    wide.complex.face_masks.insert(wide.complex.face_masks.end(), {0, mask << (kMore - 64)});
  }
  const FacePlane far{cell.shape.faces[0].normal, 1e6};
  wide.shape.faces.insert(wide.shape.faces.begin(), kMore, far);
  return wide;
}

std::vector<std::uint8_t> r1_of(const CellComplex& cell) {
  std::vector<std::uint8_t> r1;
  for (std::uint32_t t = 0; t < cell.mesh.size(); ++t) {
    const auto& facets = cell.facets[t];
    const auto& edges = cell.edges[t];
    r1.push_back(std::count(facets.begin(), facets.end(), FacetKind::external) == 0 &&
                 std::count(edges.begin(), edges.end(), EdgeKind::external) == 0);
  }
  return r1;
}

CellComplex shuffled(const CellComplex& cell, std::mt19937& random, std::vector<std::uint32_t>& from) {
  from.resize(cell.mesh.size());
  std::iota(from.begin(), from.end(), 0U);
  std::shuffle(from.begin(), from.end(), random);
  std::set<Triangle> internal;
  std::vector<Tet> tets;
  for (const std::uint32_t t : from) {
    for (unsigned i = 0; i < 4; ++i) {
      if (cell.facets[t][i] == FacetKind::internal) internal.insert(facet_of(cell.mesh.vertices[t], i));
    }
    Tet tet = cell.mesh.vertices[t];
    std::rotate(tet.begin() + 1, tet.begin() + 1 + random() % 3, tet.end());
    if (random() % 2 == 0) {
      std::swap(tet[0], tet[1]);
      std::swap(tet[2], tet[3]);
    }
    tets.push_back(tet);
  }
  return make_cell(tets, cell.face_masks, internal);
}

}  // namespace crossloft::test
