/// Points inside cells: what can be joined with them, and that they leave no trace elsewhere.

#include <cmath>
#include <utility>

#include "../../inspect/check.h"
#include "../../inspect/slice.h"
#include "../../inspect/solids.h"
#include "../../reconstruct/pipeline.h"
#include "scenes.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

Options dividing(bool look_around) {
  Options options;
  options.natural.look_around = look_around ? InCells::all : InCells::off;
  return options;
}

Sections cut(const Surface& mesh, std::uint32_t planes, std::uint64_t seed) {
  const auto sections = slice(mesh, random_planes(bounds_of(mesh.points), planes, seed));
  REQUIRE(sections.ok());
  return *sections;
}

PlaneSection plane(const Vec3& normal, const Vec3& point) {
  PlaneSection section;
  section.normal = normal;
  section.offset = -dot(normal, point);
  return section;
}

PlaneSection square(double z, double centre) {
  PlaneSection section = plane({0, 0, 1}, {0, 0, z});
  constexpr double kHalf = 20;
  section.vertices = {{centre - kHalf, -kHalf, z},
                      {centre + kHalf, -kHalf, z},
                      {centre + kHalf, kHalf, z},
                      {centre - kHalf, kHalf, z}};
  for (std::uint32_t i = 0; i < 4; ++i) section.edges.push_back({i, (i + 1) % 4, 1, 0, 0, 0});
  return section;
}

/// Small squares, `rows` times `rows`, on the plane { x_axis = 0 }.
PlaneSection squares(int axis, int rows) {
  PlaneSection section = plane(axis == 0 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, {0, 0, 0});
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < rows; ++j) {
      const double u = i + 0.5 - rows / 2.0 + 0.01 * (j % 3), z = j + 0.01 * (i % 4);
      const auto first = static_cast<std::uint32_t>(section.vertices.size());
      for (const auto& [du, dz] : {std::pair{-0.3, -0.3}, {0.3, -0.3}, {0.3, 0.3}, {-0.3, 0.3}})
        section.vertices.push_back(axis == 0 ? Vec3{0, u + du, z + dz} : Vec3{u + du, 0, z + dz});
      for (std::uint32_t k = 0; k < 4; ++k)
        section.edges.push_back({first + k, first + (k + 1) % 4, 1, 0, first / 4, 0});
    }
  return section;
}

}  // namespace

TEST_CASE("between many small sections of a cell no ways are looked for: a search for each takes time") {
  for (const int rows : {4, 12}) {
    CAPTURE(rows);
    Sections sections;
    sections.planes = {squares(0, rows), squares(1, rows)};
    const auto r = reconstruct(sections);
    REQUIRE(r.ok());
    CHECK((r->report.interior_points > 0) == (rows == 4));
    CHECK(check_surface(r->surface).good_topology());
  }
}

TEST_CASE("a torus that R1 cuts open is whole with points inside its cells") {
  const Sections sections = cut(torus(1, 0.4, 96, 48), 16, 7);
  Options whole;
  whole.natural.divide = InCells::off;
  const auto open = reconstruct(sections, whole), closed = reconstruct(sections, dividing(true));
  REQUIRE(open.ok());
  REQUIRE(closed.ok());
  CHECK(open->report.interior_points == 0);
  CHECK(closed->report.interior_points > 0);
  CHECK(check_surface(open->surface).genus == 0);
  const CheckReport report = check_surface(closed->surface);
  CHECK(report.good_topology());
  CHECK(report.genus == 1);
  CHECK(report.components.size() == 1);
  CHECK(closed->report.volume > open->report.volume);
}

TEST_CASE("where no planes meet in a cell, as in a stack, points inside come only if asked for") {
  const Surface mesh = torus(1, 0.4, 48, 24);
  const auto sections = slice(mesh, parallel_planes(bounds_of(mesh.points), 7, {1, 0.1, 0.2}));
  REQUIRE(sections.ok());
  Options off, all;
  off.natural.divide = off.natural.look_around = InCells::off;
  all.natural.divide = InCells::all;
  const auto by_default = reconstruct(*sections), without = reconstruct(*sections, off),
             with = reconstruct(*sections, all);
  REQUIRE(by_default.ok());
  REQUIRE(without.ok());
  REQUIRE(with.ok());
  CHECK(by_default->report.interior_points == 0);
  CHECK(hash(*by_default) == hash(*without));
  CHECK(with->report.interior_points > 0);
}

TEST_CASE("in a stack whose cells have points inside, samples over holes come first and points anew") {
  const Surface mesh = nested_shells(32);
  const auto sections = slice(mesh, parallel_planes(bounds_of(mesh.points), 16, {0.3, 0.5, 1}));
  REQUIRE(sections.ok());
  Options all;
  all.natural.divide = InCells::all;
  const auto r = reconstruct(*sections, all);
  REQUIRE(r.ok());
  CHECK(r->report.interior_points > 0);
  CHECK(r->report.branching_samples > 0);
  const CheckReport report = check_surface(r->surface);
  CHECK(report.good_topology());
  CHECK(report.crossings == 0);
  CHECK(report.genus == 0);
}

TEST_CASE("a cell that begins anew keeps nothing made of points inside, whose numbers are no one's then") {
  CellState cell;
  cell.inside.push_back({LatticePoint{}, 0});
  cell.interior = {4};
  cell.tets = {{0, 1, 2, 4}};
  cell.built.vertices = {0, 1, 2, 4};
  cell.bridges.bridges.push_back({{2, 4}, {}, {{0, 1, 2, 4}}, {}});
  cell.begin_anew();
  CHECK(cell.due);
  CHECK(cell.interior.empty());
  REQUIRE(cell.tets.empty());
  REQUIRE(cell.built.vertices.empty());
  REQUIRE(cell.bridges.bridges.empty());
  const std::vector<std::uint32_t> number{0, 2, 3, 5};
  cell.renumber(number);
}

TEST_CASE("points inside cells change no section") {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    CAPTURE(seed);
    const Sections sections = cut(genus2_solid(40), 24, seed);
    Options options = dividing(false);
    options.thicken = 1e-3;
    const auto whole = reconstruct(sections), divided = reconstruct(sections, options);
    REQUIRE(whole.ok());
    REQUIRE(divided.ok());
    CHECK(divided->report.interior_points > 0);
    CHECK(divided->report.topology.handles == 0);
    CHECK(check_surface(divided->surface).good_topology());
    CHECK(divided->report.section_area == whole->report.section_area);
    const SectionCheck check = check_sections(divided->surface, divided->sections);
    for (std::size_t p = 0; p < check.planes.size(); ++p)
      CHECK(check.planes[p].difference_area() <=
            divided->report.planes[p].flat_area + 1e-6 * divided->report.section_area);
  }
}

TEST_CASE("points inside cells: order and threads leave no trace, with samples too") {
  const Sections sections = cut(torus(1, 0.4, 48, 24), 14, 5);
  for (const Branching mode : {Branching::automatic, Branching::all, Branching::off}) {
    Options options = dividing(true);
    options.branching.mode = mode;
    options.branching.cutting = mode == Branching::off;
    const auto reference = reconstruct(sections, options);
    REQUIRE(reference.ok());
    CHECK(reference->report.interior_points > 0);
    for (std::uint64_t round = 0; round < 4; ++round) {
      Context context;
      context.threads = round % 2 == 0 ? 2 : 1;
      const auto r = reconstruct(shuffled(sections, 3 + round), options, context);
      REQUIRE(r.ok());
      CHECK(hash(*r) == hash(*reference));
    }
  }
}

TEST_CASE(
    "a narrow prism of empty planes across two squares: cells without any contour have confidences too") {
  constexpr double kShear = 2, kWide = 0.1;
  Sections sections;
  sections.planes = {square(0, 0),
                     square(1, kShear),
                     plane({1, 0, -kShear}, {-kWide, 0, 0}),
                     plane({1, 0, -kShear}, {kWide, 0, 0}),
                     plane({0, 1, 0}, {0, -kWide, 0}),
                     plane({0, 1, 0}, {0, 1.1 * kWide, 0})};
  for (const bool look_around : {false, true}) {
    const auto r = reconstruct(sections, dividing(look_around));
    REQUIRE(r.ok());
    CHECK(r->report.interior_points > 0);
    CHECK(check_surface(r->surface).good_topology());
    for (const CellReport& cell : r->report.cells)
      for (const JoinReport& join : cell.joins) CHECK(std::fabs(join.confidence) <= 1);
  }
}
