/// Bridges: the pieces by themselves, cell by cell, and what the whole solid owes to them.
#include "../../reconstruct/bridges.h"

#include <array>
#include <functional>
#include <map>
#include <set>

#include "../../inspect/check.h"
#include "../../inspect/slice.h"
#include "../../inspect/solids.h"
#include "../../inspect/surface_topology.h"
#include "../../prune/star.h"
#include "../../reconstruct/glue.h"
#include "../../reconstruct/observer.h"
#include "../arrangement/polygon_sections.h"
#include "scenes.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

using Tet = std::array<std::uint32_t, 4>;
using Triangle = std::array<std::uint32_t, 3>;
using Edge = std::array<std::uint32_t, 2>;

template <std::size_t N>
std::array<std::uint32_t, N> ascending(std::array<std::uint32_t, N> s) {
  std::sort(s.begin(), s.end());
  return s;
}

Triangle facet_of(const Tet& t, unsigned i) {
  return ascending(Triangle{t[kFacetSlots[i][0]], t[kFacetSlots[i][1]], t[kFacetSlots[i][2]]});
}

Edge edge_of(const Tet& t, unsigned e) { return ascending(Edge{t[kEdgeSlots[e][0]], t[kEdgeSlots[e][1]]}); }

template <std::size_t N>
bool has(const std::array<std::uint32_t, N>& simplex, const Edge& edge) {
  return std::count(simplex.begin(), simplex.end(), edge[0]) == 1 &&
         std::count(simplex.begin(), simplex.end(), edge[1]) == 1;
}

class Groups {
 public:
  explicit Groups(std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) group_.push_back(i);
  }
  void put_together(std::size_t a, std::size_t b) {
    const std::size_t low = std::min(group_[a], group_[b]), high = std::max(group_[a], group_[b]);
    std::replace(group_.begin(), group_.end(), high, low);
  }
  std::size_t of(std::size_t x) const { return group_[x]; }
  std::size_t count() const { return std::set<std::size_t>(group_.begin(), group_.end()).size(); }

 private:
  std::vector<std::size_t> group_;
};

/// What an observer sees of the faces, all cells, and the solid. Points are alive only during the call.
struct Shown {
  std::vector<FaceTriangulation> faces;
  std::vector<std::vector<std::uint32_t>> face_numbers;
  std::vector<BuiltCell> cells;
  std::vector<std::vector<std::uint8_t>> kept;
  std::vector<Tet> solid;
  std::span<const LatticePoint> points;

  /// Calls visit(triangle, kinds of its sides by edge) for the section triangles, by final numbers.
  template <class Visit>
  void for_section_triangles(Visit&& visit) const {
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (std::size_t t = 0; t < faces[f].triangles.size(); ++t) {
        const auto& v = faces[f].triangles[t];
        const auto& n = face_numbers[f];
        if (faces[f].internal[t] != 0) visit(ascending(Triangle{n[v[0]], n[v[1]], n[v[2]]}));
      }
  }
  /// The edges inside sections, on the lines of planes too.
  std::set<Edge> inner_edges() const {
    std::set<Edge> edges;
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (const FaceEdge& e : faces[f].edges)
        if (e.kind == EdgeKind::internal)
          edges.insert(ascending(Edge{face_numbers[f][e.a], face_numbers[f][e.b]}));
    return edges;
  }
};

class Watcher : public Observer {
 public:
  explicit Watcher(std::function<void(const Shown&)> check) : check_(std::move(check)) {}
  void on_face(const FaceTriangulation& face, const Numbering& numbering) override {
    shown_.faces.push_back(face);
    shown_.face_numbers.push_back(numbering.of_face[face.face.value]);
  }
  void on_cell(CellId, const BuiltCell& cell, const PruneResult& pruned) override {
    shown_.cells.push_back(cell);
    shown_.kept.push_back(pruned.kept);
  }
  void on_solid(std::span<const Tet> solid, const Numbering& numbering) override {
    shown_.solid.assign(solid.begin(), solid.end());
    shown_.points = numbering.points;
    check_(shown_);
  }

 private:
  std::function<void(const Shown&)> check_;
  Shown shown_;
};

Reconstruction run(const Sections& sections, const std::function<void(const Shown&)>& check = {},
                   const Options& options = {}) {
  Watcher watcher(check);
  auto r = reconstruct(sections, options, {}, check ? &watcher : nullptr);
  REQUIRE(r.ok());
  return std::move(r).value();
}

struct Scene {
  std::string name;
  Sections sections;
  Options options = {};
};

Sections cut(const Surface& mesh, std::vector<CuttingPlane> planes) {
  auto sections = slice(mesh, planes);
  REQUIRE(sections.ok());
  return std::move(sections).value();
}

Sections cut_randomly(const Surface& mesh, std::uint32_t count, std::uint64_t seed) {
  return cut(mesh, random_planes(bounds_of(mesh.points), count, seed));
}

std::vector<Scene> small_scenes() {
  return {{"fig18", load("figures/fig18.contour")},
          {"fig20", load("figures/fig20.contour")},
          {"link", load("topology/link.contour")},
          {"torus by 8", cut_randomly(torus(1, 0.4, 20, 10), 8, 1)},
          {"vessel by 9", cut_randomly(vessel_solid(14), 9, 3)},
          {"genus 2 by 7 about a line",
           cut(genus2_solid(14), rotational_planes(bounds_of(genus2_solid(14).points), 7))}};
}

/// One cell with the pieces of its bridges and where all points are.
struct CellCase {
  const BuiltCell& cell;
  std::vector<std::uint8_t> kept;
  std::span<const LatticePoint> points;
  CellBridges bridges;

  CellCase(const BuiltCell& of, std::vector<std::uint8_t> keep, std::span<const LatticePoint> at)
      : cell(of), kept(std::move(keep)), points(at), bridges(find_bridges(cell, kept, points)) {}

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
    for (std::size_t t = 0; t < c.kept.size(); ++t)
      for (unsigned i = 0; i < 4; ++i)
        if (const GroundTriangle g = c.cell.ground[t][i]; g.face != kNone)
          ground[{g.face, g.triangle}] = facet_of(c.tet(t), i);
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
      result.ground[t][i] = cell.ground[o][slot[i]];
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
BuiltCell half_turn(std::int64_t size, std::vector<LatticePoint>& points) {
  const LatticeVector at[] = {{0, 0, 0},           {size, 0, 0}, {0, size, 0},         {0, size, size},
                              {0, size / 2, size}, {0, 0, size}, {0, -size / 2, size}, {0, -size, 0}};
  for (const LatticeVector& p : at) points.push_back(make_point(p));
  BuiltCell cell;
  for (std::uint32_t v = 0; v < 8; ++v) cell.vertices.push_back(v);
  cell.complex.vertex_count = 8;
  cell.complex.face_masks.assign(8, 0);
  for (std::uint32_t k = 0; k < 5; ++k) {
    const std::uint32_t before = k == 0 ? kNone : k - 1, after = k == 4 ? kNone : k + 1;
    cell.complex.mesh.vertices.push_back({0, 1, 2 + k, 3 + k});
    cell.complex.mesh.neighbours.push_back({kNone, kNone, after, before});
    cell.complex.facets.push_back({});
    cell.complex.edges.push_back({});
    cell.ground.push_back({GroundTriangle{kNone, 0}, {kNone, 0}, {kNone, 0}, {kNone, 0}});
  }
  cell.complex.facets[0][3] = cell.complex.facets[4][2] = FacetKind::internal;
  cell.ground[0][3] = {0, 0}, cell.ground[4][2] = {0, 1};
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
      if (fitting.fits(b)) {
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

TEST_CASE("a gap too thin for the grid has no pieces, nor have several gaps at an edge") {
  const auto pieces = [](std::int64_t size, std::vector<std::uint8_t> kept) {
    std::vector<LatticePoint> points;
    const BuiltCell cell = half_turn(size, points);
    const CellBridges found = find_bridges(cell, kept, points);
    REQUIRE(found.bridges.size() == 1);
    CHECK(found.bridges[0].edge == Edge{0, 1});
    CHECK(found.bridges[0].ground[0].triangle == 0);
    CHECK(found.bridges[0].ground[1].triangle == 1);
    return found.bridges[0].pieces.size();
  };
  CHECK(pieces(4096, {0, 0, 0, 0, 0}) == 10);
  CHECK(pieces(4096, {1, 0, 0, 0, 1}) == 6);
  CHECK(pieces(4096, {1, 1, 0, 1, 1}) == 2);
  CHECK(pieces(4096, {1, 0, 1, 0, 1}) == 0);
  CHECK(pieces(4, {0, 0, 0, 0, 0}) == 0);
}

namespace {

/// Tetrahedra of the solid at an edge, in groups that hang together through triangles with it.
struct Wedges {
  std::size_t with_section = 0, without = 0;  ///< by whether a section triangle at the edge is theirs
  bool all_triangles = true;                  ///< every section triangle at the edge has a tetrahedron
};

Wedges wedges_at(const Edge& edge, const std::vector<Tet>& tets, const std::vector<Triangle>& section) {
  std::map<Triangle, std::vector<std::size_t>> at;
  for (std::size_t k = 0; k < tets.size(); ++k)
    for (unsigned i = 0; i < 4; ++i)
      if (const Triangle f = facet_of(tets[k], i); has(f, edge)) at[f].push_back(k);
  Groups groups(tets.size());
  for (const auto& [triangle, sides] : at) groups.put_together(sides.front(), sides.back());
  Wedges wedges;
  std::set<std::size_t> with;
  for (const Triangle& t : section) {
    if (at.count(t) == 0) {
      wedges.all_triangles = false;
    } else {
      with.insert(groups.of(at[t].front()));
    }
  }
  wedges.with_section = with.size();
  wedges.without = groups.count() - with.size();
  return wedges;
}

struct EdgeCounts {
  std::size_t inner = 0, pinched = 0, bare = 0, extra_wedges = 0;
};

/// Where there are tetrahedra at all, kept or not: cells of vertices in one plane have none.
std::set<Edge> edges_of_cells(const Shown& s) {
  std::set<Edge> edges;
  for (const BuiltCell& cell : s.cells)
    for (Tet tet : cell.complex.mesh.vertices) {
      for (std::uint32_t& v : tet) v = cell.vertices[v];
      for (unsigned e = 0; e < 6; ++e) edges.insert(edge_of(tet, e));
    }
  return edges;
}

EdgeCounts count_edges(const Shown& s) {
  std::map<Edge, std::vector<Tet>> tets;
  std::map<Edge, std::vector<Triangle>> section;
  const std::set<Edge> inner = s.inner_edges();
  for (const Tet& t : s.solid)
    for (unsigned e = 0; e < 6; ++e)
      if (inner.count(edge_of(t, e)) != 0) tets[edge_of(t, e)].push_back(t);
  s.for_section_triangles([&](const Triangle& t) {
    for (std::size_t k = 0; k < 3; ++k)
      if (const Edge e = ascending(Edge{t[k], t[(k + 1) % 3]}); inner.count(e) != 0) section[e].push_back(t);
  });
  EdgeCounts counts;
  for (const Edge& e : edges_of_cells(s)) {
    if (inner.count(e) == 0) continue;
    const Wedges w = wedges_at(e, tets[e], section[e]);
    ++counts.inner;
    counts.pinched += w.with_section == 1 && w.all_triangles ? 0U : 1U;
    counts.bare += w.all_triangles ? 0U : 1U;
    counts.extra_wedges += w.without;
  }
  return counts;
}

/// Section triangles with nothing on either side.
std::size_t bare_triangles(const Shown& s, const std::vector<Tet>& solid) {
  std::set<Triangle> covered;
  for (const Tet& t : solid)
    for (unsigned i = 0; i < 4; ++i) covered.insert(facet_of(t, i));
  std::size_t bare = 0;
  s.for_section_triangles([&](const Triangle& t) { bare += covered.count(t) == 0 ? 1U : 0U; });
  return bare;
}

/// The solid without bridges.
std::vector<Tet> solid_of_cells(const Shown& s) {
  std::vector<Tet> solid;
  for (std::size_t c = 0; c < s.cells.size(); ++c)
    for (std::size_t t = 0; t < s.kept[c].size(); ++t)
      if (s.kept[c][t] != 0) {
        Tet tet = s.cells[c].complex.mesh.vertices[t];
        for (std::uint32_t& v : tet) v = s.cells[c].vertices[v];
        solid.push_back(tet);
      }
  return solid;
}

/// Of all section triangles as a surface that may branch at lines: vertices are apart where triangles hang
/// together at them through no edge.
std::int64_t euler_of_sections(const Shown& s) {
  std::vector<Triangle> triangles;
  s.for_section_triangles([&](const Triangle& t) { triangles.push_back(t); });
  std::map<Edge, std::vector<std::size_t>> edges;
  std::map<std::uint32_t, std::vector<std::size_t>> at;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      edges[ascending(Edge{triangles[t][k], triangles[t][(k + 1) % 3]})].push_back(t);
      at[triangles[t][k]].push_back(t);
    }
  auto euler = static_cast<std::int64_t>(triangles.size()) - static_cast<std::int64_t>(edges.size());
  for (const auto& [vertex, here] : at) {
    Groups parts(here.size());
    for (std::size_t i = 0; i < here.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        std::size_t common = 0;
        for (const std::uint32_t v : triangles[here[i]])
          common +=
              static_cast<std::size_t>(std::count(triangles[here[j]].begin(), triangles[here[j]].end(), v));
        if (common == 2) parts.put_together(i, j);
      }
    euler += static_cast<std::int64_t>(parts.count());
  }
  return euler;
}

std::int64_t euler_of(const Surface& surface) {
  std::int64_t euler = 0;
  for (const ComponentReport& c : check_surface(surface).components) euler += c.euler;
  return euler;
}

/// Two planes full of bridges, and far below three that take branching samples: these give vertices new
/// numbers when the bridges above have been found.
Sections samples_elsewhere() {
  Sections sections = load("figures/fig18.contour");
  const auto row = [&](double z, std::initializer_list<double> at, double r, int corners) {
    PlaneSection plane = plane_at({0, 0, 1}, {0, 0, z});
    for (const double x : at) add_contour(plane, polygon({0, 0, 1}, {x, 0, z}, r, corners));
    sections.planes.push_back(plane);
  };
  row(-12, {0.1}, 1, 40);
  row(-11, {-1, 1}, 0.5, 24);
  row(-10, {0.1}, 1, 40);
  return sections;
}

/// Three circles on each of a few planes, which know nothing of each other: sections that contradict each
/// other on the lines, and slivers.
Sections rows_of_circles(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Sections sections;
  for (int p = 0; p < 4; ++p) {
    const Vec3 normal = random_vector(random);
    PlaneSection plane = plane_at(normal, 0.3 * random_vector(random));
    const Vec3 n = unit(normal), u = unit(cross(n, {0.3, 0.2, 1.1})), v = cross(n, u);
    const Vec3 origin = (-plane.offset / dot(normal, normal)) * normal;
    for (int k = -1; k < 2; ++k) {
      const Vec3 centre = origin + (2.0 * k + 0.3 * uniform(random)) * u + (0.3 * uniform(random)) * v;
      add_contour(plane,
                  polygon(normal, centre, 0.4 + 0.15 * uniform(random), 5 + static_cast<int>(random() % 12)));
    }
    sections.planes.push_back(plane);
  }
  return sections;
}

std::vector<Scene> larger_scenes() {
  std::vector<Scene> scenes = small_scenes();
  scenes.push_back({"samples elsewhere", samples_elsewhere()});
  const Surface ring = torus(1, 0.4, 30, 15);
  for (const std::uint64_t seed : {1u, 2u, 3u})
    scenes.push_back({"torus by 12, set " + std::to_string(seed), cut_randomly(ring, 12, seed)});
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    scenes.push_back(
        {"genus 2 by 16, set " + std::to_string(seed), cut_randomly(genus2_solid(20), 16, seed)});
    scenes.push_back({"vessel by 16, set " + std::to_string(seed), cut_randomly(vessel_solid(20), 16, seed)});
  }
  scenes.push_back({"trefoil by 14", cut_randomly(trefoil_solid(20), 14, 2)});
  scenes.push_back({"gyroid by 12", cut_randomly(gyroid_solid(16), 12, 2)});
  scenes.push_back({"shells by 10", cut_randomly(nested_shells(16), 10, 2)});
  for (const char* name :
       {"figures/fig14p.contour", "figures/fig16_one_two.contour", "figures/fig16_shift.contour",
        "figures/fig16_center.contour", "figures/fig17.contour", "figures/fig17_cross.contour",
        "figures/fig19.contour", "figures/fig20b.contour", "topology/dome.contour", "topology/tunnel.contour",
        "demo.contour"})
    scenes.push_back({name, load(name)});
  Options strict;
  strict.natural.join_confidence = 0.5;
  strict.branching.mode = Branching::off;
  for (const std::uint64_t seed : {3u, 5u})
    scenes.push_back({"shells by 3, few joins, set " + std::to_string(seed),
                      cut_randomly(nested_shells(14), 3, seed), strict});
  scenes.push_back({"genus 3 by 3", cut_randomly(genus3_solid(16), 3, 6)});
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u, 6u, 7u, 8u})
    scenes.push_back({"rows, seed " + std::to_string(seed), rows_of_circles(seed)});
  return scenes;
}

}  // namespace

TEST_CASE(
    "with bridges no edge in a section is pinched but the open ones, and no section with an edge is bare") {
  std::size_t bridges = 0, open = 0, fewer_bare = 0, extra = 0;
  for (const Scene& scene : larger_scenes()) {
    CAPTURE(scene.name);
    EdgeCounts edges;
    std::size_t bare = 0, bare_before = 0;
    const auto look = [&](const Shown& s) {
      edges = count_edges(s);
      bare = bare_triangles(s, s.solid);
      bare_before = bare_triangles(s, solid_of_cells(s));
    };
    const Reconstruction r = run(scene.sections, look, scene.options);
    const TopologyReport& t = r.report.topology;
    CHECK(edges.pinched == t.open_edges);
    CHECK(bare <= bare_before);
    CHECK((r.report.flat_area > 0) == (bare > 0));
    if (t.open_edges == 0) CHECK(edges.bare == 0);
    CHECK(check_surface(r.surface).good_topology());
    CHECK(check_surface(r.surface).crossings == 0);
    bridges += t.bridges;
    open += t.open_edges;
    extra += edges.extra_wedges;
    fewer_bare += bare_before - bare;
  }
  MESSAGE("bridges at " << bridges << " edges, open edges " << open << ", section triangles covered "
                        << fewer_bare << ", wedges on no section " << extra);
  CHECK(bridges > 150);
  CHECK(open > 0);
  CHECK(fewer_bare > 0);
  CHECK(extra > 0);
}

TEST_CASE("what the cells count is true of the result: its Euler characteristic is the sum of theirs") {
  std::size_t told = 0, with_bridges = 0;
  for (const Scene& scene : larger_scenes()) {
    CAPTURE(scene.name);
    std::int64_t expected = 0;
    const auto look = [&](const Shown& s) { expected = euler_of_sections(s); };
    const Reconstruction r = run(scene.sections, look, scene.options);
    CHECK(r.report.topology.handles == 0);
    for (const CellReport& c : r.report.cells)
      expected += std::int64_t{c.topology.bodies} + c.topology.outsides - 1 - c.topology.sections;
    // Crossings without partner break a section along a line that is no edge of a contour.
    if (r.report.topology.open_edges != 0 || r.report.flat_area > 0 || !r.report.unmatched.empty()) continue;
    CHECK(euler_of(r.surface) == 2 * expected);
    ++told;
    with_bridges += r.report.topology.bridges != 0 ? 1U : 0U;
  }
  CHECK(told >= 25);
  CHECK(with_bridges >= 8);
}

TEST_CASE("the U shapes of figure 18 and what the link joins are one body without a hole") {
  for (const char* name : {"figures/fig18.contour", "topology/link.contour"}) {
    CAPTURE(std::string(name));
    const Reconstruction r = run(load(name));
    CHECK(r.report.topology.open_edges == 0);
    CHECK(check_surface(r.surface).components.size() == 1);
    CHECK(check_surface(r.surface).genus == 0);
  }
}

TEST_CASE("bridges are for natural alone, and the same for any number of threads and order of the input") {
  for (const char* name : {"figures/fig18.contour", "figures/fig16_center.contour"}) {
    CAPTURE(std::string(name));
    Options joint;
    joint.mode = PruneMode::joint;
    CHECK(run(load(name), {}, joint).report.topology.bridges == 0);
    const Reconstruction one = run(load(name));
    CHECK(one.report.topology.bridges > 0);
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
      CAPTURE(seed);
      Context context;
      context.threads = 2;
      const auto two = reconstruct(shuffled(load(name), seed), {}, context);
      REQUIRE(two.ok());
      CHECK(hash(*two) == hash(one));
    }
  }
}
