#include "../../geom/vec3.h"

#include <doctest/doctest.h>

#include "../../geom/unit_plane.h"

using namespace crossloft;

TEST_CASE("lengths whose squares leave the doubles") {
  for (const double scale : {5e-324, 1e-310, 1e-200, 1e-140, 1.0, 1e150, 1e200, 1e307}) {
    CAPTURE(scale);
    CHECK(norm({2 * scale, 0, 0}) == 2 * scale);
    CHECK(norm({-3 * scale, 0, 4 * scale}) == doctest::Approx(5 * scale).epsilon(1e-15));
  }
  CHECK(norm({}) == 0);
  CHECK(norm({0, -HUGE_VAL, 0}) == HUGE_VAL);
  CHECK(std::isnan(norm({0, std::nan(""), 1})));
}

TEST_CASE("every plane has one with a normal of length 1") {
  for (const double scale : {1e-310, 1e-200, 1.0, 1e200, 1e307}) {
    CAPTURE(scale);
    const UnitPlane plane = unit_plane({-3 * scale, 0, 4 * scale}, 10 * scale);
    CHECK(plane.normal.x == doctest::Approx(-0.6).epsilon(1e-12));
    CHECK(plane.normal.z == doctest::Approx(0.8).epsilon(1e-12));
    CHECK(plane.offset == doctest::Approx(2).epsilon(1e-12));
    CHECK(plane.height({10 / 3.0, 0, 0}) == doctest::Approx(0));
  }
}
