#include "../../io/read_sections.h"

#include <algorithm>
#include <clocale>
#include <cmath>
#include <random>

#include <doctest/doctest.h>

#include "../../io/write_sections.h"
#include "scratch.h"
#include "section_texts.h"

using namespace crossloft;
using section_texts::kSquareWithHole;
using section_texts::kTwoSquares;

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string with_line_ends(const std::string& text, const std::string& end) {
  std::string out;
  for (const char c : text) c == '\n' ? out += end : out += c;
  return out;
}

/// Equal but for source and line numbers.
bool same_data(const Sections& a, const Sections& b) { return format_contour(a) == format_contour(b); }

}  // namespace

TEST_CASE("a .contour file gives planes, vertices, edges and their lines") {
  const Result<Sections> read = parse_contour(kTwoSquares, "a.contour");
  REQUIRE(read.ok());
  CHECK(read->source == "a.contour");
  REQUIRE(read->planes.size() == 2);
  const PlaneSection& top = read->planes[1];
  CHECK(top.normal == Vec3{0, 0, 2});
  CHECK(top.offset == -2);
  CHECK(top.line == 13);
  REQUIRE(top.vertices.size() == 4);
  CHECK(top.vertices[2] == Vec3{1, 1, 1});
  REQUIRE(top.edges.size() == 4);
  CHECK(top.edges[3].a == 3);
  CHECK(top.edges[3].b == 0);
  CHECK(top.edges[3].material_a == 1);
  CHECK(top.edges[3].material_b == 0);
  CHECK(top.edges[3].line == 22);
}

TEST_CASE("contours of .contour are components in order of first appearance") {
  const Result<Sections> read = parse_contour(
      "1\n0 0 1 0\n6 6\n0 0 0 1 0 0 0 1 0 5 0 0 6 0 0 5 1 0\n"
      "3 4 1 0  0 1 1 0  4 5 1 0  1 2 1 0  5 3 1 0  2 0 1 0\n",
      "");
  REQUIRE(read.ok());
  const std::vector<std::uint32_t> expected{0, 1, 0, 1, 0, 1};
  for (std::size_t e = 0; e < expected.size(); ++e) CHECK(read->planes[0].edges[e].contour == expected[e]);
}

TEST_CASE("a contour that repeats its first vertex at the end is closed") {
  const Result<Sections> read =
      parse_contour("1\n0 0 1 0\n4 3\n0 0 0 1 0 0 0 1 0 0 0 0\n0 1 1 0\n1 2 1 0\n2 3 1 0\n", "");
  REQUIRE(read.ok());
  CHECK(read->planes[0].vertices.size() == 4);
  CHECK(read->planes[0].edges[2].b == 0);

  const Result<Sections> csl =
      parse_csl("CSLC 1 2\n1 4 1 0 0 1 0\n0 0 0 1 0 0 0 1 0 0 0 0\n5 1 0 1 2 3 0\n", "");
  REQUIRE(csl.ok());
  CHECK(csl->planes[0].edges.size() == 3);
}

TEST_CASE("a .csl file gives components, holes and empty planes") {
  const Result<Sections> read = parse_csl(kSquareWithHole, "a.csl");
  REQUIRE(read.ok());
  REQUIRE(read->planes.size() == 2);
  const PlaneSection& plane = read->planes[0];
  CHECK(plane.line == 4);
  REQUIRE(plane.edges.size() == 12);
  CHECK(plane.edges[4].a == 7);
  CHECK(plane.edges[4].b == 6);
  CHECK(plane.edges[4].contour == 1);
  CHECK(plane.edges[4].line == 19);
  CHECK(plane.edges[7].b == 7);
  for (const ContourEdge& edge : plane.edges) CHECK((edge.material_a == 1 && edge.material_b == 0));
  CHECK(read->planes[1].vertices.empty());
  CHECK(read->planes[1].edges.empty());
}

TEST_CASE("labels: a hole has its parent's, numbers below 1 are taken as 1, several are told") {
  Heard heard;
  const std::string text = replaced(kSquareWithHole, "4 1 0 1", "4 7 0 1");
  const Result<Sections> read = parse_csl(replaced(text, "4 1 8", "4 0 8"), "", heard.context());
  REQUIRE(read.ok());
  CHECK(read->planes[0].edges[0].material_a == 7);
  CHECK(read->planes[0].edges[4].material_a == 7);
  CHECK(read->planes[0].edges[8].material_a == 1);
  CHECK(heard.warnings.size() == 1);
  CHECK(heard.notes == std::vector<std::string>{"the sections have 2 materials: inside is any of them"});
}

TEST_CASE("line ends, blank lines, a byte order mark and NLABELS change nothing") {
  const Sections contour = *parse_contour(kTwoSquares, "");
  const Sections csl = *parse_csl(kSquareWithHole, "");
  for (const std::string end : {"\r\n", "\r", "\n\n", " \t\r\n"}) {
    CHECK(same_data(*parse_contour(with_line_ends(kTwoSquares, end), ""), contour));
    CHECK(same_data(*parse_csl(with_line_ends(kSquareWithHole, end), ""), csl));
  }
  CHECK(same_data(*parse_contour("\xEF\xBB\xBF" + kTwoSquares, ""), contour));
  CHECK(same_data(*parse_csl(replaced(kSquareWithHole, "2 2\n", "2 99\n"), ""), csl));
  const Result<Sections> crlf = parse_contour(with_line_ends(kTwoSquares, "\r\n"), "");
  CHECK(crlf->planes[1].edges[3].line == 22);
  const Result<Sections> cr = parse_contour(with_line_ends(kTwoSquares, "\r"), "");
  CHECK(cr->planes[1].edges[3].line == 22);
}

TEST_CASE("the sign of D is one for the whole file and follows the vertices") {
  Heard heard;
  const std::string flipped = replaced(kTwoSquares, "0 0 2 -2", "0 0 2 2");
  const Result<Sections> read = parse_contour(flipped, "", heard.context());
  REQUIRE(read.ok());
  CHECK(read->planes[1].offset == -2);
  CHECK(std::signbit(read->planes[1].offset));
  CHECK(heard.notes.size() == 1);
  CHECK(heard.warnings.empty());

  // An empty plane has no vertices of its own to tell.
  const Result<Sections> csl = parse_csl(replaced(replaced(kSquareWithHole, "-5", "5"), "-6", "6"), "");
  REQUIRE(csl.ok());
  CHECK(csl->planes[1].offset == -6);
}

TEST_CASE("forms of numbers") {
  const auto first = [](const std::string& number) {
    const Result<Sections> read = parse_contour("1 0 0 1 0 1 0\n" + number + " 0 0\n", "");
    REQUIRE(read.ok());
    return read->planes[0].vertices[0].x;
  };
  CHECK(first("1.5e3") == 1500);
  CHECK(first("+2.5E-1") == 0.25);
  CHECK(first("0.") == 0);
  CHECK(first("-.5") == -0.5);
  CHECK(first("0.1000000000000000055511151231257827021181583404541015625") == 0.1);
  CHECK(first("9007199254740993") == 9007199254740992.0);  // a tie, to even
  CHECK(first("1e-400") == 0);
  CHECK(first("-0.00000001e-390") == 0);
  CHECK(first("5e-324") == 5e-324);
  CHECK(first("1.7976931348623157e308") == 1.7976931348623157e308);
}

TEST_CASE("numbers do not depend on the locale") {
  const char* set = std::setlocale(LC_ALL, "de_DE.UTF-8");
  const Result<Sections> read = parse_contour("1 0 0 1 0 1 0 0.5 0 0", "");
  CHECK(read->planes[0].vertices[0].x == 0.5);
  CHECK(format_contour(*read).find(',') == std::string::npos);
  if (set != nullptr) std::setlocale(LC_ALL, "C");
}

namespace {

struct BadInput {
  std::string name;
  std::string text;
  ErrorCode code;
  std::uint32_t line;
  std::uint32_t plane = kNone;
  std::uint32_t contour = kNone;
};

void check_error(const BadInput& bad, const Result<Sections>& read) {
  CAPTURE(bad.name);
  REQUIRE_FALSE(read.ok());
  const Error& error = read.error();
  CAPTURE(to_string(error));
  CHECK(error.code == bad.code);
  CHECK(error.file == "bad");
  CHECK(error.line == bad.line);
  CHECK(error.plane == bad.plane);
  CHECK(error.contour == bad.contour);
  CHECK_FALSE(error.message.empty());
  CHECK(error.message.find('\n') == std::string::npos);
}

}  // namespace

TEST_CASE("bad .contour files") {
  const std::string& good = kTwoSquares;
  const BadInput corpus[] = {
      {"empty", "", ErrorCode::truncated, 1},
      {"blank", "\n \n", ErrorCode::truncated, 3},
      {"no number", "hello", ErrorCode::syntax, 1},
      {"binary", std::string("\0\1\2 \377", 5), ErrorCode::syntax, 1},
      {"no plane", "0\n", ErrorCode::no_plane, 1},
      {"negative count of planes", "-3\n", ErrorCode::bad_count, 1},
      {"fractional count of planes", "1.5\n", ErrorCode::bad_count, 1},
      {"huge count of planes", "4000000000\n", ErrorCode::bad_count, 1},
      {"count beyond 64 bits", "99999999999999999999\n", ErrorCode::bad_count, 1},
      {"nan count", "nan\n", ErrorCode::bad_count, 1},
      {"negative count of vertices", replaced(good, "4 4", "-4 4"), ErrorCode::bad_count, 3, 0},
      {"huge count of vertices", replaced(good, "4 4", "1000000000 4"), ErrorCode::bad_count, 3, 0},
      {"fractional count of edges", replaced(good, "4 4", "4 4.5"), ErrorCode::bad_count, 3, 0},
      {"count of edges in scientific notation", replaced(good, "4 4", "4 1e30"), ErrorCode::bad_count, 3, 0},
      {"too many vertices said", replaced(good, "-2\n4 4", "-2\n400 4"), ErrorCode::truncated, 23, 1},
      {"vertices cut off", good.substr(0, good.find("1 1 0")), ErrorCode::truncated, 6, 0},
      {"planes cut off", good.substr(0, good.find("0 0 2 -2")), ErrorCode::truncated, 13, 1},
      {"nan", replaced(good, "1 1 0", "1 nan 0"), ErrorCode::not_finite, 6, 0},
      {"infinity", replaced(good, "0 1 1\n0 1 1", "0 -INF 1\n0 1 1"), ErrorCode::not_finite, 18, 1},
      {"beyond a double", replaced(good, "1 1 0", "1e999 1 0"), ErrorCode::not_finite, 6, 0},
      {"nan in the normal", replaced(good, "0 0 1 0", "0 0 NaN 0"), ErrorCode::not_finite, 2, 0},
      {"infinite offset", replaced(good, "0 0 1 0", "0 0 1 inf"), ErrorCode::not_finite, 2, 0},
      {"word in a vertex", replaced(good, "1 1 0", "1 one 0"), ErrorCode::syntax, 6, 0},
      {"decimal comma", replaced(good, "1 1 0", "1,5 1 0"), ErrorCode::syntax, 6, 0},
      {"hexadecimal", replaced(good, "1 1 0", "0x1p0 1 0"), ErrorCode::syntax, 6, 0},
      {"zero normal", replaced(good, "0 0 2 -2", "0 -0 0 -2"), ErrorCode::zero_normal, 13, 1},
      {"index too large", replaced(good, "2 3 1 0", "2 4 1 0"), ErrorCode::index_out_of_range, 10, 0},
      {"negative index", replaced(good, "2 3 1 0", "-1 3 1 0"), ErrorCode::index_out_of_range, 10, 0},
      {"index beyond 32 bits", replaced(good, "2 3 1 0", "4294967298 3 1 0"), ErrorCode::index_out_of_range,
       10, 0},
      {"fractional index", replaced(good, "2 3 1 0", "2.5 3 1 0"), ErrorCode::syntax, 10, 0},
      {"fractional material", replaced(good, "2 3 1 0", "2 3 0.5 0"), ErrorCode::syntax, 10, 0},
      {"material beyond 32 bits", replaced(good, "2 3 1 0", "2 3 3000000000 0"), ErrorCode::syntax, 10, 0},
      {"text after the end", good + "\n0 0 1 0\n", ErrorCode::syntax, 24},
      {"comment", "# two planes\n" + good, ErrorCode::syntax, 1},
  };
  for (const BadInput& bad : corpus) check_error(bad, parse_contour(bad.text, "bad"));
}

TEST_CASE("bad .csl files") {
  const std::string& good = kSquareWithHole;
  const BadInput corpus[] = {
      {"empty", "", ErrorCode::truncated, 1},
      {"other keyword", "CSL\n1 1\n", ErrorCode::syntax, 1},
      {"no plane", "CSLC\n0 2\n", ErrorCode::no_plane, 2},
      {"negative count of planes", "CSLC\n-1 2\n", ErrorCode::bad_count, 2},
      {"labels missing", "CSLC\n1\n", ErrorCode::truncated, 3},
      {"huge count of vertices", replaced(good, "1 12 3", "1 3000000000 3"), ErrorCode::bad_count, 4, 0},
      {"fractional count of components", replaced(good, "1 12 3", "1 12 2.5"), ErrorCode::bad_count, 4, 0},
      {"count of components negative", replaced(good, "1 12 3", "1 12 -3"), ErrorCode::bad_count, 4, 0},
      {"zero normal", replaced(good, "0 0 1 -5", "0 0 0 -5"), ErrorCode::zero_normal, 4, 0},
      {"infinite vertex", replaced(good, "8 8 5", "8 inf 5"), ErrorCode::not_finite, 12, 0},
      {"size of a component negative", replaced(good, "4 1 8", "-4 1 8"), ErrorCode::bad_count, 20, 0, 2},
      {"size of a component huge", replaced(good, "4 1 8", "4000000 1 8"), ErrorCode::bad_count, 20, 0, 2},
      {"hole without a parent", replaced(good, "4h0", "4h"), ErrorCode::syntax, 19, 0, 1},
      {"hole of a missing parent", replaced(good, "4h0", "4h3"), ErrorCode::index_out_of_range, 19, 0, 1},
      {"hole of a negative parent", replaced(good, "4h0", "4h-1"), ErrorCode::index_out_of_range, 19, 0, 1},
      {"hole of a fractional parent", replaced(good, "4h0", "4h0.5"), ErrorCode::syntax, 19, 0, 1},
      {"hole without a size", replaced(good, "4h0", "h0"), ErrorCode::syntax, 19, 0, 1},
      {"label is a word", replaced(good, "4h0 2", "4h0 two"), ErrorCode::syntax, 19, 0, 1},
      {"index too large", replaced(good, "10 11\n", "10 12\n"), ErrorCode::index_out_of_range, 20, 0, 2},
      {"index negative", replaced(good, "10 11\n", "-10 11\n"), ErrorCode::index_out_of_range, 20, 0, 2},
      {"component cut off", good.substr(0, good.find(" 10 11")), ErrorCode::truncated, 20, 0, 2},
      {"plane cut off", good.substr(0, good.size() - 4), ErrorCode::truncated, 22, 1},
      {"text after the end", good + "3 0 0 0 0 1 -7\n", ErrorCode::syntax, 23},
  };
  for (const BadInput& bad : corpus) check_error(bad, parse_csl(bad.text, "bad"));
}

TEST_CASE("messages are sentences that name the place and quote the text safely") {
  const Result<Sections> word = parse_contour(replaced(kTwoSquares, "1 1 0", "1 o\x1bne 0"), "a.contour");
  CHECK(to_string(word.error()) == "a.contour:6: plane 0: 'o?ne' stands where a vertex coordinate should be");
  const Result<Sections> index = parse_csl(replaced(kSquareWithHole, "10 11\n", "10 12\n"), "a.csl");
  CHECK(to_string(index.error()) ==
        "a.csl:20: plane 0, contour 2: a vertex of a component is '12', but there are 12, counted from 0");
  const Result<Sections> longer = parse_contour(std::string(10000, 'x'), "");
  CHECK(longer.error().message.size() < 100);
}

TEST_CASE("a text cut anywhere is an error or complete, and never more") {
  for (std::size_t size = 0; size < kTwoSquares.size(); ++size) {
    const Result<Sections> read = parse_contour(kTwoSquares.substr(0, size), "");
    CHECK((!read.ok() || size >= kTwoSquares.size() - 1));
  }
  for (std::size_t size = 0; size < kSquareWithHole.size(); ++size) {
    const Result<Sections> read = parse_csl(kSquareWithHole.substr(0, size), "");
    CHECK((!read.ok() || size >= kSquareWithHole.size() - 2));
  }
}

TEST_CASE("random damage is an error or valid data") {
  constexpr unsigned kSeed = 20070917;
  CAPTURE(kSeed);
  std::mt19937 random(kSeed);
  const std::string alphabet = "0123456789.-+eEh \n\rnaif#x";
  for (int round = 0; round < 20000; ++round) {
    const bool csl = round % 2 == 0;
    std::string text = csl ? kSquareWithHole : kTwoSquares;
    for (unsigned n = 1 + random() % 3; n > 0; --n)
      text[random() % text.size()] = alphabet[random() % alphabet.size()];
    const Result<Sections> read = csl ? parse_csl(text, "") : parse_contour(text, "");
    if (!read.ok()) continue;
    for (const PlaneSection& plane : read->planes) {
      CHECK(plane.normal != Vec3{});
      for (const ContourEdge& edge : plane.edges) CHECK(std::max(edge.a, edge.b) < plane.vertices.size());
    }
  }
}

TEST_CASE("files: extension, missing file, directory") {
  const Scratch scratch;
  CHECK(read_sections(scratch.add("A.CONTOUR", kTwoSquares)).ok());
  CHECK(read_sections(scratch.add("a.b.Csl", kSquareWithHole)).ok());
  CHECK(read_sections(scratch.add("a.txt", kTwoSquares)).error().code == ErrorCode::usage);
  CHECK(read_sections(scratch.add("contour", kTwoSquares)).error().code == ErrorCode::usage);
  const Result<Sections> missing = read_sections(scratch.path("none.csl"));
  CHECK(missing.error().code == ErrorCode::file_not_readable);
  CHECK(missing.error().file == scratch.path("none.csl"));
  std::filesystem::create_directory(scratch.path("d.csl"));
  CHECK(read_sections(scratch.path("d.csl")).error().message == "cannot be read: it is a directory");
}

TEST_CASE("reading ends when the context is cancelled") {
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  CHECK(parse_contour(kTwoSquares, "", context).error().code == ErrorCode::cancelled);
  CHECK(parse_csl(kSquareWithHole, "", context).error().code == ErrorCode::cancelled);
}

TEST_CASE("the scenes of the figures") {
  struct Scene {
    std::string name;
    std::size_t planes, vertices, contours;
  };
  const Scene scenes[] = {{"fig14p", 6, 440, 6},       {"fig16_center", 2, 144, 5},
                          {"fig16_one_two", 2, 88, 3}, {"fig16_shift", 2, 144, 5},
                          {"fig17", 2, 88, 3},         {"fig17_cross", 2, 579, 2},
                          {"fig18", 2, 160, 2},        {"fig19", 2, 164, 5},
                          {"fig20", 2, 266, 6},        {"fig20b", 2, 182, 4}};
  for (const Scene& scene : scenes) {
    CAPTURE(scene.name);
    Heard heard;
    const std::string directory = std::string(CROSSLOFT_SOURCE_DIR) + "/examples/figures/";
    const Result<Sections> read = read_sections(directory + scene.name + ".contour", heard.context());
    REQUIRE(read.ok());
    CHECK(heard.notes.empty());
    std::size_t vertices = 0, contours = 0;
    for (const PlaneSection& plane : read->planes) {
      vertices += plane.vertices.size();
      std::size_t in_plane = 0;
      for (const ContourEdge& edge : plane.edges)
        in_plane = std::max<std::size_t>(in_plane, edge.contour + 1);
      contours += in_plane;
    }
    CHECK(read->planes.size() == scene.planes);
    CHECK(vertices == scene.vertices);
    CHECK(contours == scene.contours);
  }
}
