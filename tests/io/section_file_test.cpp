// A file read plane by plane is the file that is read at once.
#include "../../io/section_file.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "../../inspect/slice.h"
#include "../../inspect/solids.h"
#include "../../io/atomic_file.h"
#include "../../io/read_sections.h"
#include "../../io/write_sections.h"
#include "scratch.h"

using namespace crossloft;

namespace {

namespace fs = std::filesystem;

bool same(const ContourEdge& a, const ContourEdge& b) {
  return a.a == b.a && a.b == b.b && a.material_a == b.material_a && a.material_b == b.material_b &&
         a.contour == b.contour && a.line == b.line;
}

void check_same(const PlaneSection& a, const PlaneSection& b) {
  CHECK(a.normal == b.normal);
  CHECK(a.offset == b.offset);
  CHECK(a.line == b.line);
  CHECK(a.vertices == b.vertices);
  REQUIRE(a.edges.size() == b.edges.size());
  for (std::size_t e = 0; e < a.edges.size(); ++e) CHECK(same(a.edges[e], b.edges[e]));
}

/// Sections or error, and what is told on the way. Planes are read from the last to the first, some twice.
void check_same_as_at_once(const std::string& path) {
  CAPTURE(path);
  Heard told, told_at_once;
  const auto whole = read_sections(path, told_at_once.context());
  auto file = SectionFile::open(path, told.context());
  REQUIRE(file.ok() == whole.ok());
  CHECK(told.notes == told_at_once.notes);
  CHECK(told.warnings == told_at_once.warnings);
  if (!whole) {
    CHECK(to_string(file.error()) == to_string(whole.error()));
    CHECK(file.error().code == whole.error().code);
    return;
  }
  CHECK(file->name() == path);
  REQUIRE(file->plane_count() == whole->planes.size());
  for (std::uint32_t p = file->plane_count(); p-- > 0;)
    for (int twice = 0; twice < 2 - static_cast<int>(p % 2); ++twice) {
      const auto plane = file->read(p);
      REQUIRE(plane.ok());
      check_same(*plane, whole->planes[p]);
    }
}

std::string text_of(const std::string& path) {
  auto text = read_file(path);
  REQUIRE(text.ok());
  return std::move(text).value();
}

/// A stack whose planes have some hundred vertices each.
Sections long_stack() {
  const Surface mesh = gyroid_solid(32);
  auto sections = slice(mesh, parallel_planes(bounds_of(mesh.points), 30));
  REQUIRE(sections.ok());
  return std::move(sections).value();
}

}  // namespace

TEST_CASE("Plane by plane: good files") {
  const fs::path examples = fs::path(CROSSLOFT_SOURCE_DIR) / "examples";
  int count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(examples))
    if (entry.path().extension() == ".contour" || entry.path().extension() == ".csl") {
      check_same_as_at_once(entry.path().string());
      ++count;
    }
  CHECK(count > 5);
}

TEST_CASE("Plane by plane: bad files give the same message") {
  const fs::path bad = fs::path(CROSSLOFT_SOURCE_DIR) / "tests/io/bad";
  int count = 0;
  for (const char* folder : {"contour", "csl"})
    for (const auto& entry : fs::directory_iterator(bad / folder)) {
      check_same_as_at_once(entry.path().string());
      ++count;
    }
  CHECK(count > 20);
  check_same_as_at_once("missing.csl");
  check_same_as_at_once("sections.txt");
  check_same_as_at_once(bad.string());
}

TEST_CASE("Plane by plane: files that are longer than what is held, cut and spoilt anywhere") {
  const Scratch scratch;
  const Sections stack = long_stack();
  for (const std::string name : {"stack.csl", "stack.contour"}) {
    const std::string path = scratch.path(name);
    REQUIRE(write_sections(path, stack).ok());
    check_same_as_at_once(path);
    const std::string text = text_of(path);
    REQUIRE(text.size() > 100000);
    std::mt19937 random(5);
    for (int k = 0; k < 40; ++k) {
      const std::size_t at = random() % text.size();
      REQUIRE(write_file(path, text.substr(0, at)).ok());
      check_same_as_at_once(path);
      std::string spoilt = text;
      spoilt[at] = "x-9 \n\r"[k % 6];
      REQUIRE(write_file(path, spoilt).ok());
      check_same_as_at_once(path);
    }
    REQUIRE(write_file(path, text + std::string(20000, ' ') + "\n\n 7").ok());
    check_same_as_at_once(path);
    std::string lines;
    for (const char c : text) lines += c == '\n' ? std::string("\r\n") : std::string(1, c);
    REQUIRE(write_file(path, lines + std::string(20000, '\n')).ok());
    check_same_as_at_once(path);
  }
}

TEST_CASE("Plane by plane: a count that the file could hold, but not what is left of it") {
  const Scratch scratch;
  const std::string path = scratch.path("stack.contour");
  REQUIRE(write_sections(path, long_stack()).ok());
  const std::string text = text_of(path);
  REQUIRE(text.size() > 100000);
  const std::size_t body = text.find('\n') + 1;
  for (const std::size_t count : {std::size_t{70000}, text.size() - 1000, 2 * text.size()}) {
    REQUIRE(write_file(path, "31\n" + text.substr(body) + "0 0 1 0\n" + std::to_string(count) + " 0\n").ok());
    check_same_as_at_once(path);
  }
}

TEST_CASE("Plane by plane: the sign of D, materials and labels are those of the whole file") {
  const Scratch scratch;
  Sections stack = long_stack();
  for (PlaneSection& plane : stack.planes) plane.offset = -plane.offset;
  for (ContourEdge& e : stack.planes[20].edges) e.material_a = 3;
  const std::string path = scratch.path("negated.contour");
  REQUIRE(write_sections(path, stack).ok());
  check_same_as_at_once(path);
}

TEST_CASE("Plane by plane: cancelling ends it") {
  const Scratch scratch;
  const std::string path = scratch.path("stack.csl");
  REQUIRE(write_sections(path, long_stack()).ok());
  const std::atomic<bool> stop = true;
  Context context;
  context.cancel = &stop;
  const auto file = SectionFile::open(path, context);
  REQUIRE(!file.ok());
  CHECK(file.error().code == ErrorCode::cancelled);
}
