#include "../../io/write_triangulation.h"

#include <random>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "../../io/byte_reader.h"
#include "../../io/read_mesh.h"
#include "../../io/token_reader.h"
#include "scratch.h"

using namespace crossloft;

namespace {

/// What a file of either format says, cells as lists of corners counted from 0.
struct Contents {
  std::vector<Vec3> points;
  std::vector<std::vector<std::uint32_t>> cells;
  std::vector<int> vtk_types;
};

/// Arrays of the appended block in the order that VTK asks for: points, corners, ends of cells, types.
Contents read_vtu(const std::string& bytes) {
  Contents contents;
  const std::string mark = "<AppendedData encoding=\"raw\">\n_";
  const std::size_t data = bytes.find(mark);
  REQUIRE(data != std::string::npos);
  ByteReader in(std::string_view(bytes).substr(data + mark.size()));
  contents.points.resize(in.read<std::uint64_t>() / 24);
  for (Vec3& p : contents.points) p.x = in.read<double>(), p.y = in.read<double>(), p.z = in.read<double>();
  std::vector<std::uint32_t> corners(in.read<std::uint64_t>() / 4);
  for (std::uint32_t& corner : corners) corner = in.read<std::uint32_t>();
  contents.cells.resize(in.read<std::uint64_t>() / 8);
  std::size_t begin = 0;
  for (auto& cell : contents.cells) {
    const auto end = static_cast<std::size_t>(in.read<std::int64_t>());
    REQUIRE((begin < end && end <= corners.size()));
    for (; begin < end; ++begin) cell.push_back(corners[begin]);
  }
  CHECK(begin == corners.size());
  contents.vtk_types.resize(in.read<std::uint64_t>());
  for (int& type : contents.vtk_types) type = in.read<std::uint8_t>();
  REQUIRE(in.ok());
  const std::string counts = "NumberOfPoints=\"" + std::to_string(contents.points.size()) +
                             "\" NumberOfCells=\"" + std::to_string(contents.cells.size()) + "\"";
  CHECK(bytes.find(counts) < data);
  return contents;
}

/// `section`, with cells of so many corners, is the only one but for the vertices.
Contents read_medit(const std::string& text, const std::string& section, std::size_t corners) {
  Contents contents;
  TokenReader in(text, "");
  for (const char* word : {"MeshVersionFormatted", "2", "Dimension", "3", "Vertices"})
    CHECK(in.token("") == word);
  contents.points.resize(in.count(""));
  for (Vec3& p : contents.points) {
    p = in.point("");
    CHECK(in.integer("") == 0);
  }
  if (!section.empty()) {
    CHECK(in.token("") == section);
    contents.cells.resize(in.count(""));
  }
  for (auto& cell : contents.cells) {
    for (std::size_t k = 0; k < corners; ++k) cell.push_back(in.count("") - 1);
    CHECK(in.integer("") == 1);
  }
  CHECK(in.token("") == "End");
  CHECK(in.at_end());
  REQUIRE(in.ok());
  return contents;
}

/// The cells of a triangulation, by its definition.
std::vector<std::vector<std::uint32_t>> cells_of(const Triangulation& t) {
  std::vector<std::vector<std::uint32_t>> cells;
  for (const auto& tet : t.tets.vertices) cells.emplace_back(tet.begin(), tet.end());
  for (const auto& triangle : t.triangles.vertices) cells.emplace_back(triangle.begin(), triangle.end());
  if (t.chain.size() == 1) cells.push_back({t.chain[0]});
  for (std::size_t i = 1; i < t.chain.size(); ++i) cells.push_back({t.chain[i - 1], t.chain[i]});
  return cells;
}

/// Points that span a space of this dimension, the last equal to the first, so that there is an unused one.
std::vector<Vec3> random_points(int dimension) {
  constexpr unsigned kSeed = 17;
  MESSAGE("seed " << kSeed);
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Vec3> points;
  for (int i = 0; i < 40; ++i) {
    const double a = coordinate(random), b = coordinate(random), c = coordinate(random);
    points.push_back({dimension > 0 ? a : 0.1, dimension > 1 ? b : 0.2, dimension > 2 ? c : 0.3});
  }
  points.push_back(points[0]);
  return points;
}

}  // namespace

TEST_CASE("triangulations of every dimension, all points with them") {
  const Scratch scratch;
  const std::string sections[] = {"", "Edges", "Triangles", "Tetrahedra"};
  const int types[] = {1, 3, 5, 10};
  for (int dimension = 0; dimension <= 3; ++dimension) {
    CAPTURE(dimension);
    const std::vector<Vec3> points = random_points(dimension);
    const Triangulation triangulation = delaunay_triangulation(points);
    REQUIRE(triangulation.dimension == dimension);
    const auto cells = cells_of(triangulation);
    CHECK((dimension == 0 ? cells.size() == 1 : cells.size() >= 39));

    REQUIRE(write_triangulation(scratch.path("a.vtu"), points, triangulation).ok());
    const Contents vtu = read_vtu(scratch.bytes("a.vtu"));
    CHECK(vtu.points == points);
    CHECK(vtu.cells == cells);
    const auto row = static_cast<std::size_t>(dimension);
    CHECK(vtu.vtk_types == std::vector<int>(cells.size(), types[row]));

    REQUIRE(write_triangulation(scratch.path("a.mesh"), points, triangulation).ok());
    const Contents medit = read_medit(scratch.bytes("a.mesh"), sections[row], row + 1);
    CHECK(medit.points == points);
    CHECK(medit.cells == (dimension > 0 ? cells : decltype(medit.cells){}));
  }
}

TEST_CASE("tetrahedra read back as a solid") {
  const Scratch scratch;
  const std::vector<Vec3> points = random_points(3);
  const Triangulation triangulation = delaunay_triangulation(points);
  for (const char* name : {"a.vtu", "a.mesh"}) {
    REQUIRE(write_triangulation(scratch.path(name), points, triangulation).ok());
    const auto solid = read_solid(scratch.path(name));
    REQUIRE(solid.ok());
    CHECK(solid->points == points);
    CHECK(solid->tets == triangulation.tets.vertices);
  }
}

TEST_CASE("triangles are no solid") {
  const Scratch scratch;
  const std::vector<Vec3> points = random_points(2);
  REQUIRE(write_triangulation(scratch.path("a.vtu"), points, delaunay_triangulation(points)).ok());
  CHECK(read_solid(scratch.path("a.vtu")).error().message == "a cell is no tetrahedron");
}

TEST_CASE("no points") {
  const Scratch scratch;
  const Triangulation none = delaunay_triangulation({});
  REQUIRE(write_triangulation(scratch.path("a.vtu"), {}, none).ok());
  CHECK(read_vtu(scratch.bytes("a.vtu")).cells.empty());
  REQUIRE(write_triangulation(scratch.path("a.mesh"), {}, none).ok());
  CHECK(read_medit(scratch.bytes("a.mesh"), "", 0).points.empty());
}

TEST_CASE("what is hidden is written too, and named by no cell") {
  const Scratch scratch;
  const std::vector<WeightedPoint> sites{
      {{0, 0, 0}}, {{4, 0, 0}}, {{0, 4, 0}}, {{1, 1, 1}, -100}, {{0, 0, 4}}};
  std::vector<Vec3> points;
  for (const WeightedPoint& site : sites) points.push_back(site.position);
  REQUIRE(write_triangulation(scratch.path("a.mesh"), points, regular_triangulation(sites)).ok());
  const Contents medit = read_medit(scratch.bytes("a.mesh"), "Tetrahedra", 4);
  CHECK(medit.points == points);
  REQUIRE(medit.cells.size() == 1);
  for (const std::uint32_t v : medit.cells[0]) CHECK(v != 3);
}

TEST_CASE("a triangulation that can't be written leaves no file") {
  const Scratch scratch;
  std::vector<Vec3> points = random_points(3);
  const Triangulation triangulation = delaunay_triangulation(points);
  CHECK(write_triangulation(scratch.path("a.ply"), points, triangulation).error().code == ErrorCode::usage);
  CHECK(write_triangulation(scratch.path("no/a.vtu"), points, triangulation).error().code ==
        ErrorCode::file_not_writable);
  points.resize(20);
  CHECK(write_triangulation(scratch.path("a.vtu"), points, triangulation).error().code ==
        ErrorCode::index_out_of_range);
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  const std::vector<Vec3> many(20000);
  CHECK(
      write_triangulation(scratch.path("a.vtu"), many, delaunay_triangulation(many), context).error().code ==
      ErrorCode::cancelled);
  CHECK(scratch.files() == 0);
}
