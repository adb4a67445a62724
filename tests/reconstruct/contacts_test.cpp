/// Where a surface touches itself, and how separation on request undoes it.

#include "../../reconstruct/contacts.h"

#include <atomic>

#include "../../inspect/check.h"
#include "../inspect/shapes.h"
#include "shown.h"

using namespace crossloft;
using namespace crossloft::test;

TEST_CASE("a closed surface has no contacts with itself; another one at a corner, an edge or a facet has") {
  const Surface one = tetrahedron({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4});
  CHECK(find_contacts(one).empty());
  const auto with = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    Surface both = one;
    append(both, tetrahedron(a, b, c, d));
    return find_contacts(both);
  };
  CHECK(with({5, 0, 0}, {9, 0, 0}, {5, 4, 0}, {5, 0, 4}).empty());
  CHECK(with({4, 0, 0}, {9, 0, 0}, {5, 4, 0}, {5, 0, 4}).size() == 9);  // three triangles at either tip
  CHECK_FALSE(with({1, 1, 0}, {0, 0, -4}, {4, 0, -4}, {0, 4, -4}).empty());
  CHECK_FALSE(with({0, 0, 0}, {4, 0, 0}, {0, -4, 0}, {0, 0, -4}).empty());
}

TEST_CASE("a raised flag ends the search for contacts") {
  Surface both = cube();
  append(both, cube(0.5, 1.5));
  CHECK_FALSE(find_contacts(both).empty());
  const std::atomic<bool> flag{true};
  Context context;
  context.cancel = &flag;
  CHECK(find_contacts(both, context).empty());
}

TEST_CASE("separation on request leaves no contact in the figures, and moves no further than asked") {
  constexpr double kSeparation = 1e-3;
  std::size_t touching = 0;
  for (const PruneMode mode : {PruneMode::natural, PruneMode::joint})
    for (const char* name : {"figures/fig14p.contour", "figures/fig16_one_two.contour",
                             "figures/fig16_center.contour", "figures/fig17.contour",
                             "figures/fig17_cross.contour", "figures/fig18.contour", "figures/fig19.contour",
                             "figures/fig20.contour", "figures/fig20b.contour", "topology/link.contour"}) {
      CAPTURE(std::string(name));
      Options options;
      options.mode = mode;
      options.separate = false;
      const Reconstruction before = run(load(name), {}, options);
      options.separate = true;
      CHECK(find_contacts(before.surface).empty() == (before.report.touching_copies == 0));
      options.separation = kSeparation;
      const Reconstruction r = run(load(name), {}, options);
      CHECK(r.report.touching_copies == 0);
      CHECK(r.report.contacts == 0);
      CHECK(find_contacts(r.surface).empty());
      const CheckReport surface = check_surface(r.surface);
      CHECK(surface.good_topology());
      CHECK(surface.crossings == 0);
      CHECK(check_surface(welded(r.surface)).good_topology());
      CHECK(r.report.separation <= kSeparation * r.report.diagonal * 1.000001);
      for (std::size_t v = 0; v < r.surface.points.size(); ++v)
        CHECK(norm(r.surface.points[v] - before.surface.points[v]) <=
              kSeparation * r.report.diagonal * 1.000001);
      touching += before.report.touching_copies;
    }
  MESSAGE(touching << " copies touched");
  CHECK(touching > 50);
}

TEST_CASE("what can't be moved apart is counted") {
  Options options;
  options.mode = PruneMode::natural;
  std::size_t left = 0, touching = 0;
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
    const Sections sections = cut_randomly(vessel_solid(14), 9, seed);
    options.separation = 0;
    touching += run(sections, {}, options).report.touching_copies;
    options.separation = 1e-4;
    const Reconstruction r = run(sections, {}, options);
    CHECK((r.report.contacts == 0) == (r.report.touching_copies == 0));
    CHECK(check_surface(r.surface).crossings == 0);
    left += r.report.touching_copies;
  }
  MESSAGE(touching << " copies touched, " << left << " still do");
  CHECK(left * 10 <= touching);
}
