#include "../../io/write_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <doctest/doctest.h>

#include "../../io/read_mesh.h"
#include "scratch.h"

using namespace crossloft;

namespace {

std::vector<Vec3> random_points(std::size_t count) {
  constexpr unsigned kSeed = 3;
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-300, 300);
  const auto real = [&] { return std::ldexp(mantissa(random), exponent(random)); };
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = real(), y = real(), z = real();
    points.push_back({x, y, z});
  }
  // Copies, the extremes and both zeros.
  points[1] = points[0];
  points[2] = {std::numeric_limits<double>::max(), std::numeric_limits<double>::denorm_min(), -0.0};
  return points;
}

Surface random_surface() {
  Surface surface{random_points(200), {}};
  for (std::uint32_t i = 0; i + 7 < 200; ++i) surface.triangles.push_back({i, i + 7, i + 3});
  return surface;
}

Solid random_solid() {
  Solid solid{random_points(200), {}};
  for (std::uint32_t i = 0; i + 9 < 200; ++i) solid.tets.push_back({i, i + 9, i + 3, i + 1});
  return solid;
}

bool same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  if (a != b) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::signbit(a[i].z) != std::signbit(b[i].z)) return false;
  }
  return true;
}

const Surface kTetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.1}},
                           {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};

}  // namespace

TEST_CASE("PLY, OBJ and OFF keep all bits, copies and order") {
  const Scratch scratch;
  for (const Surface& surface : {random_surface(), kTetrahedron, Surface{}}) {
    for (const std::string name : {"a.ply", "a.obj", "a.off", "A.Ply"}) {
      CAPTURE(name);
      Heard heard;
      REQUIRE(write_surface(scratch.path(name), surface, heard.context()).ok());
      CHECK(heard.warnings.empty());
      const Result<Surface> again = read_surface(scratch.path(name));
      REQUIRE(again.ok());
      CHECK(same_bits(again->points, surface.points));
      CHECK(again->triangles == surface.triangles);
    }
  }
}

TEST_CASE("STL rounds to float, warns, and gives the same triangles") {
  const Scratch scratch;
  Heard heard;
  REQUIRE(write_surface(scratch.path("a.stl"), kTetrahedron, heard.context()).ok());
  CHECK(heard.warnings.size() == 1);
  CHECK(scratch.bytes("a.stl").size() == 84 + 50 * 4);
  const Result<Surface> again = read_surface(scratch.path("a.stl"));
  REQUIRE(again.ok());
  CHECK(again->points.size() == 4);
  CHECK(again->triangles.size() == 4);
  CHECK(again->points[3].z == static_cast<double>(0.1f));
}

TEST_CASE("the layout of PLY, OBJ and OFF") {
  const Scratch scratch;
  const Surface triangle{{{0, 0, 0}, {1e-7, 0, 0}, {0, 0.1, -3}}, {{0, 1, 2}}};
  REQUIRE(write_surface(scratch.path("a.ply"), triangle).ok());
  const std::string ply = scratch.bytes("a.ply");
  CHECK(ply.starts_with("ply\nformat binary_little_endian 1.0\n"));
  CHECK(ply.find("property double x\n") != std::string::npos);
  CHECK(ply.size() == ply.find("end_header\n") + 11 + 3 * 24 + 13);
  REQUIRE(write_surface(scratch.path("a.obj"), triangle).ok());
  CHECK(scratch.bytes("a.obj") == "# Crossloft\nv 0 0 0\nv 1e-07 0 0\nv 0 0.1 -3\nf 1 2 3\n");
  REQUIRE(write_surface(scratch.path("a.off"), triangle).ok());
  CHECK(scratch.bytes("a.off") == "OFF\n3 1 0\n0 0 0\n1e-07 0 0\n0 0.1 -3\n3 0 1 2\n");
}

TEST_CASE(".vtu and .mesh keep all bits and order") {
  const Scratch scratch;
  for (const Solid& solid : {random_solid(), Solid{}}) {
    for (const std::string name : {"a.vtu", "a.mesh"}) {
      CAPTURE(name);
      REQUIRE(write_solid(scratch.path(name), solid).ok());
      const Result<Solid> again = read_solid(scratch.path(name));
      REQUIRE(again.ok());
      CHECK(same_bits(again->points, solid.points));
      CHECK(again->tets == solid.tets);
    }
  }
}

TEST_CASE("a .vtu that is damaged or cut off is an error") {
  const Scratch scratch;
  REQUIRE(write_solid(scratch.path("a.vtu"), random_solid()).ok());
  const std::string good = scratch.bytes("a.vtu");
  for (std::size_t size = 0; size < good.size() - 200; size += 97)
    CHECK_FALSE(parse_vtu(good.substr(0, size), "").ok());
  std::mt19937 random(5);
  for (int round = 0; round < 2000; ++round) {
    std::string bytes = good;
    bytes[random() % (round % 2 == 0 ? 1000 : bytes.size())] = static_cast<char>(random() % 256);
    const Result<Solid> read = parse_vtu(bytes, "");
    if (!read.ok()) continue;
    for (const auto& tet : read->tets)
      CHECK(std::max({tet[0], tet[1], tet[2], tet[3]}) < read->points.size());
  }
}

TEST_CASE("what can't be written leaves no file") {
  const Scratch scratch;
  CHECK(write_surface(scratch.path("a.vtu"), kTetrahedron).error().code == ErrorCode::usage);
  CHECK(write_surface(scratch.path("ply"), kTetrahedron).error().code == ErrorCode::usage);
  CHECK(write_solid(scratch.path("a.ply"), Solid{}).error().code == ErrorCode::usage);
  Surface dangling = kTetrahedron;
  dangling.triangles.push_back({0, 1, 4});
  CHECK(write_surface(scratch.path("a.ply"), dangling).error().code == ErrorCode::index_out_of_range);
  CHECK(write_solid(scratch.path("a.mesh"), {{{0, 0, 0}}, {{0, 0, 0, 1}}}).error().code ==
        ErrorCode::index_out_of_range);
  CHECK(write_surface(scratch.path("no/a.ply"), kTetrahedron).error().code == ErrorCode::file_not_writable);
  CHECK(scratch.files() == 0);
}

TEST_CASE("a cancelled write leaves the old file and no other") {
  const Scratch scratch;
  scratch.add("a.ply", "old");
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  Surface large{std::vector<Vec3>(20000), {}};
  CHECK(write_surface(scratch.path("a.ply"), large, context).error().code == ErrorCode::cancelled);
  CHECK(scratch.bytes("a.ply") == "old");
  CHECK(scratch.files() == 1);
}
