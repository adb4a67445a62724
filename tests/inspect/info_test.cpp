#include "../../inspect/info.h"

#include <doctest/doctest.h>

#include "../arrangement/polygon_sections.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

/// Disks in z = 0 and z = 1.
Sections two_disks() { return {"", {disk({0, 0, 1}, {0, 0, 0}), disk({0, 0, 1}, {0, 0, 1})}}; }

}  // namespace

TEST_CASE("the log hears all notes and warnings, each once") {
  Sections s = two_disks();
  s.planes.push_back(s.planes[1]);
  add_contour(s.planes[1], {{5, 5, 1}, {6, 6, 1}}, 1);
  std::vector<std::string> notes, warnings;
  Context context;
  context.log = [&](LogLevel level, std::string_view text) {
    (level == LogLevel::note ? notes : warnings).emplace_back(text);
  };
  const auto info = examine(s, 1e-3, context);
  REQUIRE(info.ok());
  CHECK_FALSE(notes.empty());
  CHECK_FALSE(warnings.empty());
  CHECK(notes == info->notes);
  CHECK(warnings == info->warnings);
}

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

TEST_CASE("coordinates beyond 1e100 are an error") {
  Sections s = two_disks();
  s.planes[1].line = 7;
  s.planes[1].vertices[0].x = 1.1e100;
  const auto info = examine(s);
  REQUIRE_FALSE(info.ok());
  CHECK(info.error().code == ErrorCode::too_large);
  CHECK(info.error().plane == 1);
  CHECK(info.error().line == 7);
}
