#include "../../inspect/info.h"

#include <doctest/doctest.h>

#include "../arrangement/polygon_sections.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

/// Disks in z = 0 and z = 1.
Sections two_disks() { return {"", {disk({0, 0, 1}, {0, 0, 0}), disk({0, 0, 1}, {0, 0, 1})}}; }

}  // namespace

TEST_CASE("normals of any length are told with length 1") {
  for (const double scale : {1e-320, 1e-200, 3.0, 1e155, 1.5e308}) {
    CAPTURE(scale);
    Sections s = two_disks();
    for (PlaneSection& p : s.planes) p.normal = scale * p.normal, p.offset *= scale;
    const auto info = examine(s);
    REQUIRE(info.ok());
    CHECK(info->planes[1].normal == Vec3{0, 0, 1});
    CHECK(info->planes[1].offset == -1);
  }
}
