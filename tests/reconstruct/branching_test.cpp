/// Branching and cutting samples in the pipeline.

#include "../../inspect/check.h"
#include "../../reconstruct/observer.h"
#include "../arrangement/polygon_sections.h"
#include "scenes.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

Options with(Branching mode, bool cutting = false) {
  Options options;
  options.branching = {mode, cutting};
  return options;
}

constexpr Vec3 kUp{0, 0, 1};

/// Circles of radius r around the points of a row along x or y, in the plane z.
PlaneSection row(double z, std::vector<double> at, bool along_x, double r, int corners) {
  PlaneSection plane = plane_at(kUp, {0, 0, z});
  for (const double t : at)
    add_contour(plane, polygon(kUp, along_x ? Vec3{t, 0, z} : Vec3{0, t, z}, r, corners));
  return plane;
}

/// Keeps what the diagrams gave.
struct Watcher : Observer {
  void on_sections(const FramedSections&, const Arrangement& a, const SectionGraph& g) override {
    graph = g;
    for (std::uint32_t c = 0; c < a.face_count(); ++c) planes.push_back(a.plane_of(FaceId{c}).value);
  }
  void on_branching(const FaceBranching& b, const FaceTriangulation&, const Numbering&) override {
    sides.push_back(b);
  }
  SectionGraph graph;
  std::vector<std::uint32_t> planes;
  std::vector<FaceBranching> sides;
};

std::uint32_t sample_count(const Watcher& watcher) {
  std::uint32_t count = 0;
  for (const FaceBranching& side : watcher.sides) count += static_cast<std::uint32_t>(side.samples.size());
  return count;
}

void check_sound(const Reconstruction& r) {
  const CheckReport surface = check_surface(r.surface);
  CHECK(surface.good_topology());
  CHECK(surface.crossings == 0);
  SectionCheckOptions options;
  options.on_plane = 1e-9;  // bridges over bare slivers are thinner than the default
  const SectionCheck sections = check_sections(r.surface, r.sections, options);
  for (std::size_t p = 0; p < sections.planes.size(); ++p) {
    CHECK(sections.planes[p].extra_area <= 1e-6 * r.report.section_area);
    CHECK(sections.planes[p].missing_area <= r.report.planes[p].flat_area + 1e-6 * r.report.section_area);
  }
}

}  // namespace

TEST_CASE("samples lie strictly inside their section and are vertices of both cells") {
  Watcher watcher;
  const Sections sections{
      "", {row(0, {0.1}, true, 1, 40), row(1, {-1, 1}, true, 0.5, 24), row(2, {0.1}, true, 1, 40)}};
  const auto r = reconstruct(sections, {}, {}, &watcher);
  REQUIRE(r.ok());
  REQUIRE(sample_count(watcher) > 0);
  CHECK(r->report.branching_samples == sample_count(watcher));
  for (const FaceBranching& side : watcher.sides) {
    const std::uint32_t p = watcher.planes[side.face.value];
    std::vector<WallEnds> ends;
    const SectionLocator locator = watcher.graph.locator(p, ends);
    for (const LatticePoint& sample : side.samples) {
      CHECK(side_of_plane(watcher.graph.planes[p], sample) == 0);
      CHECK(locator.locate(sample) == SectionLocator::Place::inside);
      CHECK(std::abs(side.frame.to_plane(sample).y) > 0);
    }
  }
  CHECK(r->report.flat_regions == 0);
  check_sound(*r);
}

TEST_CASE("three slices, one and two and one: both ways round are there") {
  const Sections sections{
      "", {row(0, {0.1}, true, 1, 40), row(1, {-1, 1}, true, 0.5, 24), row(2, {0.1}, true, 1, 40)}};
  Options off = with(Branching::off), automatic = with(Branching::automatic);
  off.mode = automatic.mode = PruneMode::joint;  // where what lacks samples is bare in the end, too
  const auto alone = reconstruct(sections, off);
  const auto joined = reconstruct(sections, automatic);
  REQUIRE(alone.ok());
  REQUIRE(joined.ok());
  CHECK(alone->report.flat_regions == 1);
  CHECK(joined->report.flat_regions == 0);
  CHECK(joined->report.volume > 1.3 * alone->report.volume);
  const CheckReport surface = check_surface(joined->surface);
  CHECK(surface.components.size() == 2);
}

TEST_CASE("a section that branches to both sides, across: the diagrams cross in it") {
  const Sections sections{
      "", {row(0, {-1, 1}, true, 0.5, 24), row(1, {0}, true, 1, 40), row(2, {-1, 1}, false, 0.5, 24)}};
  Watcher watcher;
  const auto r = reconstruct(sections, {}, {}, &watcher);
  REQUIRE(r.ok());
  CHECK(watcher.sides.size() == 2);
  CHECK(r->report.flat_regions == 0);
  CHECK(r->report.pinched_vertices > 0);  // where the two lines cross (paper, Figure 12a)
  CHECK(r->report.pinched_vertices <= 4);
  CHECK(check_surface(r->surface).components.size() == 1);
  check_sound(*r);
}

TEST_CASE("planes without branching get no samples, also if all of the diagram is asked for") {
  const Sections tube{"", {row(0, {0}, true, 1, 24), row(1, {0}, true, 1, 24)}};
  for (const Branching mode : {Branching::automatic, Branching::all}) {
    const auto r = reconstruct(tube, with(mode));
    REQUIRE(r.ok());
    CHECK(r->report.branching_samples == 0);
  }
}

TEST_CASE("all samples the medial axis of one section, automatic the axis between two") {
  PlaneSection bean = plane_at(kUp, {0, 0, 1});  // a U: its arms compete within one section
  add_contour(
      bean, {{-2, -2, 1}, {2, -2, 1}, {2, 2, 1}, {1, 2, 1}, {1, -1, 1}, {-1, -1, 1}, {-1, 2, 1}, {-2, 2, 1}});
  PlaneSection square_below = plane_at(kUp, {0, 0, 0});
  add_contour(square_below, square(0, 0, 0, 3));
  const Sections sections{"", {square_below, bean}};
  CHECK(reconstruct(sections, with(Branching::automatic))->report.branching_samples == 0);
  const auto all = reconstruct(sections, with(Branching::all));
  REQUIRE(all.ok());
  CHECK(all->report.branching_samples > 0);
  check_sound(*all);
}

TEST_CASE("automatic samples the roof of a hole where handles had to be taken out, in its middle") {
  Sections sections;
  sections.planes.push_back(plane_at(kUp, {0, 0, 0}));
  for (const double r : {2.0, 0.8}) add_contour(sections.planes[0], polygon(kUp, {0, 0, 0}, r, 90));
  sections.planes.push_back(row(0.2, {0}, true, 1.8, 90));
  Watcher watcher;
  const auto with_samples = reconstruct(sections, {}, {}, &watcher);
  const auto without = reconstruct(sections, with(Branching::off));
  REQUIRE(with_samples.ok());
  REQUIRE(without.ok());
  check_sound(*with_samples);
  CHECK(sample_count(watcher) > 0);
  for (const FaceBranching& side : watcher.sides)
    for (const LatticePoint& p : side.samples) CHECK(p.z > 0);  // on the disk: the grid's origin is amid
  REQUIRE(without->report.cells.size() == 1);
  CHECK(without->report.cells[0].genus_before > 0);
  CHECK(without->report.cells[0].topology.outsides == 1);
  CHECK(with_samples->report.cells[0].topology.outsides == 2);
  CHECK(with_samples->report.volume > 1.1 * without->report.volume);
}

/// Keeps the triangulations of faces.
struct Faces : Observer {
  void on_face(const FaceTriangulation& face, const Numbering&) override {
    if (!face.triangles.empty()) faces.push_back(face);
  }
  std::vector<FaceTriangulation> faces;
};

TEST_CASE("edges in holes: not those in bays, in islands or beyond the section") {
  const auto edges_of = [](PlaneSection plane) {
    Sections sections;
    sections.planes.push_back(std::move(plane));
    Faces watcher;
    REQUIRE(reconstruct(sections, {}, {}, &watcher).ok());
    std::size_t edges = 0;
    for (const FaceTriangulation& face : watcher.faces) edges += edges_in_holes(face).size();
    return edges;
  };
  PlaneSection plane = plane_at(kUp, {0, 0, 0});
  add_contour(plane, polygon(kUp, {0, 0, 0}, 4, 12));
  CHECK(edges_of(plane) == 0);
  add_contour(plane, polygon(kUp, {0, 0, 0}, 2, 12));  // a hole
  CHECK(edges_of(plane) == 9);
  add_contour(plane, polygon(kUp, {0, 0, 0}, 1, 12));  // with an island: between the two
  CHECK(edges_of(plane) == 24);
  PlaneSection bay = plane_at(kUp, {0, 0, 0});
  add_contour(bay, {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}});
  CHECK(edges_of(bay) == 0);
}

TEST_CASE("noise does not matter: one circle under four, joined to all of them") {
  const std::uint64_t seed = 11;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int round = 0; round < 10; ++round) {
    Sections sections = load("figures/fig16_center.contour");
    for (PlaneSection& plane : sections.planes)
      for (Vec3& v : plane.vertices) v = v + 1e-12 * Vec3{uniform(random), uniform(random), 0};
    const auto r = reconstruct(sections);
    REQUIRE(r.ok());
    CHECK(r->report.volume >= 3.5);  // without branching samples down to 3.08
    CHECK(r->report.flat_area <= 0.005 * r->report.section_area);
    check_sound(*r);
  }
}

TEST_CASE("both sides branch at nearly the same places: one sample serves both") {
  const auto four = [](double z, double shift) {
    PlaneSection plane = plane_at(kUp, {0, 0, z});
    for (const double x : {-1.0, 1.0})
      for (const double y : {-1.0, 1.0})
        add_contour(plane, polygon(kUp, {x + shift, y + 0.7 * shift, z}, 0.5, 24));
    return plane;
  };
  PlaneSection middle = plane_at(kUp, {0, 0, 1});
  add_contour(middle, polygon(kUp, {0.1, 0, 1}, 1.4, 40));
  for (const double shift : {1e-4, 1e-9, 1e-14}) {
    CAPTURE(shift);
    Watcher watcher;
    const auto r = reconstruct({"", {four(0, 0), middle, four(2, shift)}}, {}, {}, &watcher);
    REQUIRE(r.ok());
    REQUIRE(watcher.sides.size() == 2);
    CHECK(r->report.branching_samples < sample_count(watcher));
    double nearest = 1;
    const auto on_plane = [](const Vec3& p) { return p.z == 0 || p.z == 1 || p.z == 2; };  // not of a bridge
    for (const Vec3& p : r->surface.points)
      for (const Vec3& q : r->surface.points)
        if (on_plane(p) && on_plane(q) && norm(p - q) > 0) nearest = std::min(nearest, norm(p - q));
    CHECK(nearest > 0.03);
    CHECK(r->report.flat_regions == 0);
    check_sound(*r);
  }
}

TEST_CASE("sections tiny against the one that branches to them: few samples, all joined") {
  for (const double r : {1e-3, 1e-6, 1e-9}) {
    CAPTURE(r);
    const Sections sections{"", {row(0, {0.1}, true, 1, 40), row(1, {-0.5, 0.5}, true, r, 8)}};
    for (const Branching mode : {Branching::automatic, Branching::all}) {
      const auto result = reconstruct(sections, with(mode));
      REQUIRE(result.ok());
      CHECK(result->report.branching_samples > 0);
      CHECK(result->report.branching_samples < 1000);
      CHECK(result->report.flat_regions == 0);
      check_sound(*result);
    }
  }
}

TEST_CASE("random small scenes with every sample there is: the promises hold") {
  const std::uint64_t seed = 5;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uint32_t samples = 0;
  for (int round = 0; round < 150; ++round) {
    CAPTURE(round);
    Sections sections;
    const int planes = 2 + static_cast<int>(random() % 4);
    for (int p = 0; p < planes; ++p) {
      Vec3 normal = round % 2 == 0 ? kUp : random_vector(random);
      PlaneSection plane =
          plane_at(normal, round % 2 == 0 ? Vec3{0, 0, 1.0 * p} : 0.3 * random_vector(random));
      const Vec3 n = unit(normal), u = unit(cross(n, {0.3, 0.2, 1.1})), v = cross(n, u);
      const Vec3 origin = (-plane.offset / dot(normal, normal)) * normal;
      for (int k = 0; k < 3; ++k) {  // disjoint circles in a row
        const Vec3 centre =
            origin + (2.0 * (k - 1) + 0.3 * uniform(random)) * u + (0.3 * uniform(random)) * v;
        add_contour(plane, polygon(normal, centre, 0.4 + 0.15 * uniform(random),
                                   5 + static_cast<int>(random() % 12)));
      }
      sections.planes.push_back(plane);
    }
    for (const bool cutting : {false, true}) {
      const auto r = reconstruct(sections, with(Branching::all, cutting));
      if (!r.ok()) CHECK(r.error().code != ErrorCode::internal);
      if (!r.ok()) continue;
      samples += r->report.branching_samples;
      check_sound(*r);
    }
  }
  CHECK(samples > 100);
}
