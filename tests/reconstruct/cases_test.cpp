/// Inputs that went wrong once, found by random small and nearly degenerate sections.

#include "../../inspect/check.h"
#include "scenes.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

void check_case(const char* name, const Options& options = {}) {
  const auto r = reconstruct(load(name, "/tests/reconstruct/cases/"), options);
  REQUIRE(r.ok());
  const CheckReport surface = check_surface(r->surface);
  CHECK(surface.good_topology());
  CHECK(surface.crossings == 0);
}

}  // namespace

TEST_CASE("a contour that touches another's edge where the edge is bent by rounding: its piece was no Delaunay edge") {
  check_case("touching_edge_a.contour");
  check_case("touching_edge_b.contour");
}

TEST_CASE("nearly parallel planes: a piece led to a corner crossed a further plane, and a vertex was looked up in a face "
          "it is not on") {
  check_case("near_parallel_corner.contour");
}

TEST_CASE("nearly parallel planes: a piece that crossed a plane gave its face contradicting labels") {
  check_case("near_parallel_labels.contour");
}

TEST_CASE("contours that touch along edges up to 1e-10 of the diagonal: the gap asked for millions of splits") {
  check_case("hair_gap_parallel.contour");
  check_case("hair_gap_triangle.contour");
}

TEST_CASE("simplified contours passed other vertices by a rounding error") {
  Options options;
  options.simplify = 0.5;
  check_case("simplified_onto_edge.contour", options);
}

TEST_CASE("contours that snapping narrows to lines: nothing is left to put a box around") {
  const auto r = reconstruct(load("narrowed_to_nothing.contour", "/tests/reconstruct/cases/"));
  REQUIRE(r.ok());
  CHECK(r->surface.triangles.empty());
  CHECK(r->report.arrangement_cells == 0);
  CHECK(std::count(r->report.warnings.begin(), r->report.warnings.end(),
                   "no contour is wide enough to be told from a line") == 1);
}

TEST_CASE("planes a hair apart: a vertex of their diagram was rounded far off its arc, which asked for 2^46 samples") {
  Options options;
  options.mode = PruneMode::paper;
  options.branching.mode = Branching::all;
  check_case("arc_end_off_its_line.contour", options);
}

TEST_CASE("14,000 sizes from the origin: rounding made triangles cross, which are moved apart again") {
  Options options;
  options.match_tolerance = 0;
  options.simplify = 1e-3;
  const auto r = reconstruct(load("rounded_apart.contour", "/tests/reconstruct/cases/"), options);
  REQUIRE(r.ok());
  CHECK(r->report.crossing_pairs > 0);
  CHECK(r->report.crossing_pairs_left == 0);
  CHECK(check_surface(r->surface).crossings == 0);
}

TEST_CASE("a vertex off its plane by a tenth of the solid: it was led out of the arrangement onto another plane's line") {
  check_case("moved_out_of_the_box.contour");
}

TEST_CASE("cells that had got points were asked what is small and thickened: gluing walked in circles around an edge") {
  Options options;
  options.thicken = 0.01;
  check_case("asked_after_samples.contour", options);
  options.natural.divide = InCells::all;
  check_case("asked_after_points_inside.contour", options);
}
