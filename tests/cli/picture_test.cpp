#include "../../cli/picture/picture.h"

#include <doctest/doctest.h>

#include <array>

using namespace crossloft;

namespace {

/// A square of side 2 around the origin on z = 0.
Sections square() {
  PlaneSection plane;
  plane.normal = {0, 0, 1};
  plane.vertices = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  for (std::uint32_t v = 0; v < 4; ++v) plane.edges.push_back({.a = v, .b = (v + 1) % 4});
  Sections sections;
  sections.planes.push_back(plane);
  return sections;
}

/// Two triangles that fill it.
Surface sheet() {
  Surface surface;
  surface.points = square().planes[0].vertices;
  surface.triangles = {{0, 1, 2}, {0, 2, 3}};
  return surface;
}

/// In the middle of one half.
std::array<int, 3> colour(const cli::Image& image, bool right) {
  const std::size_t at =
      3 * (image.width * (image.height / 2) + image.width / 4 + (right ? image.width / 2 : 0));
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

}  // namespace

TEST_CASE("a part is seen however much it is enlarged") {
  cli::PictureOptions options;
  options.width = 64, options.height = 32, options.reach = 0.1;
  const cli::Image near = cli::draw_picture(square(), sheet(), options);
  for (const double reach : {1e-6, 1e-9, 1e-15, 1e-60}) {
    CAPTURE(reach);
    options.reach = reach;
    const cli::Image image = cli::draw_picture(square(), sheet(), options);
    CHECK(colour(image, false) == colour(near, false));
    CHECK(colour(image, true) == colour(near, true));
  }
  options.reach = 1e-310, options.middle = {1e308, -1e308, 1e308};
  cli::draw_picture(square(), sheet(), options);
}

TEST_CASE("it can be seen from any side") {
  Sections upright = square();
  upright.planes[0].normal = {1, 0, 0};
  Surface wall = sheet();
  for (auto* points : {&upright.planes[0].vertices, &wall.points})
    for (Vec3& p : *points) p = {0, p.x, p.y};  // now towards x
  cli::PictureOptions options;
  options.width = 64, options.height = 32;
  const auto is_drawn = [&](const Sections& sections, const Surface& surface, Vec3 from) {
    options.from = from;
    const cli::Image seen = cli::draw_picture(sections, surface, options);
    const cli::Image nothing = cli::draw_picture({}, {}, options);
    return colour(seen, false) != colour(nothing, false) && colour(seen, true) != colour(nothing, true);
  };
  for (const double length : {1.0, 1e-300, 1e300}) {
    CHECK(is_drawn(square(), sheet(), {0, 0, length}));
    CHECK(is_drawn(upright, wall, {length, 0, 0}));
    CHECK(is_drawn(upright, wall, {length, 0, -length}));
  }
  std::swap(wall.triangles[0][1], wall.triangles[0][2]),
      std::swap(wall.triangles[1][1], wall.triangles[1][2]);
  CHECK(is_drawn(upright, wall, {-1, 0, 0}));
}

TEST_CASE("a part that is away from the data is known to be so") {
  cli::PictureOptions options;
  CHECK(!cli::is_beside(square(), sheet(), options));
  options.reach = 1, options.middle = {1.5, 0, 0};
  CHECK(!cli::is_beside(square(), sheet(), options));
  options.middle = {2.5, 0, 0};
  CHECK(cli::is_beside(square(), sheet(), options));
  CHECK(cli::is_beside({}, {}, options));
}
