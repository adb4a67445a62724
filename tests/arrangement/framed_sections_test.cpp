#include "../../arrangement/framed_sections.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <random>

#include "../../arrangement/data_box.h"
#include "../../geom/frame.h"
#include "polygon_sections.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

/// What the contract promises of every result.
void verify(const FramedSections& f) {
  for (std::size_t i = 0; i < f.planes.size(); ++i) {
    const FramedPlane& p = f.planes[i];
    REQUIRE(p.input.size() == p.vertices.size());
    REQUIRE_FALSE(p.sources.empty());
    CHECK(cross(p.plane.e1, p.plane.e2) == p.plane.normal);
    for (std::size_t v = 0; v < p.vertices.size(); ++v) {
      CHECK(p.vertices[v].is_explicit());
      CHECK(side_of_plane(p.plane, p.vertices[v]) == 0);
      if (v > 0) CHECK(compare_lex(p.vertices[v - 1], p.vertices[v]) < 0);
      const Vec3 way = Vec3{p.vertices[v].x, p.vertices[v].y, p.vertices[v].z} - f.grid.scaled(p.input[v]);
      CHECK(norm(way) * f.grid.unit() <= p.displacement);
    }
    std::vector<int> degree(p.vertices.size());
    for (std::size_t w = 0; w < p.walls.size(); ++w) {
      CHECK(p.walls[w].a < p.walls[w].b);
      if (w > 0) CHECK(std::pair(p.walls[w - 1].a, p.walls[w - 1].b) < std::pair(p.walls[w].a, p.walls[w].b));
      ++degree[p.walls[w].a], ++degree[p.walls[w].b];
    }
    for (const int d : degree) CHECK((d >= 2 && d % 2 == 0));
    if (i > 0) CHECK_FALSE(same_plane(f.planes[i - 1].plane, p.plane));
  }
}

FramedSections framed(const Sections& in) {
  Result<FramedSections> r = frame_sections(in, 1e-3);
  if (!r) FAIL(to_string(r.error()));
  verify(*r);
  return std::move(*r);
}

ErrorCode error_of(const Sections& in, double tolerance = 1e-3) {
  const Result<FramedSections> r = frame_sections(in, tolerance);
  REQUIRE_FALSE(r.ok());
  return r.error().code;
}

/// Everything that must not depend on the order of the input, as numbers.
std::vector<double> geometry_of(const FramedSections& f) {
  std::vector<double> out{f.diagonal, f.grid.unit()};
  for (const FramedPlane& p : f.planes) {
    for (const LatticeVector* v : {&p.plane.origin, &p.plane.e1, &p.plane.e2, &p.plane.normal})
      for (const std::int64_t c : *v) out.push_back(static_cast<double>(c));
    for (const LatticePoint& v : p.vertices) out.insert(out.end(), {v.x, v.y, v.z});
    for (const Vec3& v : p.input) out.insert(out.end(), {v.x, v.y, v.z});
    for (const WallEdge& w : p.walls) out.insert(out.end(), {double(w.a), double(w.b)});
    out.insert(out.end(), {p.displacement, p.off_plane});
  }
  return out;
}

Sections random_disks(std::uint64_t seed, int count) {
  std::mt19937_64 random(seed);
  Sections in{"random", {}};
  for (int i = 0; i < count; ++i)
    in.planes.push_back(disk(random_vector(random), random_vector(random), 1, 17));
  return in;
}

/// The same data told differently.
Sections retold(Sections in, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::shuffle(in.planes.begin(), in.planes.end(), random);
  for (PlaneSection& p : in.planes) {
    const double factor = random() % 2 ? -4 : 0.125;
    p.normal = factor * p.normal, p.offset *= factor;
    std::vector<std::uint32_t> to(p.vertices.size());
    for (std::uint32_t v = 0; v < to.size(); ++v) to[v] = v;
    std::shuffle(to.begin(), to.end(), random);
    std::vector<Vec3> moved(to.size());
    for (std::size_t v = 0; v < to.size(); ++v) moved[to[v]] = p.vertices[v];
    p.vertices = std::move(moved);
    for (ContourEdge& e : p.edges) {
      e.a = to[e.a], e.b = to[e.b];
      if (random() % 2) std::swap(e.a, e.b), std::swap(e.material_a, e.material_b);
    }
    std::shuffle(p.edges.begin(), p.edges.end(), random);
  }
  return in;
}

double largest_displacement(const FramedSections& f) {
  double d = 0;
  for (const FramedPlane& p : f.planes) d = std::max(d, p.displacement);
  return d / f.diagonal;
}

}  // namespace

TEST_CASE("axis planes with dyadic data come out exactly") {
  Sections in{"axis", {}};
  for (const Vec3 n : {Vec3{1, 0, 0}, Vec3{0, -3, 0}, Vec3{0, 0, 1}})
    for (const double t : {-0.5, 0.0, 0.3125}) {
      PlaneSection p = plane_at(n, t * unit(n));
      std::vector<Vec3> points;
      for (Vec3 v : square(0.25, 0, t, 1)) {
        if (n.x != 0) v = {v.z, v.x, v.y};
        if (n.y != 0) v = {v.x, -v.z, v.y};
        points.push_back(v);
      }
      add_contour(p, points);
      in.planes.push_back(p);
    }
  const FramedSections f = framed(in);
  REQUIRE(f.planes.size() == 9);
  CHECK(largest_displacement(f) == 0);
  for (const FramedPlane& p : f.planes) {
    const auto& [x, y, z] = p.plane.normal;
    CHECK(std::llabs(x) + std::llabs(y) + std::llabs(z) == 1);
    for (std::size_t v = 0; v < p.vertices.size(); ++v)
      CHECK(f.grid.from_lattice(p.vertices[v]) == p.input[v]);
  }
}

TEST_CASE("random planes: canonical, displaced by little") {
  const Sections in = random_disks(1, 12);
  const FramedSections f = framed(in);
  REQUIRE(f.planes.size() == 12);
  CHECK(largest_displacement(f) < 1e-10);
  const std::vector<double> geometry = geometry_of(f);
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Sections other = retold(in, seed);
    const FramedSections g = framed(other);
    CHECK(geometry_of(g) == geometry);
    for (std::size_t i = 0; i < f.planes.size(); ++i)
      CHECK(other.planes[g.planes[i].sources[0]].vertices.size() ==
            in.planes[f.planes[i].sources[0]].vertices.size());
  }
}

TEST_CASE("normals of any length mean the same plane") {
  Sections in = random_disks(2, 8);
  const std::vector<double> geometry = geometry_of(framed(in));
  for (PlaneSection& p : in.planes) p.normal = 3 * p.normal, p.offset *= 3;
  std::vector<double> other = geometry_of(framed(in));
  // The distance from the file's plane is told of the file's own rounded numbers.
  CHECK(other.size() == geometry.size());
  for (std::size_t i = 0; i < std::min(other.size(), geometry.size()); ++i)
    CHECK(std::fabs(other[i] - geometry[i]) <= 1e-12);
}

TEST_CASE("normals of different length make parallel planes, in any order") {
  std::mt19937_64 random(12);
  for (int trial = 0; trial < 50; ++trial) {
    const Vec3 n = unit(random_vector(random));
    Sections in{"lengths", {}};
    for (const double factor : {1.0, 3.0, -3.0, 0.7}) {
      PlaneSection plane = disk(n, static_cast<double>(in.planes.size()) * n, 1, 5);
      plane.normal = factor * plane.normal, plane.offset *= factor;
      in.planes.push_back(plane);
    }
    const FramedSections f = framed(in);
    REQUIRE(f.planes.size() == 4);
    for (const FramedPlane& p : f.planes) CHECK(p.plane.normal == f.planes[0].plane.normal);
    std::reverse(in.planes.begin(), in.planes.end());
    CHECK(geometry_of(framed(in)) == geometry_of(f));
  }
}

TEST_CASE("planes tilted by a hair stay near their data") {
  for (const double tilt : {1e-3, 1e-5, 1e-7, 1e-8, 1e-10, 1e-13}) {
    CAPTURE(tilt);
    Sections in{
        "tilted",
        {disk({tilt, tilt / 3, 1}, {0, 0, 0}), disk({0, 0, 1}, {0, 0, 1}), disk({1, 0, -tilt}, {0, 0, 0})}};
    const FramedSections f = framed(in);
    CHECK(f.planes.size() == 3);
    CHECK(largest_displacement(f) < 4e-7);
  }
}

TEST_CASE("scales from 1e-12 to 1e12, and far beyond") {
  for (const double scale : {0x1p-900, 0x1p-40, 0x1p40, 0x1p900}) {
    CAPTURE(scale);
    Sections in = random_disks(3, 5);
    const std::vector<LatticePoint> plain = framed(in).planes[2].vertices;
    for (PlaneSection& p : in.planes) {
      p.offset *= scale;
      for (Vec3& v : p.vertices) v = scale * v;
    }
    const FramedSections f = framed(in);
    REQUIRE(f.planes[2].vertices.size() == plain.size());
    for (std::size_t v = 0; v < plain.size(); ++v) CHECK(equal(f.planes[2].vertices[v], plain[v]));
  }
}

TEST_CASE("data far from the origin") {
  Sections in = random_disks(4, 5);
  for (PlaneSection& p : in.planes) {
    for (Vec3& v : p.vertices) v = v + Vec3{4096, 0, 0};
    p.offset -= 4096 * p.normal.x;
  }
  const FramedSections f = framed(in);
  CHECK(largest_displacement(f) < 1e-10);
  CHECK(std::any_of(f.notes.begin(), f.notes.end(),
                    [](auto& n) { return n.find("far from the origin") != n.npos; }));
}

TEST_CASE("the planes of a pencil share two lattice points") {
  std::mt19937_64 random(21);
  const Vec3 axis = random_vector(random), centre = 0.1 * random_vector(random);
  Sections in{"pencil", {}};
  for (int i = 0; i < 8; ++i) in.planes.push_back(disk(cross(axis, random_vector(random)), centre));
  in.planes.push_back(disk(axis, centre + 0.3 * unit(axis)));
  const FramedSections f = framed(in);
  CHECK(f.pencils == 1);
  CHECK(largest_displacement(f) < 2e-8);
  std::vector<const FramedPlane*> members;
  for (const FramedPlane& p : f.planes)
    if (p.sources[0] < 8) members.push_back(&p);
  LatticeVector direction;
  REQUIRE(axis_of(members[0]->plane, members[1]->plane, direction));
  for (std::size_t k = 2; k < members.size(); ++k)
    CHECK(share_line(members[0]->plane, members[1]->plane, members[k]->plane));
  CHECK(geometry_of(framed(retold(in, 5))) == geometry_of(f));
}

TEST_CASE("half turns about a coordinate axis keep it, whatever crosses it") {
  Sections in{"rotational", {}};
  for (int i = 0; i < 9; ++i) {
    const double t = 3.141592653589793 * i / 9;
    in.planes.push_back(disk({std::cos(t), std::sin(t), 0}, {0, 0, 0}));
  }
  for (const double z : {-0.4, 0.1, 0.5}) in.planes.push_back(disk({0, 0, 1}, {0, 0, z}));
  const FramedSections f = framed(in);
  CHECK(f.pencils == 1);
  CHECK(f.common_points == 0);
  CHECK(largest_displacement(f) < 1e-10);
}

TEST_CASE("planes through one point meet exactly") {
  std::mt19937_64 random(23);
  const Vec3 centre{0.1, 0.2, 0.3};
  Sections in{"star", {}};
  for (int i = 0; i < 6; ++i) {
    const Vec3 n = random_vector(random);
    in.planes.push_back(disk(n, centre + 0.2 * unit(cross(n, {1, 2, 3}))));
  }
  const FramedSections f = framed(in);
  CHECK(f.common_points == 1);
  CHECK(largest_displacement(f) < 2e-10);
  LatticePointStore store;
  LatticePoint x;
  REQUIRE(store.meet(f.planes[0].plane, f.planes[1].plane, f.planes[2].plane, x));
  for (const FramedPlane& p : f.planes) CHECK(side_of_plane(p.plane, x) == 0);
}

TEST_CASE("two pencils with crossing axes are kept with their point") {
  std::mt19937_64 random(25);
  const Vec3 centre{0.1, 0.2, 0.3};
  Sections in{"crossing axes", {}};
  for (const Vec3 axis : {Vec3{0.1, 0.7, 0.3}, Vec3{-0.2, 0.1, 0.9}})
    for (int i = 0; i < 3; ++i) in.planes.push_back(disk(cross(axis, random_vector(random)), centre));
  const FramedSections f = framed(in);
  CHECK(f.pencils == 2);
  CHECK(f.common_points == 1);
  CHECK(largest_displacement(f) < 2e-8);
}

TEST_CASE("small integer planes keep all they share by themselves") {
  Sections in{"cube diagonals",
              {}};  // the nine mirror planes of a cube: pencils of 4, 3 and 2 about one point
  for (const Vec3 n : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{1, 1, 0}, Vec3{1, -1, 0},
                       Vec3{1, 0, 1}, Vec3{1, 0, -1}, Vec3{0, 1, 1}, Vec3{0, 1, -1}})
    in.planes.push_back(disk(n, {0.5, 0.25, -1}));
  const FramedSections f = framed(in);
  CHECK(f.pencils == 7);  // three of four planes, four of three
  for (const FramedPlane& p : f.planes)
    for (const std::int64_t c : p.plane.normal) CHECK(std::llabs(c) <= 1);
}

TEST_CASE("equal planes become one") {
  Sections in{"equal",
              {plane_at({0, 0, 1}, {0, 0, 0}), plane_at({0, 0, -5}, {0, 0, 0}), disk({1, 0, 0}, {0, 0, 0})}};
  SUBCASE("with disjoint sections") {
    add_contour(in.planes[0], square(-2, 0, 0, 1));
    add_contour(in.planes[1], square(2, 0, 0, 1));
    const FramedSections f = framed(in);
    REQUIRE(f.planes.size() == 2);
    CHECK(f.planes[0].sources == std::vector<std::uint32_t>{0, 1});
    CHECK(f.planes[0].walls.size() == 8);
    CHECK(f.notes.size() == 1);
  }
  SUBCASE("with a section in the other's hole") {
    add_contour(in.planes[0], square(0, 0, 0, 3), 0);
    add_contour(in.planes[0], square(0, 0, 0, 2), 1);
    add_contour(in.planes[1], square(0, 0, 0, 1));
    CHECK(framed(in).planes[0].walls.size() == 12);
  }
  SUBCASE("with sections that touch along an edge") {
    add_contour(in.planes[0], square(-1, 0, 0, 1));
    add_contour(in.planes[1], square(1, 0, 0, 1));
    CHECK(framed(in).planes[0].walls.size() == 6);
  }
  SUBCASE("with equal sections") {
    add_contour(in.planes[0], square(0, 0, 0, 1));
    add_contour(in.planes[1], square(0, 0, 0, 1));
    for (Vec3& v : in.planes[1].vertices) v.x += 1e-10;
    CHECK(framed(in).planes[0].walls.size() == 4);
  }
  SUBCASE("with equal sections of different vertices") {
    add_contour(in.planes[0], square(0, 0, 0, 1));
    std::vector<Vec3> points = square(0, 0, 0, 1);
    points.insert(points.begin() + 1, Vec3{0, -1, 0});
    add_contour(in.planes[1], points);
    CHECK(framed(in).planes[0].walls.size() >= 4);
  }
  SUBCASE("one of them empty") {
    add_contour(in.planes[1], square(0, 0, 0, 1));
    CHECK(framed(in).planes[0].walls.size() == 4);
  }
  SUBCASE("contradicting") {
    add_contour(in.planes[0], square(0, 0, 0, 1));
    SUBCASE("crossing") { add_contour(in.planes[1], square(0.5, 0.5, 0, 1)); }
    SUBCASE("inside") { add_contour(in.planes[1], square(0, 0, 0, 0.5)); }
    SUBCASE("around") { add_contour(in.planes[1], square(0, 0, 0, 1.5)); }
    SUBCASE("across") { add_contour(in.planes[1], {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}}); }
    CHECK(error_of(in) == ErrorCode::contradicting_planes);
  }
  const Sections other = retold(in, 3);
  const auto r = frame_sections(in, 1e-3), s = frame_sections(other, 1e-3);
  CHECK(r.ok() == s.ok());
  if (r && s) CHECK(geometry_of(*r) == geometry_of(*s));
}

TEST_CASE("planes without contour: kept near the data, left out far away") {
  Sections in{"empty",
              {disk({0, 0, 1}, {0, 0, 0}), plane_at({0, 0, 1}, {0, 0, 0.5}), plane_at({1, 1, 1}, {9, 9, 9}),
               plane_at({1e-300, 0, 0}, {1e300, 0, 0})}};
  const FramedSections f = framed(in);
  CHECK(f.planes.size() == 2);
  CHECK(f.notes.size() == 2);
  Sections none{"none", {plane_at({0, 0, 1}, {0, 0, 0})}};
  const FramedSections g = framed(none);
  CHECK(g.planes.empty());
  CHECK(g.warnings.size() == 1);
}

TEST_CASE("a part has the box of the whole") {
  std::mt19937_64 random(11);
  for (int trial = 0; trial < 20; ++trial) {
    const Vec3 normal = unit(random_vector(random));
    Sections in{"stack", {}}, part{"stack", {}, PartOf{}};
    for (int p = 0; p < 6; ++p) in.planes.push_back(disk(normal, 0.3 * p * normal, 1, 40));
    for (std::uint32_t p = 2; p < 5; ++p) {
      part.planes.push_back(in.planes[p]);
      part.part_of->positions.push_back(p);
    }
    for (const PlaneSection& p : in.planes)
      for (const Vec3& v : p.vertices) part.part_of->extent.add(v), part.part_of->wide.add(v);
    const LatticeBox whole = data_box(framed(in)), of_part = data_box(framed(part));
    CHECK(whole.lower == of_part.lower);
    CHECK(whole.upper == of_part.upper);
  }
}

TEST_CASE("bad input and a raised flag") {
  Sections in = random_disks(6, 3);
  CHECK(error_of(in, 0.2) == ErrorCode::usage);
  CHECK(error_of(in, -1) == ErrorCode::usage);
  in.planes[1].vertices[3] = in.planes[1].vertices[3] + 0.1 * in.planes[1].normal;
  CHECK(error_of(in) == ErrorCode::off_plane);
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  const Result<FramedSections> r = frame_sections(random_disks(6, 3), 1e-3, context);
  REQUIRE_FALSE(r.ok());
  CHECK(r.error().code == ErrorCode::cancelled);
}
