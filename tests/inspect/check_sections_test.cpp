#include <doctest/doctest.h>

#include <cmath>

#include "../../inspect/check.h"
#include "../../inspect/slice.h"
#include "shapes.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

Sections sliced(const Surface& mesh, const std::vector<CuttingPlane>& planes) {
  Result<Sections> result = slice(mesh, planes);
  REQUIRE(result.ok());
  return *result;
}

PlaneSection square(double z, double low, double high) {
  PlaneSection s;
  s.normal = {0, 0, 1};
  s.offset = -z;
  s.vertices = {{low, low, z}, {high, low, z}, {high, high, z}, {low, high, z}};
  for (std::uint32_t k = 0; k < 4; ++k) s.edges.push_back({k, (k + 1) % 4, 1, 0, 0, 0});
  return s;
}

PlaneCheck check_one(const Surface& mesh, const PlaneSection& section) {
  Sections sections;
  sections.planes.push_back(section);
  return check_sections(mesh, sections).planes[0];
}

}  // namespace

TEST_CASE("triangles that name a point that is not there are left out") {
  Surface mesh = cube();
  mesh.triangles.push_back({0, 1, 4000000000u});
  CHECK(check_one(mesh, square(0, 0, 1)).difference_area() < 1e-14);
}

TEST_CASE("the length of normals does not count") {
  const Surface mesh = cube();
  for (const double scale : {1e-320, 1e-200, -1e-165, 1e155, 1.5e308}) {
    CAPTURE(scale);
    PlaneSection half = square(0.5, 0, 0.5);
    half.normal = scale * half.normal;
    half.offset *= scale;
    const PlaneCheck r = check_one(mesh, half);
    CHECK(r.section_area == doctest::Approx(0.25));
    CHECK(r.extra_area == doctest::Approx(0.75));
    CHECK(r.distance == doctest::Approx(std::sqrt(0.5)));
  }
}

TEST_CASE("a mesh agrees with its own slices to rounding") {
  const Surface mesh = torus(1, 0.4, 80, 40);
  const Bounds box = bounds_of(mesh.points);
  for (const auto& planes : {random_planes(box, 10, 1), rotational_planes(box, 5), parallel_planes(box, 7)}) {
    const Sections sections = sliced(mesh, planes);
    const SectionCheck strict = check_sections(mesh, sections, {1e-12}), r = check_sections(mesh, sections);
    CHECK(r.planes.size() == planes.size());
    CHECK(strict.section_area > 0.5);
    CHECK(strict.difference_area() < 1e-13);
    CHECK(strict.distance < 1e-12);
    CHECK(r.difference_area() < 1e-5);  // vertices near a plane by chance count as on it
    CHECK(r.distance < 1e-4);
  }
}

TEST_CASE("regions with solid on one side only belong to the cross-section") {
  for (const double z : {0.0, 1.0}) {
    const PlaneCheck r = check_one(cube(), square(z, 0, 1));
    CHECK(r.surface_area == doctest::Approx(1));
    CHECK(r.section_area == doctest::Approx(1));
    CHECK(r.difference_area() < 1e-14);
    CHECK(r.distance < 1e-14);
  }
}

TEST_CASE("a step: below the plane all of it, above only half, which leaves no inner boundary") {
  Surface mesh = cube();
  append(mesh, moved(cube(), {0.5, 0, 1}));
  append(mesh, moved(cube(), {-0.5, 0, 1}));
  const PlaneCheck r = check_one(mesh, square(1, 0, 1));
  CHECK(r.surface_area == doctest::Approx(2));
  CHECK(r.extra_area == doctest::Approx(1));
  CHECK(r.missing_area < 1e-14);
  CHECK(r.distance == doctest::Approx(0.5));
  Surface half = cube();
  Surface top = moved(cube(), {0, 0, 1});
  for (Vec3& p : top.points) p.x *= 0.5;
  append(half, top);
  CHECK(check_one(half, square(1, 0, 1)).difference_area() < 1e-14);
  CHECK(check_one(half, square(1, 0, 1)).distance < 1e-14);
}

TEST_CASE("vertices off the plane by less than the tolerance count as on it") {
  Surface mesh = cube();
  for (std::size_t k = 4; k < 8; ++k) mesh.points[k].z += k % 2 == 0 ? 1e-7 : -1e-7;
  const PlaneCheck r = check_one(mesh, square(1, 0, 1));
  CHECK(r.difference_area() < 1e-14);
  CHECK(r.off_plane == doctest::Approx(1e-7));
}

TEST_CASE("missing and extra areas and the distance are measured") {
  const PlaneCheck smaller = check_one(cube(), square(0.5, 0.25, 0.75));
  CHECK(smaller.extra_area == doctest::Approx(0.75));
  CHECK(smaller.missing_area == 0);
  CHECK(smaller.distance == doctest::Approx(std::sqrt(2.0) / 4));
  const PlaneCheck shifted = check_one(moved(cube(), {0.25, 0, 0}), square(0.5, 0, 1));
  CHECK(shifted.extra_area == doctest::Approx(0.25));
  CHECK(shifted.missing_area == doctest::Approx(0.25));
  CHECK(shifted.distance == doctest::Approx(0.25));
  const PlaneCheck gone = check_one(cube(), square(5, 0, 1));
  CHECK(gone.surface_area == 0);
  CHECK(gone.missing_area == doctest::Approx(1));
  CHECK(std::isinf(gone.distance));
  PlaneSection empty = square(5, 0, 1);
  empty.edges.clear();
  CHECK(check_one(cube(), empty).distance == 0);
}

TEST_CASE("sections at sizes where areas are infinite or 0 are judged like any") {
  PlaneSection met = square(0.5, 0.5, 1), beyond = square(5, 0, 1);
  for (const int exponent : {-1000, -560, -530, -300, 0, 300, 520, 600, 1000}) {
    CAPTURE(exponent);
    Sections sections{"", {met, beyond}};
    for (PlaneSection& s : sections.planes) {
      s.offset = std::ldexp(s.offset, exponent);
      for (Vec3& v : s.vertices) v = scaled(v, exponent);
    }
    const SectionCheck r = check_sections(scaled(cube(), exponent), sections);
    CHECK(r.missing_share == doctest::Approx(1 / 1.25));
    CHECK(r.extra_share == doctest::Approx(0.75 / 1.25));
    CHECK(r.planes[0].distance == doctest::Approx(std::ldexp(std::sqrt(0.5), exponent)));
    CHECK(r.planes[0].extra_area == std::ldexp(check_one(cube(), met).extra_area, 2 * exponent));
    CHECK(std::isinf(r.planes[1].distance));
  }
  CHECK(check_sections(cube(), {"", {}}).extra_share == 0);
}

TEST_CASE("a point of no triangle does not make all near a plane") {
  Surface mesh = cube();
  mesh.points.push_back({1e14, 0, 0});
  const PlaneCheck r = check_one(mesh, square(0.5, 0, 1));
  CHECK(r.surface_area == doctest::Approx(1));
  CHECK(r.difference_area() < 1e-14);
}

TEST_CASE("crossing outlines have exact areas") {
  PlaneSection diamond = square(0.5, 0, 1);
  diamond.vertices = {{0.5, -0.5, 0.5}, {1.5, 0.5, 0.5}, {0.5, 1.5, 0.5}, {-0.5, 0.5, 0.5}};
  const PlaneCheck r = check_one(cube(), diamond);
  CHECK(r.section_area == doctest::Approx(2));
  CHECK(r.missing_area == doctest::Approx(1));
  CHECK(r.extra_area < 1e-14);
}

TEST_CASE("materials and doubled edges: even-odd over walls only") {
  PlaneSection s = square(0.5, 0, 1);
  s.vertices.push_back({0.5, 0, 0.5});
  s.vertices.push_back({0.5, 1, 0.5});
  s.edges.push_back({4, 5, 1, 2, 1, 0});  // between two materials
  s.edges.push_back({4, 5, 1, 0, 2, 0});
  s.edges.push_back({5, 4, 1, 0, 3, 0});  // cancels
  const PlaneCheck r = check_one(cube(), s);
  CHECK(r.section_area == doctest::Approx(1));
  CHECK(r.difference_area() < 1e-14);
  CHECK(r.distance < 1e-14);
}

namespace {

SectionCheck check_framed(const Surface& mesh, const Sections& sections) {
  const auto check = check_framed_sections(mesh, sections);
  REQUIRE(check.ok());
  return *check;
}

PlaneSection moved(PlaneSection section, const Vec3& by) {
  for (Vec3& v : section.vertices) v = v + by;
  section.offset -= dot(section.normal, by);
  return section;
}

}  // namespace

TEST_CASE("records of one plane are one section, as reconstruct has it") {
  Surface mesh = cube();
  append(mesh, moved(cube(), {3, 0, 0}));
  const Sections sections{"",
                          {square(0, 0, 1), moved(square(0, 0, 1), {3, 0, 0}), square(1, 0, 1),
                           moved(square(1, 0, 1), {3, 0, 0})}};
  const SectionCheck alone = check_sections(mesh, sections), r = check_framed(mesh, sections);
  CHECK(alone.extra_area == doctest::Approx(4));
  REQUIRE(r.planes.size() == 2);
  CHECK(r.planes[0].plane == 0);
  CHECK(r.planes[1].plane == 2);
  CHECK(r.section_area == doctest::Approx(4));
  CHECK(r.difference_area() < 1e-12);
  CHECK(r.distance < 1e-12);
  const auto overlapping = check_framed_sections(mesh, {"", {square(0, 0, 1), square(0, 0.5, 2)}});
  REQUIRE_FALSE(overlapping.ok());
  CHECK(overlapping.error().code == ErrorCode::contradicting_planes);
}

TEST_CASE("a plane off its vertices is compared where reconstruct fits it") {
  Sections sections{"", {square(0, 0, 1), square(1, 0, 1)}};
  sections.planes[1].vertices[2].z -= 2e-4;
  Surface mesh = cube();
  for (Vec3& p : mesh.points) p.z *= 1 - 1e-4;  // half way between the extreme vertices
  CHECK(check_sections(mesh, sections).missing_area == doctest::Approx(1));
  const SectionCheck r = check_framed(mesh, sections);
  CHECK(r.missing_area < 1e-9);
  CHECK(r.section_off_plane == doctest::Approx(2e-4));
  CHECK(r.section_displacement == doctest::Approx(1e-4));
  CHECK(r.planes[0].section_off_plane == 0);
  CHECK(r.planes[1].section_off_plane == r.section_off_plane);
  CHECK_FALSE(check_framed_sections(mesh, sections, {1e-6, 1e-5}).ok());
}

TEST_CASE("a plane that framing leaves out is met by nothing") {
  PlaneSection far = square(1000.5, 0, 1);
  far.edges.clear();
  Surface mesh = cube();
  const Sections sections{"", {far, square(0, 0, 1), square(1, 0, 1)}};
  CHECK(check_framed(mesh, sections).extra_area < 1e-12);
  append(mesh, moved(cube(), {0, 0, 1000}));
  const SectionCheck r = check_framed(mesh, sections);
  REQUIRE(r.planes.size() == 3);
  CHECK(r.planes[0].extra_area == doctest::Approx(1));
  CHECK(check_framed(cube(), {"", {moved(far, {0, 0, -1000})}}).extra_area == doctest::Approx(1));
}

TEST_CASE("sections beyond 1e100 are an error") {
  PlaneSection far = square(0, 0, 1.1e100);
  const auto check = check_framed_sections(cube(), {"", {far}});
  REQUIRE_FALSE(check.ok());
  CHECK(check.error().code == ErrorCode::too_large);
}
