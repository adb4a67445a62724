// Every kind of dirt by a small case: what is made of it, and what is told.
#include "../../repair/repair.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <string>

#include "../arrangement/built_graph.h"
#include "../arrangement/polygon_sections.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

Repair repaired(const Sections& sections, const RepairOptions& options = {}) {
  auto repair = repair_sections(sections, options);
  REQUIRE(repair.ok());
  return std::move(repair).value();
}

/// The changes of a kind.
std::vector<RepairChange> changes(const Repair& repair, RepairKind kind) {
  std::vector<RepairChange> found;
  for (const RepairChange& c : repair.changes)
    if (c.kind == kind) found.push_back(c);
  return found;
}

/// Framing and contours are good now, and a second repair finds nothing to do.
void check_clean(const Repair& repair) {
  const Built built = build(repair.sections);
  CHECK_MESSAGE(built.graph.ok(), to_string(built.graph.error()));
  CHECK(repaired(repair.sections).changes.size() == 0);
}

/// z = 0 and z = 1 with a square each.
Sections two_squares() {
  Sections sections{"two.contour", {plane_at({0, 0, 1}, {0, 0, 0}), plane_at({0, 0, 1}, {0, 0, 1})}};
  add_contour(sections.planes[0], square(0, 0, 0, 1));
  add_contour(sections.planes[1], square(0, 0, 1, 1));
  return sections;
}

/// The contour through the points in z = 0, below a square in z = 1.
Sections below_square(const std::vector<Vec3>& points) {
  Sections sections{"", {plane_at({0, 0, 1}, {0, 0, 0}), plane_at({0, 0, 1}, {0, 0, 1})}};
  add_contour(sections.planes[0], points);
  add_contour(sections.planes[1], square(0, 0, 1, 1));
  return sections;
}

/// Of one loop in z = const whose edges all lead the same way around.
double area(const PlaneSection& p) {
  double twice = 0;
  for (const ContourEdge& e : p.edges) {
    const Vec3 a = p.vertices[e.a], b = p.vertices[e.b];
    twice += a.x * b.y - a.y * b.x;
  }
  return std::fabs(twice) / 2;
}

}  // namespace

TEST_CASE("clean sections stay as they are to the bit") {
  const Sections clean = two_squares();
  const Repair repair = repaired(clean);
  CHECK(repair.changes.size() == 0);
  CHECK(repair.left == 0);
  CHECK(repair.sections.source == "two.contour");
  REQUIRE(repair.sections.planes.size() == 2);
  for (std::size_t p = 0; p < 2; ++p) {
    CHECK(repair.sections.planes[p].vertices == clean.planes[p].vertices);
    CHECK(repair.sections.planes[p].edges.size() == clean.planes[p].edges.size());
    CHECK(repair.sections.planes[p].offset == clean.planes[p].offset);
    CHECK(repair.sources[p] == p);
  }
}

TEST_CASE("sections without contours are left alone") {
  const Repair repair = repaired({"", {plane_at({0, 0, 1}, {0, 0, 0})}});
  CHECK(repair.changes.size() == 0);
  REQUIRE(repair.sections.planes.size() == 1);
  CHECK(repair.sources.size() == 1);
}

TEST_CASE("D with the wrong sign on one plane") {
  Sections dirty = two_squares();
  dirty.planes[1].offset = 1;
  const Repair repair = repaired(dirty);
  const auto told = changes(repair, RepairKind::offset_sign);
  REQUIRE(told.size() == 1);
  CHECK(told[0].plane == 1);
  CHECK(repair.sections.planes[1].offset == -1);
  CHECK(repair.changes.size() == 1);
  check_clean(repair);
}

TEST_CASE("vertices off their plane go onto it") {
  Sections dirty = two_squares();
  dirty.planes[1].vertices[2].z += 0.01;
  const Repair repair = repaired(dirty);
  const auto told = changes(repair, RepairKind::onto_plane);
  REQUIRE(told.size() == 1);
  CHECK(told[0].plane == 1);
  CHECK(told[0].contour == 0);
  CHECK(told[0].distance > 0.0024);
  CHECK(told[0].distance < 0.011);
  CHECK(repair.largest_displacement == told[0].distance);
  check_clean(repair);
}

TEST_CASE("a vertex further off its plane than the limit is left and listed") {
  Sections dirty = two_squares();
  dirty.planes[1].vertices[2].z += 1;
  RepairOptions options;
  options.limit = 0.01;
  const Repair repair = repaired(dirty, options);
  CHECK(changes(repair, RepairKind::left_as_it_is).size() == 1);
  CHECK(repair.left == 1);
}

TEST_CASE("a plane with a poor normal is turned to its vertices") {
  Sections dirty = two_squares();
  for (Vec3& v : dirty.planes[1].vertices) v.z += 0.02 * v.x;
  const Repair repair = repaired(dirty);
  const auto told = changes(repair, RepairKind::plane_fitted);
  REQUIRE(told.size() == 1);
  CHECK(told[0].plane == 1);
  CHECK(told[0].distance == doctest::Approx(0.02).epsilon(0.01));
  CHECK(repair.sections.planes[1].vertices == dirty.planes[1].vertices);
  check_clean(repair);
}

// A triangle fits any plane exactly: the rounded heights of a tiny one tilted its plane through the others.
TEST_CASE("a plane is not turned by the noise of a tiny section") {
  Sections dirty = two_squares();
  dirty.planes.push_back(plane_at({0, 0, 1}, {0, 0, 2}));
  add_contour(dirty.planes[2], {{0.3, 0.1, 2}, {0.30002, 0.1, 2.000005}, {0.3, 0.10002, 1.999995}});
  RepairOptions options;
  options.limit = 1;
  const Repair repair = repaired(dirty, options);
  CHECK(changes(repair, RepairKind::plane_fitted).size() == 0);
  CHECK(changes(repair, RepairKind::onto_plane).size() == 1);
  CHECK(repair.sections.planes[2].normal == Vec3{0, 0, 1});
  CHECK(repair.sections.planes[2].offset == -2);
  check_clean(repair);
}

TEST_CASE("a plane is not turned by more than the limit") {
  Sections dirty = two_squares();
  for (Vec3& v : dirty.planes[1].vertices) v.z += 0.02 * v.x;
  RepairOptions options;
  options.limit = 0.008;  // the vertices need 0.02 of 3, the plane 0.03
  const Repair repair = repaired(dirty, options);
  CHECK(changes(repair, RepairKind::plane_fitted).size() == 0);
  CHECK(repair.sections.planes[1].normal == Vec3{0, 0, 1});
}

TEST_CASE("a vertex off its plane does not drag the others along") {
  Sections dirty = two_squares();
  dirty.planes[1].vertices[2].z = 1.2;
  const Repair repair = repaired(dirty);
  REQUIRE(repair.changes.size() == 1);
  CHECK(repair.changes[0].kind == RepairKind::onto_plane);
  CHECK((repair.changes[0].count == 1 && repair.changes[0].vertex == 2));
  CHECK(repair.changes[0].distance == doctest::Approx(0.2));
  CHECK(repair.sections.planes[1].offset == -1);
  CHECK(repair.sections.planes[1].vertices == two_squares().planes[1].vertices);
  check_clean(repair);
}

TEST_CASE("a plane stays where it is if the only vertex off it is left") {
  Sections dirty = two_squares();
  dirty.planes[1].vertices[2].z = 1.9;
  const Repair repair = repaired(dirty);
  REQUIRE(repair.changes.size() == 1);
  CHECK(repair.changes[0].kind == RepairKind::left_as_it_is);
  CHECK(repair.changes[0].count == 1);
  CHECK(repair.sections.planes[1].offset == -1);
  CHECK(repair.sections.planes[1].vertices == dirty.planes[1].vertices);
}

TEST_CASE("a plane that goes where most of its vertices are is told") {
  Sections dirty = two_squares();
  for (Vec3& v : dirty.planes[1].vertices) v.z = 1.05;
  dirty.planes[1].vertices[2].z = 1.2;
  const Repair repair = repaired(dirty);
  REQUIRE(changes(repair, RepairKind::plane_fitted).size() == 1);
  CHECK(changes(repair, RepairKind::plane_fitted)[0].distance == doctest::Approx(0.05));
  REQUIRE(changes(repair, RepairKind::onto_plane).size() == 1);
  CHECK(changes(repair, RepairKind::onto_plane)[0].count == 1);
  CHECK(repair.sections.planes[1].offset == doctest::Approx(-1.05));
  check_clean(repair);
}

TEST_CASE("nearly equal planes become one, their sections united") {
  Sections dirty = two_squares();
  dirty.planes.push_back(plane_at({0, 0, 1}, {0, 0, 1e-7}));
  add_contour(dirty.planes[2], square(1.5, 0, 1e-7, 1));  // overlaps the square of plane 0
  const Repair repair = repaired(dirty);
  const auto told = changes(repair, RepairKind::planes_united);
  REQUIRE(told.size() == 1);
  REQUIRE(repair.sections.planes.size() == 2);
  const std::size_t united = repair.sources[0] == 1 ? 1 : 0;
  CHECK(repair.sections.planes[united].edges.size() == 8);
  CHECK(repair.sources.size() == 2);
  check_clean(repair);
}

TEST_CASE("the same section given twice is one") {
  Sections dirty = two_squares();
  dirty.planes.push_back(dirty.planes[0]);
  const Repair repair = repaired(dirty);
  CHECK(changes(repair, RepairKind::planes_united).size() == 1);
  REQUIRE(repair.sections.planes.size() == 2);
  for (const PlaneSection& p : repair.sections.planes) CHECK(p.edges.size() == 4);
  check_clean(repair);
}

TEST_CASE("a contour that nearly closes is closed") {
  Sections dirty = below_square({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {-1, -0.99, 0}});
  dirty.planes[0].edges.pop_back();
  const Repair repair = repaired(dirty);
  const auto told = changes(repair, RepairKind::contour_closed);
  REQUIRE(told.size() == 1);
  CHECK(told[0].plane == 0);
  CHECK(told[0].contour == 0);
  CHECK(told[0].distance == doctest::Approx(0.01));
  CHECK(repair.sections.planes[0].edges.size() == 5);
  check_clean(repair);
}

TEST_CASE("two chains are closed to one contour, the nearest ends first") {
  Sections dirty = below_square(square(0, 0, 0, 1));
  // Edges 0-1 and 2-3 stay; their ends come near to each other in two places.
  dirty.planes[0].vertices = {{-1, -1, 0}, {0, 0.5, 0}, {0.005, 0.51, 0}, {-1, -0.99, 0}, {-0.5, 0.3, 0}};
  dirty.planes[0].edges = {{0, 1, 1, 0, 0, 0}, {2, 4, 1, 0, 1, 0}, {4, 3, 1, 0, 1, 0}};
  const Repair repair = repaired(dirty);
  CHECK(changes(repair, RepairKind::contour_closed).size() == 2);
  CHECK(repair.sections.planes[0].edges.size() == 5);
  check_clean(repair);
}

TEST_CASE("a chain with its ends far apart is left out and listed") {
  Sections dirty = below_square(square(0, 0, 0, 1));
  dirty.planes[0].edges.pop_back();
  add_contour(dirty.planes[0], square(4, 0, 0, 1), 1);
  const Repair repair = repaired(dirty);
  const auto told = changes(repair, RepairKind::contour_left_out);
  REQUIRE(told.size() == 1);
  CHECK(told[0].plane == 0);
  CHECK(told[0].contour == 0);
  CHECK(told[0].count == 3);
  CHECK(repair.left == 1);
  CHECK(repair.sections.planes[0].edges.size() == 4);
  check_clean(repair);
}

TEST_CASE("repeated vertices") {
  const Repair repair =
      repaired(below_square({{-1, -1, 0}, {1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {1, 1 + 1e-10, 0}, {-1, 1, 0}}));
  const auto told = changes(repair, RepairKind::repeated_vertices);
  REQUIRE(told.size() == 1);
  CHECK(told[0].count == 2);
  CHECK(repair.sections.planes[0].edges.size() == 4);
  check_clean(repair);
}

namespace {

/// Adds a chain of edges that name equal vertices twice.
void add_loose(PlaneSection& p, const std::vector<Vec3>& points, bool closed, std::uint32_t contour) {
  for (std::size_t k = 0; k + (closed ? 0 : 1) < points.size(); ++k) {
    const auto v = static_cast<std::uint32_t>(p.vertices.size());
    p.vertices.insert(p.vertices.end(), {points[k], points[(k + 1) % points.size()]});
    p.edges.push_back({v, v + 1, 1, 0, contour, 0});
  }
}

std::vector<Vec3> polygon(std::size_t corners, double radius) {
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < corners; ++k) {
    const double angle = 6.283185307179586 * static_cast<double>(k) / static_cast<double>(corners);
    points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  return points;
}

}  // namespace

// Steps that went by numbers of vertices dropped a short edge as a loop of its own, and opened the contour.
TEST_CASE("edges that name equal vertices twice make one contour, and stay so if it is clean") {
  Sections loose = below_square(square(0, 0, 0, 1));
  loose.planes[0] = plane_at({0, 0, 1}, {0, 0, 0});
  add_loose(loose.planes[0], square(0, 0, 0, 1), true, 0);
  const Repair same = repaired(loose);
  CHECK(same.changes.size() == 0);
  CHECK(same.sections.planes[0].vertices == loose.planes[0].vertices);
  for (std::size_t e = 0; e < 4; ++e) CHECK(same.sections.planes[0].edges[e].a == loose.planes[0].edges[e].a);
  loose.planes[0] = plane_at({0, 0, 1}, {0, 0, 0});
  add_loose(loose.planes[0], {{-1, -1, 0}, {0, -1, 0}, {1e-6, -1.000001, 0}, {1, -1, 0}, {1, 1, 0}}, true, 0);
  const Repair repair = repaired(loose);
  CHECK(changes(repair, RepairKind::tiny_loop).size() == 0);
  CHECK(repair.left == 0);
  check_clean(repair);
}

TEST_CASE("an open chain of edges that name equal vertices twice goes as a whole") {
  Sections dirty = below_square(square(0, 0, 0, 1));
  add_loose(dirty.planes[0], {{3, 0, 0}, {3, 1, 0}, {4, 2, 0}, {5, 1, 0}, {6, 0, 0}}, false, 1);
  const Repair repair = repaired(dirty);
  REQUIRE(changes(repair, RepairKind::contour_left_out).size() == 1);
  CHECK(changes(repair, RepairKind::contour_left_out)[0].count == 4);
  CHECK(repair.sections.planes[0].edges.size() == 4);
  check_clean(repair);
}

TEST_CASE("many short edges one after the other don't make a contour vanish") {
  const Sections dense = below_square(polygon(1000, 1));
  RepairOptions options;
  options.repeated = 0.003;
  const Repair repair = repaired(dense, options);
  CHECK(repair.left == 0);
  CHECK(repair.sections.planes[0].edges.size() > 100);
  CHECK(repair.sections.planes[0].edges.size() < 600);
  CHECK(repair.largest_displacement <= 2 * options.repeated * repair.diagonal);
  CHECK(repaired(repair.sections, options).changes.size() == 0);
}

TEST_CASE("a contour that becomes one vertex is told and counts as left") {
  Sections dirty = two_squares();
  add_contour(dirty.planes[0], square(5, 0, 0, 0.01), 1);
  RepairOptions options;
  options.repeated = 0.01;
  const Repair repair = repaired(dirty, options);
  REQUIRE(changes(repair, RepairKind::contour_left_out).size() == 1);
  CHECK(changes(repair, RepairKind::contour_left_out)[0].contour == 1);
  CHECK(repair.left == 1);
}

TEST_CASE("no tolerance goes beyond the limit") {
  RepairOptions options;
  options.limit = 1e-4;
  options.same_plane = options.repeated = options.spike = options.tiny_loop = options.collinear = 0.05;
  Sections sections = two_squares();
  sections.planes.push_back(plane_at({0, 0, 1}, {0, 0, 0.05}));
  add_contour(sections.planes[2], {{3, 0, 0.05}, {4, 0, 0.05}, {4.05, 0.05, 0.05}, {4, 0.1, 0.05}});
  add_contour(sections.planes[2], square(5, 0, 0.05, 0.05), 1);
  add_contour(sections.planes[2], {{6, 0, 0.05}, {7, 0.01, 0.05}, {6, 0.02, 0.05}}, 2);
  add_contour(sections.planes[2], {{6, 2, 0.05}, {6.5, 1.99, 0.05}, {7, 2, 0.05}, {6.5, 3, 0.05}}, 3);
  CHECK(repaired(sections, options).changes.size() == 0);
}

TEST_CASE("what vertices move as planes become one is told") {
  Sections sections = two_squares();
  sections.planes.push_back(plane_at({0, 0, 1}, {0, 0, 0.05}));
  add_contour(sections.planes[2], square(4, 0, 0.05, 1));
  RepairOptions options;
  options.same_plane = 0.05;
  const Repair repair = repaired(sections, options);
  REQUIRE(changes(repair, RepairKind::planes_united).size() == 1);
  CHECK(repair.largest_displacement == doctest::Approx(0.05));
}

TEST_CASE("a thin triangle is no straight run") {
  Sections sections = two_squares();
  add_contour(sections.planes[0], {{2, 0, 0}, {4, 0, 0}, {3, 1e-5, 0}}, 1);
  RepairOptions options;
  options.collinear = 1e-4;
  const Repair repair = repaired(sections, options);
  CHECK(repair.changes.size() == 0);
  CHECK(repair.sections.planes[0].edges.size() == 7);
}

TEST_CASE("spikes, exact and narrow, one upon the other") {
  const Repair repair = repaired(below_square({{-1, -1, 0},
                                               {0, -1, 0},
                                               {0, -3, 0},
                                               {0, -1, 0},
                                               {1, -1, 0},
                                               {1, 0, 0},
                                               {2, 1e-9, 0},
                                               {3, 0, 0},
                                               {1, 1e-8, 0},
                                               {1, 1, 0},
                                               {-1, 1, 0}}));
  const auto told = changes(repair, RepairKind::spikes);
  REQUIRE(told.size() == 1);
  CHECK(told[0].plane == 0);
  for (const Vec3& v : repair.sections.planes[0].vertices) {
    CHECK(v.x <= 1);
    CHECK(v.y >= -1);
  }
  check_clean(repair);
}

TEST_CASE("a contour that crosses itself is read by even-odd") {
  const Repair repair = repaired(below_square({{-1, -1, 0}, {1, 1, 0}, {1, -1, 0}, {-1, 1, 0}}));
  const auto told = changes(repair, RepairKind::crossings);
  REQUIRE(told.size() == 1);
  CHECK(told[0].plane == 0);
  CHECK(told[0].contour == 0);
  CHECK(repair.sections.planes[0].edges.size() == 6);  // two triangles
  check_clean(repair);
}

TEST_CASE("contours that overlap are read by even-odd") {
  Sections dirty = below_square(square(0, 0, 0, 1));
  add_contour(dirty.planes[0], square(1, 1, 0, 1), 1);
  const Repair repair = repaired(dirty);
  CHECK(changes(repair, RepairKind::crossings).size() == 2);
  CHECK(repair.sections.planes[0].edges.size() == 12);
  check_clean(repair);
}

TEST_CASE("contours that share an edge become one") {
  Sections dirty = below_square(square(0, 0, 0, 1));
  add_contour(dirty.planes[0], square(2, 0, 0, 1), 1);
  const Repair repair = repaired(dirty);
  CHECK(repair.sections.planes[0].edges.size() == 6);
  CHECK(area(repair.sections.planes[0]) == doctest::Approx(8));
  check_clean(repair);
}

TEST_CASE("tiny loops go and are listed") {
  Sections dirty = two_squares();
  add_contour(dirty.planes[0], square(5, 0, 0, 1e-7), 1);
  const Repair repair = repaired(dirty);
  const auto told = changes(repair, RepairKind::tiny_loop);
  REQUIRE(told.size() == 1);
  CHECK(told[0].plane == 0);
  CHECK(told[0].contour == 1);
  CHECK(repair.sections.planes[0].edges.size() == 4);
  check_clean(repair);
}

TEST_CASE("a vertex that bends a straight run by a hair goes, an exact one stays") {
  const Repair repair =
      repaired(below_square({{-1, -1, 0}, {0, -1, 0}, {1, -1, 0}, {1 + 1e-10, 0, 0}, {1, 1, 0}, {-1, 1, 0}}));
  const auto told = changes(repair, RepairKind::nearly_straight);
  REQUIRE(told.size() == 1);
  CHECK(told[0].count == 1);
  CHECK(told[0].vertex == 3);
  CHECK(repair.sections.planes[0].edges.size() == 5);
}

TEST_CASE("materials stay with their walls, borders where they still end at walls") {
  Sections dirty = two_squares();
  PlaneSection& p = dirty.planes[0];
  // The square is halved by a border between materials 1 and 2; a second contour crosses its left half.
  p.vertices = {{-1, -1, 0}, {0, -1, 0}, {1, -1, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 1, 0}};
  p.edges = {{0, 1, 1, 0, 0, 0}, {1, 2, 2, 0, 0, 0}, {2, 3, 2, 0, 0, 0}, {3, 4, 2, 0, 0, 0},
             {4, 5, 1, 0, 0, 0}, {5, 0, 1, 0, 0, 0}, {1, 4, 1, 2, 0, 0}};
  add_contour(p, square(-1, 0, 0, 0.5), 1);
  const Repair repair = repaired(dirty);
  int borders = 0, second = 0;
  for (const ContourEdge& e : repair.sections.planes[0].edges) {
    borders += e.material_a == 1 && e.material_b == 2;
    second += e.material_a == 2 && e.material_b == 0;
  }
  CHECK(borders == 1);
  CHECK(second == 3);
  CHECK(changes(repair, RepairKind::borders_left_out).size() == 0);
}

TEST_CASE("each step can be switched off") {
  Sections dirty = two_squares();
  dirty.planes[1].vertices[2].z += 0.01;
  dirty.planes[0].edges.pop_back();
  add_contour(dirty.planes[0], square(5, 0, 0, 1e-7), 1);
  RepairOptions none;
  none.planes = none.chains = none.crossings = none.loops = none.agreement = false;
  CHECK(repaired(dirty, none).changes.size() == 0);
  none.loops = true;
  CHECK(repaired(dirty, none).changes.size() == 1);
}

TEST_CASE("a raised cancel flag ends the work, whatever steps there are") {
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  for (const bool agreement : {true, false}) {
    RepairOptions options;
    options.agreement = agreement;
    const auto repair = repair_sections({"", {disk({0, 0, 1}, {0, 0, 0}, 1, 12)}}, options, context);
    REQUIRE_FALSE(repair.ok());
    CHECK(repair.error().code == ErrorCode::cancelled);
  }
}

TEST_CASE("the length of normals does not count") {
  for (const double scale : {1e-320, 1e-200, -1e-165, 1e155, 1.5e308}) {
    CAPTURE(scale);
    Sections good = two_squares();
    for (PlaneSection& p : good.planes) p.normal = scale * p.normal, p.offset *= scale;
    CHECK(repaired(good).changes.empty());
    Sections turned = good;
    turned.planes[1].offset = -turned.planes[1].offset;
    const Repair repair = repaired(turned);
    CHECK(changes(repair, RepairKind::offset_sign).size() == 1);
    CHECK(repair.sections.planes[1].offset == good.planes[1].offset);
    Sections tilted = two_squares();  // to be fitted
    tilted.planes[1].normal = scale * Vec3{0.01, 0, 1};
    tilted.planes[1].offset = -scale;
    const Repair fitted = repaired(tilted);
    CHECK(changes(fitted, RepairKind::plane_fitted).size() == 1);
    const PlaneSection& plane = fitted.sections.planes[1];
    CHECK(is_finite(plane.normal));
    CHECK((plane.normal.z > 0) == (scale > 0));
    check_clean(fitted);
    Sections bent = good;  // to be moved onto its plane
    bent.planes[1].vertices[0].z += 0.02;
    const Repair flat = repaired(bent);
    CHECK(is_finite(flat.sections.planes[1].normal));
    check_clean(flat);
  }
}

TEST_CASE("what no repair can read is an error") {
  Sections bad = two_squares();
  bad.planes[0].vertices[0].x = std::numeric_limits<double>::quiet_NaN();
  CHECK(repair_sections(bad).error().code == ErrorCode::not_finite);
  bad = two_squares();
  bad.planes[1].edges[0].a = 99;
  CHECK(repair_sections(bad).error().code == ErrorCode::index_out_of_range);
  bad = two_squares();
  bad.planes[1].normal = {};
  CHECK(repair_sections(bad).error().code == ErrorCode::zero_normal);
  CHECK(repair_sections(Sections{}).error().code == ErrorCode::no_plane);
  RepairOptions options;
  options.limit = -1;
  CHECK(repair_sections(two_squares(), options).error().code == ErrorCode::usage);
}

TEST_CASE("what is done after planes were united is told by the numbers of the file") {
  Sections dirty = two_squares();
  dirty.planes.push_back(dirty.planes[0]);
  dirty.planes[2].vertices.clear();
  dirty.planes[2].edges.clear();
  add_contour(dirty.planes[2], square(4, 0, 0, 1), 0);
  add_contour(dirty.planes[2], square(8, 0, 0, 1e-7), 1);
  const auto told = changes(repaired(dirty), RepairKind::tiny_loop);
  REQUIRE(told.size() == 1);
  const bool kept = told[0].plane == 2 && told[0].contour == 1 && told[0].vertex == 4;
  CHECK(kept);
}

TEST_CASE("names of kinds are all different") {
  std::vector<std::string> names;
  for (int k = 0; k <= static_cast<int>(RepairKind::left_as_it_is); ++k)
    names.push_back(name_of(static_cast<RepairKind>(k)));
  std::sort(names.begin(), names.end());
  CHECK(std::unique(names.begin(), names.end()) == names.end());
}

namespace {

/// Two squares of size 1, and a contour through these points in the plane of the first.
Sections squares_and(const std::vector<Vec3>& points) {
  Sections sections = two_squares();
  add_contour(sections.planes[0], points, 1);
  return sections;
}

/// Nothing but one contour without area was left out.
void check_only_flat(const Sections& dirty) {
  const Repair repair = repaired(dirty);
  REQUIRE(repair.changes.size() == 1);
  const RepairChange& told = repair.changes[0];
  CHECK(told.kind == RepairKind::no_area);
  CHECK((told.plane == 0 && told.contour == 1 && told.vertex == 4));
  CHECK(repair.left == 0);
  CHECK(repair.diagonal == repaired(two_squares()).diagonal);
  for (std::size_t p = 0; p < 2; ++p)
    CHECK(repair.sections.planes[p].vertices == two_squares().planes[p].vertices);
  check_clean(repair);
}

}  // namespace

TEST_CASE("contours without area go, are told, and do not count for the size") {
  check_only_flat(squares_and({{5, 5, 0}}));
  check_only_flat(squares_and({{5e6, 5e6, 0}}));
  check_only_flat(squares_and({{5e6, 5e6, 0}, {6e6, 5e6, 0}}));
  check_only_flat(squares_and({{5e6, 5e6, 0}, {6e6, 6e6, 0}, {7e6, 7e6, 0}}));
}

TEST_CASE("an edge from a vertex to itself is told also where contours without area stay") {
  RepairOptions options;
  options.loops = false;
  const Repair repair = repaired(squares_and({{5e6, 5e6, 0}}), options);
  REQUIRE(repair.changes.size() == 1);
  CHECK(repair.changes[0].kind == RepairKind::repeated_vertices);
  CHECK(repair.changes[0].contour == 1);
  CHECK(repair.sections.planes[0].edges.size() == 4);
}

TEST_CASE("an open chain far away does not make good contours tiny") {
  Sections dirty = squares_and({{5e6, 5e6, 0}, {5e6 + 1, 5e6, 0}, {5e6 + 1, 5e6 + 1, 0}});
  dirty.planes[0].edges.pop_back();
  const Repair repair = repaired(dirty);
  REQUIRE(repair.changes.size() == 1);
  CHECK(repair.changes[0].kind == RepairKind::contour_left_out);
  CHECK(repair.left == 1);
  CHECK(repair.sections.planes[0].vertices == two_squares().planes[0].vertices);
  check_clean(repair);
}

TEST_CASE("where all loops are tiny beside their distance none goes") {
  Sections far_apart = squares_and(square(1e7, 0, 0, 1));
  RepairOptions options;
  options.planes = false;  // beside that distance the planes are one
  const Repair repair = repaired(far_apart, options);
  CHECK(changes(repair, RepairKind::tiny_loop).size() == 0);
  CHECK(changes(repair, RepairKind::left_as_it_is).size() == 3);
  CHECK(repair.left == 3);
  CHECK(repair.sections.planes[0].edges.size() == 8);
}

namespace {

/// z = 0 with a square of half side 2, z = 1 with the same, and more records of z = 0 with a contour each.
Sections with_records(const std::vector<std::vector<Vec3>>& contours) {
  Sections sections{"", {plane_at({0, 0, 1}, {0, 0, 0}), plane_at({0, 0, 1}, {0, 0, 1})}};
  add_contour(sections.planes[0], square(0, 0, 0, 2));
  add_contour(sections.planes[1], square(0, 0, 1, 2));
  for (const auto& contour : contours) {
    sections.planes.push_back(plane_at({0, 0, 1}, {0, 0, 0}));
    add_contour(sections.planes.back(), contour);
  }
  return sections;
}

/// Of z = 0 as it is now.
std::size_t walls_in_first(const Repair& repair) {
  REQUIRE(repair.sections.planes.size() == 2);
  for (const PlaneSection& plane : repair.sections.planes)
    if (plane.offset == 0) return plane.edges.size();
  return 0;
}

}  // namespace

TEST_CASE("a hole as a record of its own is a hole, also if records are there twice or touch") {
  const std::vector<Vec3> hole = square(0, 0, 0, 1), corner = square(1, 1, 0, 1),
                          island = square(0, 0, 0, 0.5);
  const std::vector<Vec3> touching{{2, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  const auto check = [](const Sections& dirty, std::size_t walls) {
    const Repair repair = repaired(dirty);
    CHECK(changes(repair, RepairKind::planes_united).size() == dirty.planes.size() - 2);
    CHECK(repair.left == 0);
    CHECK(walls_in_first(repair) == walls);
    check_clean(repair);
  };
  check(with_records({hole}), 8);
  check(with_records({hole, hole, square(0, 0, 0, 2)}), 8);
  check(with_records({island, hole}), 12);
  check(with_records({square(0, 0, 0, 2)}), 4);
  check(with_records({square(8, 0, 0, 1)}), 8);
  check(with_records({touching}), 8);  // one vertex on an edge, which is cut there
}

TEST_CASE("a contour that vanishes as planes are united is told and counts as left") {
  Sections dirty = with_records({square(2, 0, 0, 1)});  // crosses the square of plane 0
  add_contour(dirty.planes[2], square(-1, 0, 0, 0.25), 1);
  const Repair repair = repaired(dirty);
  const auto told = changes(repair, RepairKind::contour_left_out);
  REQUIRE(told.size() == 1);
  CHECK((told[0].plane == 2 && told[0].contour == 1 && told[0].vertex == 4 && told[0].count == 4));
  CHECK(repair.left == 1);
  CHECK(walls_in_first(repair) == 8);
}

TEST_CASE("a record that fills a corner of another one is a part of it, and is told") {
  const Repair repair = repaired(with_records({square(1, 1, 0, 1)}));
  CHECK(changes(repair, RepairKind::contour_left_out).size() == 1);
  CHECK(walls_in_first(repair) == 6);
}
