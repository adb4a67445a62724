#include "../../io/read_sites.h"

#include <doctest/doctest.h>

#include "scratch.h"

using namespace crossloft;

namespace {

/// What is wrong with the text, as the user sees it.
std::string complaint(std::string_view text) {
  const auto sites = parse_sites(text, "s.txt");
  REQUIRE(!sites.ok());
  return to_string(sites.error());
}

}  // namespace

TEST_CASE("sites: two to four numbers a line, comments, any line ends") {
  const auto sites = parse_sites("# x y lambda mu\n1 2\n\n  -3.5 4e-1 +2 # heavy\r\n0 0 -1 0.25\r7 8 0", "");
  REQUIRE(sites.ok());
  REQUIRE(sites->size() == 4);
  CHECK((*sites)[0].p == Vec2{1, 2});
  CHECK((*sites)[0].lambda == 1);
  CHECK((*sites)[0].mu == 0);
  CHECK((*sites)[1].p == Vec2{-3.5, 0.4});
  CHECK((*sites)[1].lambda == 2);
  CHECK((*sites)[2].lambda == -1);
  CHECK((*sites)[2].mu == 0.25);
  CHECK((*sites)[3].lambda == 0);
}

TEST_CASE("sites: a bad line is named") {
  CHECK(complaint("0 0\n1 two\n") == "s.txt:2: 'two' stands where the y of a site should be");
  CHECK(complaint("0 0\n\n1\n2 3\n") == "s.txt:3: one number, where a site is x y [lambda [mu]]");
  CHECK(complaint("0 0 1 2 3\n").starts_with("s.txt:1: more than four numbers"));
  CHECK(complaint("0 0 1 nan\n").starts_with("s.txt:1: the mu of a site is 'nan'"));
  CHECK(complaint("0 0\n1e999 0\n").starts_with("s.txt:2: the x of a site is '1e999'"));
  CHECK(complaint("0 0 1,5\n").starts_with("s.txt:1: '1,5' stands where the lambda"));
}

TEST_CASE("sites: a file without a site is an error") {
  for (const char* text : {"", "\n\n", "# nothing\n"}) {
    const auto sites = parse_sites(text, "s.txt");
    REQUIRE(!sites.ok());
    CHECK(sites.error().code == ErrorCode::truncated);
  }
}

TEST_CASE("sites: read from a file") {
  const Scratch scratch;
  const auto sites = read_sites(scratch.add("a.txt", "1 2 3 4\n"));
  REQUIRE(sites.ok());
  CHECK(sites->front().mu == 4);
  const auto missing = read_sites(scratch.path("missing.txt"));
  REQUIRE(!missing.ok());
  CHECK(missing.error().code == ErrorCode::file_not_readable);
}
