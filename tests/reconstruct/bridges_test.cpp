/// Bridges cell by cell: the pieces, and several together.
#include "../../reconstruct/bridges.h"

#include <map>

#include "../../inspect/check.h"
#include "../../inspect/surface_topology.h"
#include "../../prune/star.h"
#include "../../reconstruct/glue.h"
#include "shown.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

/// One cell with the pieces of its bridges and where all points are.
struct CellCase {
  const BuiltCell& cell;
  std::vector<std::uint8_t> kept;
  std::span<const LatticePoint> points;
  CellBridges bridges;

  CellCase(const BuiltCell& of, std::vector<std::uint8_t> keep, std::span<const LatticePoint> at)
      : cell(of),
        kept(std::move(keep)),
        points(at),
        bridges(find_bridges(cell, Ground(cell.complex), kept)) {}

  const LatticePoint& point(std::uint32_t v) const {
    return v < kFirstBridgePoint ? points[v] : bridges.points[v - kFirstBridgePoint];
  }
  Tet tet(std::size_t t) const {
    Tet numbers = cell.complex.mesh.vertices[t];
    for (std::uint32_t& v : numbers) v = cell.vertices[v];
    return numbers;
  }
  std::vector<Tet> tets(bool are_kept) const {
    std::vector<Tet> list;
    for (std::size_t t = 0; t < kept.size(); ++t)
      if ((kept[t] != 0) == are_kept) list.push_back(tet(t));
    return list;
  }
  /// All pieces once, ascending.
  std::vector<Tet> pieces() const {
    std::set<Tet> all;
    for (const Bridge& b : bridges.bridges) all.insert(b.pieces.begin(), b.pieces.end());
    return {all.begin(), all.end()};
  }
};

/// What natural kept of the cell; some of R1, which breaks more; nothing.
std::vector<std::vector<std::uint8_t>> solids(const BuiltCell& cell, const std::vector<std::uint8_t>& natural,
                                              std::mt19937& random) {
  std::vector<std::vector<std::uint8_t>> list{natural, std::vector<std::uint8_t>(natural.size(), 0)};
  for (const std::uint32_t share : {9U, 6U}) {
    std::vector<std::uint8_t>& some = list.emplace_back();
    for (std::size_t t = 0; t < natural.size(); ++t) {
      const auto& edges = cell.complex.edges[t];
      const auto& facets = cell.complex.facets[t];
      some.push_back(std::count(edges.begin(), edges.end(), EdgeKind::external) == 0 &&
                     std::count(facets.begin(), facets.end(), FacetKind::external) == 0 &&
                     random() % 10 < share);
    }
  }
  return list;
}

void for_cells(const std::vector<Scene>& scenes, const std::function<void(const CellCase&)>& check) {
  for (const Scene& scene : scenes) {
    CAPTURE(scene.name);
    run(scene.sections, [&](const Shown& shown) {
      for (std::size_t c = 0; c < shown.cells.size(); ++c) {
        CAPTURE(c);
        std::mt19937 random(static_cast<std::uint32_t>(c));
        for (const auto& kept : solids(shown.cells[c], shown.kept[c], random))
          check(CellCase(shown.cells[c], kept, shown.points));
      }
    });
  }
}

/// True iff the boxes around the corners have no common interior: a quick reason to be apart.
bool boxes_apart(const CellCase& c, const Tet& s, const Tet& t) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto [s0, s1] =
        std::minmax({c.point(s[0])[axis], c.point(s[1])[axis], c.point(s[2])[axis], c.point(s[3])[axis]});
    const auto [t0, t1] =
        std::minmax({c.point(t[0])[axis], c.point(t[1])[axis], c.point(t[2])[axis], c.point(t[3])[axis]});
    if (s1 < t0 || t1 < s0) return true;
  }
  return false;
}

/// Exact: two tetrahedra have no common interior point iff the plane through three of their corners has them
/// on different sides. (Planes between them form a cone; its extreme rays touch three independent corners.)
bool apart(const CellCase& c, const Tet& s, const Tet& t) {
  if (boxes_apart(c, s, t)) return true;
  std::set<std::uint32_t> both(s.begin(), s.end());
  both.insert(t.begin(), t.end());
  const std::vector<std::uint32_t> v(both.begin(), both.end());
  const auto sides = [&](const Tet& of, std::size_t i, std::size_t j, std::size_t k) {
    std::array<int, 2> range{0, 0};
    for (const std::uint32_t x : of) {
      const int side = orient3d(c.point(v[i]), c.point(v[j]), c.point(v[k]), c.point(x));
      range[0] = std::min(range[0], side), range[1] = std::max(range[1], side);
    }
    return range;
  };
  for (std::size_t i = 0; i < v.size(); ++i)
    for (std::size_t j = i + 1; j < v.size(); ++j)
      for (std::size_t k = j + 1; k < v.size(); ++k) {
        const auto a = sides(s, i, j, k), b = sides(t, i, j, k);
        if (a == std::array{0, 0} || b == std::array{0, 0}) continue;
        if ((a[1] == 0 && b[0] == 0) || (a[0] == 0 && b[1] == 0)) return true;
      }
  return false;
}

}  // namespace

TEST_CASE("the exact test of the tests: tetrahedra apart, touching and overlapping") {
  const BuiltCell none;
  std::vector<LatticePoint> points;
  for (const LatticeVector& p : {LatticeVector{0, 0, 0},
                                 {4, 0, 0},
                                 {0, 4, 0},
                                 {0, 0, 4},
                                 {0, 0, -4},
                                 {1, 1, 1},
                                 {4, 4, 4},
                                 {9, 9, 9},
                                 {1, 1, -5}})
    points.push_back(make_point(p));
  const CellCase c(none, {}, points);
  CHECK(apart(c, {0, 1, 2, 3}, {0, 1, 2, 4}));
  CHECK(apart(c, {0, 1, 2, 3}, {1, 2, 3, 6}));
  CHECK(!apart(c, {0, 1, 2, 3}, {0, 1, 2, 5}));
  CHECK(!apart(c, {0, 1, 2, 3}, {0, 1, 2, 3}));
  CHECK(!apart(c, {0, 1, 2, 3}, {5, 6, 7, 8}));
}

TEST_CASE("pieces are positively oriented, apart from each other and from what is kept") {
  std::size_t pieces_seen = 0, shared = 0, bridges = 0;
  for_cells(small_scenes(), [&](const CellCase& c) {
    const std::vector<Tet> pieces = c.pieces();
    std::set<Tet> as_sets;
    for (const Tet& p : pieces) {
      CHECK(orient3d(c.point(p[0]), c.point(p[1]), c.point(p[2]), c.point(p[3])) > 0);
      CHECK(as_sets.insert(ascending(p)).second);  // told in one order by all bridges
    }
    std::size_t told = 0;
    for (const Bridge& b : c.bridges.bridges) {
      told += b.pieces.size();
      bridges += b.pieces.empty() ? 0U : 1U;
      CHECK(std::set<Tet>(b.pieces.begin(), b.pieces.end()).size() == b.pieces.size());
    }
    shared += told - pieces.size();
    pieces_seen += pieces.size();
    std::size_t overlaps = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) overlaps += apart(c, pieces[i], pieces[j]) ? 0U : 1U;
    for (const Tet& t : c.tets(true))
      for (const Tet& p : pieces) overlaps += apart(c, p, t) ? 0U : 1U;
    CHECK(overlaps == 0);
  });
  MESSAGE(bridges << " bridges of " << pieces_seen << " pieces, " << shared << " of them told again");
  CHECK(bridges > 300);
  CHECK(shared > 50);
}

TEST_CASE("bridge points are strictly within the cell") {
  std::size_t seen = 0;
  for_cells(small_scenes(), [&](const CellCase& c) {
    std::set<std::uint32_t> used;
    for (const Tet& p : c.pieces())
      for (const std::uint32_t v : p)
        if (v >= kFirstBridgePoint) used.insert(v);
    seen += used.size();
    std::size_t outside = 0;
    for (std::size_t t = 0; t < c.kept.size(); ++t)
      for (unsigned i = 0; i < 4; ++i) {
        if (c.cell.complex.mesh.neighbours[t][i] != kNone) continue;
        // Within the hull of the section vertices, so within the cell.
        for (const std::uint32_t v : used) {
          Tet moved = c.tet(t);
          moved[i] = v;
          const int side =
              orient3d(c.point(moved[0]), c.point(moved[1]), c.point(moved[2]), c.point(moved[3]));
          outside += side > 0 ? 0U : 1U;
        }
      }
    CHECK(outside == 0);
  });
  CHECK(seen > 300);
}

TEST_CASE("a piece is at its edge, on nothing outside of a section, and within what is not kept") {
  for_cells(small_scenes(), [](const CellCase& c) {
    std::set<Edge> outside_edges;
    std::set<Triangle> outside_triangles;
    for (std::size_t t = 0; t < c.kept.size(); ++t) {
      for (unsigned e = 0; e < 6; ++e)
        if (c.cell.complex.edges[t][e] == EdgeKind::external) outside_edges.insert(edge_of(c.tet(t), e));
      for (unsigned i = 0; i < 4; ++i)
        if (c.cell.complex.facets[t][i] == FacetKind::external)
          outside_triangles.insert(facet_of(c.tet(t), i));
    }
    for (const Bridge& b : c.bridges.bridges) {
      CHECK(b.edge[0] < b.edge[1]);
      CHECK(b.edge[1] < kFirstBridgePoint);
      for (const Tet& p : b.pieces) {
        CHECK(has(p, b.edge));
        for (unsigned e = 0; e < 6; ++e) CHECK(outside_edges.count(edge_of(p, e)) == 0);
        for (unsigned i = 0; i < 4; ++i) CHECK(outside_triangles.count(facet_of(p, i)) == 0);
      }
    }
  });
}

TEST_CASE("pieces and kept tetrahedra lead around the edge from one ground triangle to the other") {
  std::size_t built = 0, not_built = 0, bare_ends = 0;
  for_cells(small_scenes(), [&](const CellCase& c) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, Triangle> ground;
    const Ground facets(c.cell.complex);
    REQUIRE(facets.size() == c.cell.ground.size());
    for (std::uint32_t k = 0; k < facets.size(); ++k) {
      const GroundTriangle& g = c.cell.ground[k];
      ground[{g.face, g.triangle}] = facet_of(c.tet(facets.facet(k).tet), facets.facet(k).facet);
    }
    for (const Bridge& b : c.bridges.bridges) {
      ++(b.pieces.empty() ? not_built : built);
      std::set<Triangle> ends;
      for (const GroundTriangle& g : b.ground) {
        REQUIRE(ground.count({g.face, g.triangle}) == 1);
        ends.insert(ground.at({g.face, g.triangle}));
        CHECK(has(ground.at({g.face, g.triangle}), b.edge));
      }
      CHECK(ends.size() == 2);
      if (b.pieces.empty()) continue;
      // Around the edge each triangle is met twice, but for the two ends: one chain, as nothing else is
      // there.
      std::map<Triangle, std::vector<std::size_t>> at;
      std::vector<Tet> chain = b.pieces;
      for (const Tet& t : c.tets(true))
        if (has(t, b.edge)) chain.push_back(t);
      for (std::size_t k = 0; k < chain.size(); ++k)
        for (unsigned i = 0; i < 4; ++i)
          if (const Triangle f = facet_of(chain[k], i); has(f, b.edge)) at[f].push_back(k);
      Groups links(chain.size());
      std::set<Triangle> once;
      for (const auto& [triangle, tets] : at) {
        CHECK(tets.size() <= 2);
        links.put_together(tets.front(), tets.back());
        if (tets.size() == 1) once.insert(triangle);
      }
      CHECK(links.count() == 1);
      CHECK(once == ends);
      for (const Triangle& end : ends) bare_ends += at[end].front() < b.pieces.size() ? 1U : 0U;
    }
  });
  MESSAGE(built << " bridges, " << not_built << " that can't be built, " << bare_ends << " bare ends");
  CHECK(built > 300);
  CHECK(bare_ends > 50);
}

namespace {

/// The same cell with its tetrahedra in another order, each with its vertices in another even order.
/// from[t] = the number that tetrahedron t had.
BuiltCell shuffled_cell(const BuiltCell& cell, std::mt19937& random, std::vector<std::uint32_t>& from) {
  const CellComplex& old = cell.complex;
  std::vector<std::uint32_t> to(old.mesh.size());
  for (std::uint32_t t = 0; t < to.size(); ++t) from.push_back(t);
  std::shuffle(from.begin(), from.end(), random);
  for (std::uint32_t t = 0; t < to.size(); ++t) to[from[t]] = t;
  BuiltCell result = cell;
  const Ground ground(old);
  result.ground.clear();
  for (std::uint32_t t = 0; t < to.size(); ++t) {
    std::array<std::uint8_t, 4> slot{0, 1, 2, 3};  // [new] = old
    std::rotate(slot.begin() + 1, slot.begin() + 2, slot.end());
    if (random() % 2 == 0) std::swap(slot[0], slot[1]), std::swap(slot[2], slot[3]);
    const std::uint32_t o = from[t];
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t n = old.mesh.neighbours[o][slot[i]];
      result.complex.mesh.vertices[t][i] = old.mesh.vertices[o][slot[i]];
      result.complex.mesh.neighbours[t][i] = n == kNone ? kNone : to[n];
      result.complex.facets[t][i] = old.facets[o][slot[i]];
      if (ground.is_ground(o, slot[i])) result.ground.push_back(cell.ground[ground.at(o, slot[i])]);
    }
    for (unsigned e = 0; e < 6; ++e) {
      const unsigned corner = kEdgeCorner[slot[kEdgeSlots[e][0]]][slot[kEdgeSlots[e][1]]];
      result.complex.edges[t][e] = old.edges[o][corner - 4];
    }
  }
  return result;
}

/// A corner by its place: points of bridges have no number that means anything.
std::set<std::set<std::array<double, 3>>> places(const CellCase& c, const Bridge& bridge) {
  std::set<std::set<std::array<double, 3>>> all;
  for (const Tet& p : bridge.pieces) {
    std::set<std::array<double, 3>> corners;
    for (const std::uint32_t v : p) corners.insert({c.point(v).x, c.point(v).y, c.point(v).z});
    all.insert(corners);
  }
  return all;
}

auto by_edges(const CellCase& c) {
  std::map<Edge, std::set<std::set<std::array<double, 3>>>> all;
  for (const Bridge& b : c.bridges.bridges) CHECK(all.emplace(b.edge, places(c, b)).second);
  return all;
}

/// Five tetrahedra around the edge 0-1, on the ground triangles 0 1 2 and 0 1 7 alone; `size` = length of the
/// edge.
BuiltCell half_turn(std::int64_t size) {
  const LatticeVector at[] = {{0, 0, 0},           {size, 0, 0}, {0, size, 0},         {0, size, size},
                              {0, size / 2, size}, {0, 0, size}, {0, -size / 2, size}, {0, -size, 0}};
  BuiltCell cell;
  for (const LatticeVector& p : at) cell.points.push_back(make_point(p));
  for (std::uint32_t v = 0; v < 8; ++v) cell.vertices.push_back(v);
  cell.complex.vertex_count = 8;
  cell.complex.face_masks.assign(8, 0);
  for (std::uint32_t k = 0; k < 5; ++k) {
    const std::uint32_t before = k == 0 ? kNone : k - 1, after = k == 4 ? kNone : k + 1;
    cell.complex.mesh.vertices.push_back({0, 1, 2 + k, 3 + k});
    cell.complex.mesh.neighbours.push_back({kNone, kNone, after, before});
    cell.complex.facets.push_back({});
    cell.complex.edges.push_back({});
  }
  cell.complex.facets[0][3] = cell.complex.facets[4][2] = FacetKind::internal;
  cell.ground = {{0, 0}, {0, 1}};
  return cell;
}

}  // namespace

TEST_CASE("bridges do not depend on the numbers of the tetrahedra nor on the order of their vertices") {
  std::size_t seen = 0;
  for_cells(small_scenes(), [&](const CellCase& c) {
    std::mt19937 random(5);
    std::vector<std::uint32_t> from;
    const BuiltCell other = shuffled_cell(c.cell, random, from);
    std::vector<std::uint8_t> moved;
    for (const std::uint32_t t : from) moved.push_back(c.kept[t]);
    const auto expected = by_edges(c);
    CHECK(by_edges(CellCase(other, moved, c.points)) == expected);
    seen += expected.size();
  });
  CHECK(seen > 1000);
}

namespace {

/// The ground of a cell as a slab of tetrahedra: a prism behind each triangle, to copies of its vertices. One
/// order of the vertices cuts the sides of neighbours alike.
std::vector<Tet> slabs(const CellCase& c) {
  const auto copy = [&](std::uint32_t v) {
    return v + static_cast<std::uint32_t>(c.points.size() + c.bridges.points.size());
  };
  std::vector<Tet> list;
  for (std::size_t t = 0; t < c.kept.size(); ++t)
    for (unsigned i = 0; i < 4; ++i) {
      if (c.cell.complex.facets[t][i] != FacetKind::internal) continue;
      const auto [p, q, r] = facet_of(c.tet(t), i);
      std::array<Tet, 3> prism{
          {{p, q, r, copy(r)}, {p, q, copy(r), copy(q)}, {p, copy(p), copy(q), copy(r)}}};
      // These are positive if the copies are on the positive side; the tetrahedron is on the other one.
      const bool turned = orient3d(c.point(p), c.point(q), c.point(r), c.point(c.tet(t)[i])) > 0;
      for (Tet& tet : prism) {
        if (turned) std::swap(tet[0], tet[1]);
        list.push_back(tet);
      }
    }
  return list;
}

/// Bridge points right after the others, as gluing wants small numbers.
Tet glued_numbers(const CellCase& c, Tet piece) {
  for (std::uint32_t& v : piece)
    if (v >= kFirstBridgePoint) v = v - kFirstBridgePoint + static_cast<std::uint32_t>(c.points.size());
  return piece;
}

struct Shape {
  std::int64_t euler = 0;
  std::size_t components = 0;

  friend bool operator==(const Shape&, const Shape&) = default;
};

Shape shape_of(const std::vector<Tet>& solid) {
  const auto glued = glue(solid);
  REQUIRE(glued.ok());
  Surface surface;
  surface.triangles = glued->triangles;
  for (std::size_t v = 0; v < glued->vertices.size(); ++v)
    surface.points.push_back({static_cast<double>(v), 0, 0});
  CheckReport report;
  check_topology(surface, report);
  Shape shape{0, report.components.size()};
  for (const ComponentReport& part : report.components) shape.euler += part.euler;
  return shape;
}

}  // namespace

TEST_CASE("bridges that fit change nothing of what a cell counts: no handle, no dome, no join") {
  std::size_t built = 0, refused = 0, harmful = 0;
  for_cells(small_scenes(), [&](const CellCase& c) {
    std::vector<Tet> before = c.tets(true);
    for (const Tet& t : slabs(c)) before.push_back(t);
    if (before.empty()) return;
    const auto with = [&](const BuiltBridges& bridges) {
      std::vector<Tet> solid = before;
      for (const Tet& piece : bridges.pieces()) solid.push_back(glued_numbers(c, piece));
      return shape_of(solid);
    };
    const Shape shape = shape_of(before);
    BuiltBridges fitting, all;
    for (const Bridge& b : c.bridges.bridges) {
      all.add(b);
      if (fitting.handles_of(b) == 0U) {
        fitting.add(b);
        built += b.pieces.empty() ? 0U : 1U;
      } else {
        ++refused;
      }
    }
    CHECK(with(fitting) == shape);
    harmful += with(all) == shape ? 0U : 1U;
  });
  MESSAGE(built << " bridges built, " << refused << " refused; " << harmful << " solids would have changed");
  CHECK(built > 1000);
  CHECK(refused > 0);
  CHECK(harmful > 0);
}

TEST_CASE("bridges over several gaps: each makes as many handles as it says") {
  std::vector<Scene> scenes = small_scenes();
  const Surface shells = nested_shells(16);
  for (const std::uint32_t count : {7u, 9u, 11u})
    scenes.push_back({"shells by " + std::to_string(count) + " slices",
                      cut(shells, parallel_planes(bounds_of(shells.points), count, {0.3, 0.5, 1}))});
  std::size_t simple = 0, with_handles = 0, refused = 0;
  for_cells(scenes, [&](const CellCase& c) {
    std::vector<Tet> before = c.tets(true);
    for (const Tet& t : slabs(c)) before.push_back(t);
    if (before.empty()) return;
    BuiltBridges built;
    const auto shape = [&] {
      std::vector<Tet> solid = before;
      for (const Tet& piece : built.pieces()) solid.push_back(glued_numbers(c, piece));
      return shape_of(solid);
    };
    for (const Bridge& b : c.bridges.bridges) {
      const auto handles = built.handles_of(b);
      refused += handles ? 0U : 1U;
      if (!handles || b.pieces.empty()) continue;
      if (b.wedges.empty()) {  // as the test before
        built.add(b);
        continue;
      }
      Shape expected = shape();
      expected.euler -= 2 * std::int64_t{*handles};
      built.add(b);
      CHECK(shape() == expected);
      ++(*handles == 0 ? simple : with_handles);
    }
  });
  MESSAGE(simple << " simple ones, " << with_handles << " with handles, " << refused << " refused");
  CHECK(simple > 100);
  CHECK(with_handles > 50);
}

TEST_CASE("a gap too thin for the grid has no pieces; several gaps at an edge are bridged together") {
  const auto pieces = [](std::int64_t size, std::vector<std::uint8_t> kept) {
    const BuiltCell cell = half_turn(size);
    const CellBridges found = find_bridges(cell, Ground(cell.complex), kept);
    REQUIRE(found.bridges.size() == 1);
    CHECK(found.bridges[0].edge == Edge{0, 1});
    CHECK(found.bridges[0].ground[0].triangle == 0);
    CHECK(found.bridges[0].ground[1].triangle == 1);
    return found.bridges[0].pieces.size();
  };
  CHECK(pieces(4096, {0, 0, 0, 0, 0}) == 10);
  CHECK(pieces(4096, {1, 0, 0, 0, 1}) == 6);
  CHECK(pieces(4096, {1, 1, 0, 1, 1}) == 2);
  CHECK(pieces(4096, {1, 0, 1, 0, 1}) == 4);
  CHECK(pieces(4096, {0, 0, 1, 0, 0}) == 8);
  CHECK(pieces(4, {0, 0, 0, 0, 0}) == 0);
}
