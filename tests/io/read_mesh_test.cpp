#include "../../io/read_mesh.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <random>

#include <doctest/doctest.h>

#include "../../io/byte_writer.h"
#include "scratch.h"

using namespace crossloft;

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

const Triangles kFan{{0, 1, 2}, {0, 2, 3}};

void check_square(const Result<Surface>& read) {
  REQUIRE(read.ok());
  REQUIRE(read->points.size() == 4);
  CHECK(read->points[1] == Vec3{1.5, 0, 0});
  CHECK(read->points[3] == Vec3{0, 1, -2});
  CHECK(read->triangles == kFan);
}

template <class T>
void append(std::string& bytes, T value, std::endian order) {
  const std::size_t begin = bytes.size();
  append_little_endian(bytes, value);
  if (order == std::endian::big)
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(begin), bytes.end());
}

/// A square with other properties and elements around what counts.
std::string binary_ply(std::endian order, const std::string& end = "\n") {
  const char* name = order == std::endian::big ? "binary_big_endian" : "binary_little_endian";
  std::string bytes = "ply" + end + "format " + name + " 1.0" + end;
  for (const char* line :
       {"comment element face 7", "element camera 2", "property list uchar float view", "element vertex 4",
        "property uchar red", "property float x", "property double y", "property int16 z",
        "property float quality", "element face 1", "property uint8 flags",
        "property list ushort uint vertex_index", "property list uchar float texcoord", "end_header"}) {
    bytes += line + end;
  }
  append(bytes, std::uint8_t{1}, order), append(bytes, 0.5f, order), append(bytes, std::uint8_t{0}, order);
  const double corners[4][3] = {{0, 0, 0}, {1.5, 0, 0}, {1.5, 1, 0}, {0, 1, -2}};
  for (const auto& corner : corners) {
    append(bytes, std::uint8_t{255}, order);
    append(bytes, static_cast<float>(corner[0]), order), append(bytes, corner[1], order);
    append(bytes, static_cast<std::int16_t>(corner[2]), order);
    append(bytes, std::numeric_limits<float>::quiet_NaN(), order);
  }
  append(bytes, std::uint8_t{9}, order), append(bytes, std::uint16_t{4}, order);
  for (std::uint32_t v = 0; v < 4; ++v) append(bytes, v, order);
  append(bytes, std::uint8_t{1}, order), append(bytes, 0.25f, order);
  return bytes;
}

const std::string kAsciiPly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "property float quality\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0 nan\n1.5 0 0 1\n1.5 1 0 1\n0 1 -2 1\n4 0 1 2 3\n";

const std::string kObj =
    "# a square\nmtllib a.mtl\no square\nv 0 0 0\nv 1.5 0 0 1.0\nv 1.5 1 0 0.5 0.5 0.5\nvt 0 0\nvn 0 0 1\n"
    "v 0 1 -2\nusemtl red#1\ns off\nf 1/1/1 2//1 -2/1 4 # all forms\n";

const std::string kOff =
    "OFF # a square\n# counts\n4 1 0\n\n0 0 0\n1.5 0 0\n1.5 1 0 255 0 0\n0 1 -2\n4  0 1 2 3  1 0 0\n";

const std::string kStl =
    "solid a square\nfacet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1.5 0 0\n  vertex 1.5 1 0\n"
    " endloop\nendfacet\nfacet normal 0 0 1\n outer loop\n  vertex 0 0 -0\n  vertex 1.5 1 0\n  vertex 0 1 "
    "-2\n"
    " endloop\nendfacet\nendsolid a square\n";

std::string binary_stl(const std::string& header, const std::vector<float>& corners) {
  std::string bytes = header;
  bytes.resize(80, ' ');
  append_little_endian(bytes, static_cast<std::uint32_t>(corners.size() / 9));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (i % 9 == 0) bytes.append(12, '\0');
    append_little_endian(bytes, corners[i]);
    if (i % 9 == 8) bytes.append(2, '\0');
  }
  return bytes;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

std::string with_crlf(const std::string& text) {
  std::string out;
  for (const char c : text) c == '\n' ? out += "\r\n" : out += c;
  return out;
}

using Parser = Result<Surface> (*)(std::string_view, std::string);

Result<Surface> parse_stl_quietly(std::string_view bytes, std::string name) {
  return parse_stl(bytes, std::move(name));
}

struct BadInput {
  std::string name;
  Parser parse;
  std::string text;
  ErrorCode code;
  std::uint32_t line;
};

}  // namespace

TEST_CASE("PLY: text and both byte orders, other elements and properties ignored, polygons as fans") {
  check_square(parse_ply(kAsciiPly, ""));
  check_square(parse_ply(with_crlf(kAsciiPly), ""));
  check_square(parse_ply(binary_ply(std::endian::little), ""));
  check_square(parse_ply(binary_ply(std::endian::big), ""));
  check_square(parse_ply(binary_ply(std::endian::little, "\r\n"), ""));
  check_square(parse_ply(binary_ply(std::endian::little, " \t\n"), ""));
  check_square(parse_ply(binary_ply(std::endian::little, " \r\n"), ""));
  check_square(parse_ply(replaced(kAsciiPly, "element face", "element nothing 7\nelement face"), ""));
}

TEST_CASE("PLY: no memory is taken for vertices that take no bytes") {
  std::string header = "ply\nformat ascii 1.0\n";
  for (int i = 0; i < 4000; ++i) header += "element vertex 65536\n";
  const Result<Surface> read = parse_ply(header + "end_header\n", "");
  REQUIRE_FALSE(read.ok());
  CHECK(read.error().code == ErrorCode::syntax);
}

TEST_CASE("OBJ: all forms of corners, other keywords ignored") {
  check_square(parse_obj(kObj, ""));
  check_square(parse_obj(with_crlf(kObj), ""));
}

TEST_CASE("OFF: comments, colours, polygons") {
  check_square(parse_off(kOff, ""));
  check_square(parse_off(with_crlf(kOff), ""));
  check_square(parse_off("C" + kOff, ""));
}

TEST_CASE("STL: text and bytes, equal points become one vertex") {
  Heard heard;
  check_square(parse_stl(kStl, "", heard.context()));
  CHECK(heard.notes.size() == 1);
  check_square(parse_stl(with_crlf(kStl), ""));
  const std::vector<float> corners{0, 0, 0, 1.5f, 0, 0, 1.5f, 1, 0, 0, -0.0f, 0, 1.5f, 1, 0, 0, 1, -2};
  check_square(parse_stl(binary_stl("made by a test", corners), ""));
  check_square(parse_stl(binary_stl("solid in bytes", corners), ""));
}

TEST_CASE("STL: bytes after the last facet are passed over with a warning") {
  Heard heard;
  const std::string bytes = binary_stl("", {0, 0, 0, 1, 0, 0, 1, 1, 0});
  CHECK(parse_stl(bytes, "", heard.context()).ok());
  CHECK(heard.warnings.empty());
  CHECK(parse_stl(bytes + std::string(12, '\0'), "", heard.context()).ok());
  CHECK(heard.warnings ==
        std::vector<std::string>{"12 bytes after the last facet of the STL file were passed over"});
}

TEST_CASE("STL: facets with equal corners are dropped with a warning") {
  Heard heard;
  const Result<Surface> read = parse_stl(binary_stl("", {0, 0, 0, 1, 0, 0, 1, 0, 0}), "", heard.context());
  REQUIRE(read.ok());
  CHECK(read->triangles.empty());
  CHECK(heard.warnings.size() == 1);
}

TEST_CASE("equal points of indexed formats stay different vertices") {
  const Result<Surface> read = parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nf 1 2 3\nf 4 3 2\n", "");
  REQUIRE(read.ok());
  CHECK(read->points.size() == 4);
  CHECK(read->triangles[1][0] == 3);
}

TEST_CASE("bad surfaces") {
  const std::string ply = binary_ply(std::endian::little);
  const std::string header = kAsciiPly.substr(0, kAsciiPly.find("element face"));
  const std::string nan_stl =
      binary_stl("", {0, 0, 0, std::numeric_limits<float>::quiet_NaN(), 0, 0, 1, 1, 0});
  const BadInput corpus[] = {
      {"ply: empty", parse_ply, "", ErrorCode::truncated, 1},
      {"ply: other word", parse_ply, "plx\n", ErrorCode::syntax, 1},
      {"ply: no format", parse_ply, "ply\nelement vertex 0\nend_header\n", ErrorCode::syntax, 3},
      {"ply: unknown format", parse_ply, replaced(kAsciiPly, "ascii", "utf8"), ErrorCode::syntax, 2},
      {"ply: unknown type", parse_ply, replaced(kAsciiPly, "float y", "half y"), ErrorCode::syntax, 5},
      {"ply: unknown keyword", parse_ply, replaced(kAsciiPly, "element face", "elephant face"),
       ErrorCode::syntax, 8},
      {"ply: property first", parse_ply, "ply\nformat ascii 1.0\nproperty int x\n", ErrorCode::syntax, 3},
      {"ply: header cut off", parse_ply, header, ErrorCode::truncated, 8},
      {"ply: negative count", parse_ply, replaced(kAsciiPly, "vertex 4", "vertex -4"), ErrorCode::bad_count,
       3},
      {"ply: huge count", parse_ply, replaced(kAsciiPly, "vertex 4", "vertex 4000000"), ErrorCode::bad_count,
       3},
      {"ply: nan", parse_ply, replaced(kAsciiPly, "1.5 1 0", "1.5 nan 0"), ErrorCode::not_finite, 13},
      {"ply: index", parse_ply, replaced(kAsciiPly, "4 0 1 2 3", "4 0 1 2 4"), ErrorCode::index_out_of_range,
       15},
      {"ply: two corners", parse_ply, replaced(kAsciiPly, "4 0 1 2 3", "2 0 1"), ErrorCode::bad_count, 15},
      {"ply: negative list", parse_ply, replaced(kAsciiPly, "4 0 1 2 3", "-1 0 1"), ErrorCode::bad_count, 15},
      {"ply: list too long", parse_ply, replaced(kAsciiPly, "4 0 1 2 3", "4000000 0"), ErrorCode::truncated,
       16},
      {"ply: text after the end", parse_ply, kAsciiPly + "4 0 1 2 3\n", ErrorCode::syntax, 16},
      {"ply: a byte too many", parse_ply, ply + '\n', ErrorCode::syntax, 0},
      {"ply: bytes cut off", parse_ply, ply.substr(0, ply.size() - 1), ErrorCode::truncated, 0},
      {"obj: index 0", parse_obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", ErrorCode::index_out_of_range, 4},
      {"obj: too large", parse_obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", ErrorCode::index_out_of_range, 4},
      {"obj: too far back", parse_obj, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n", ErrorCode::index_out_of_range,
       4},
      {"obj: least integer", parse_obj, "v 0 0 0\nf -9223372036854775808 1 1\n",
       ErrorCode::index_out_of_range, 2},
      {"obj: no index", parse_obj, "v 0 0 0\nf a b c\n", ErrorCode::syntax, 2},
      {"obj: two corners", parse_obj, "v 0 0 0\nv 1 0 0\nf 1 2\n", ErrorCode::bad_count, 3},
      {"obj: nan", parse_obj, "v 0 0 nan\n", ErrorCode::not_finite, 1},
      {"obj: two coordinates", parse_obj, "v 0 0\nv 1 0 0\n", ErrorCode::syntax, 2},
      {"off: other word", parse_off, "4 1 0\n", ErrorCode::syntax, 1},
      {"off: four coordinates", parse_off, "4OFF\n0 0 0\n", ErrorCode::syntax, 1},
      {"off: huge count", parse_off, replaced(kOff, "4 1 0", "4000000000 1 0"), ErrorCode::bad_count, 3},
      {"off: index", parse_off, replaced(kOff, "0 1 2 3", "0 1 2 4"), ErrorCode::index_out_of_range, 9},
      {"off: corner count", parse_off, replaced(kOff, "4  0", "-4  0"), ErrorCode::bad_count, 9},
      {"off: cut off", parse_off, kOff.substr(0, kOff.find("0 1 -2")), ErrorCode::truncated, 8},
      {"stl: empty", parse_stl_quietly, "", ErrorCode::truncated, 0},
      {"stl: text cut off", parse_stl_quietly, kStl.substr(0, kStl.find("endsolid")), ErrorCode::truncated,
       15},
      {"stl: two corners", parse_stl_quietly, replaced(kStl, "  vertex 1.5 0 0\n", ""), ErrorCode::syntax, 7},
      {"stl: unknown word", parse_stl_quietly, replaced(kStl, "outer", "inner"), ErrorCode::syntax, 3},
      {"stl: infinite", parse_stl_quietly, replaced(kStl, "0 1 -2", "0 1 inf"), ErrorCode::not_finite, 13},
      {"stl: bytes with nan", parse_stl_quietly, nan_stl, ErrorCode::not_finite, 0},
      {"stl: bytes cut off", parse_stl_quietly, nan_stl.substr(0, 120), ErrorCode::truncated, 0},
  };
  for (const BadInput& bad : corpus) {
    CAPTURE(bad.name);
    const Result<Surface> read = bad.parse(bad.text, "bad");
    REQUIRE_FALSE(read.ok());
    CAPTURE(to_string(read.error()));
    CHECK(read.error().code == bad.code);
    CHECK(read.error().line == bad.line);
    CHECK(read.error().file == "bad");
  }
}

TEST_CASE("random damage to a surface is an error or a valid surface") {
  constexpr unsigned kSeed = 11;
  CAPTURE(kSeed);
  std::mt19937 random(kSeed);
  const std::pair<Parser, std::string> files[] = {
      {parse_ply, kAsciiPly},
      {parse_ply, binary_ply(std::endian::little)},
      {parse_ply, binary_ply(std::endian::big)},
      {parse_obj, kObj},
      {parse_off, kOff},
      {parse_stl_quietly, kStl},
      {parse_stl_quietly, binary_stl("", {0, 0, 0, 1, 0, 0, 1, 1, 0})}};
  for (int round = 0; round < 14000; ++round) {
    const auto& [parse, good] = files[round % std::size(files)];
    std::string text = good;
    for (unsigned n = 1 + random() % 3; n > 0; --n)
      text[random() % text.size()] = static_cast<char>(random() % 256);
    const Result<Surface> read = parse(text, "");
    if (!read.ok()) continue;
    for (const Vec3& p : read->points) CHECK(is_finite(p));
    for (const auto& t : read->triangles) CHECK(std::max({t[0], t[1], t[2]}) < read->points.size());
  }
}

TEST_CASE("surfaces and solids from files by extension") {
  const Scratch scratch;
  check_square(read_surface(scratch.add("a.PLY", kAsciiPly)));
  check_square(read_surface(scratch.add("a.obj", kObj)));
  check_square(read_surface(scratch.add("a.off", kOff)));
  check_square(read_surface(scratch.add("a.stl", kStl)));
  CHECK(read_surface(scratch.add("a.vtk", kStl)).error().code == ErrorCode::usage);
  CHECK(read_solid(scratch.path("a.ply")).error().code == ErrorCode::usage);
  CHECK(read_surface(scratch.path("none.ply")).error().code == ErrorCode::file_not_readable);
  CHECK(read_solid(scratch.path("none.mesh")).error().code == ErrorCode::file_not_readable);
}

TEST_CASE("Medit: other sections are passed over") {
  const Result<Solid> read = parse_medit(
      "MeshVersionFormatted 2\n\nDimension\n3\n# comment\nVertices\n4\n0 0 0 1\n1 0 0 1\n0 1 0 1\n0 0 1.5 1\n"
      "Triangles\n1\n1 2 3 7\nTetrahedra\n1\n1 2 3 4 9\nEnd\n",
      "");
  REQUIRE(read.ok());
  CHECK(read->points[3] == Vec3{0, 0, 1.5});
  REQUIRE(read->tets.size() == 1);
  CHECK(read->tets[0] == std::array<std::uint32_t, 4>{0, 1, 2, 3});
}

TEST_CASE("Medit: the word End may be missing, tetrahedra may not") {
  const std::string good =
      "MeshVersionFormatted 1\nDimension 3\nVertices 1\n0 0 0 0\nTetrahedra\n1\n1 1 1 1 0\n";
  CHECK(parse_medit(good, "").ok());
  CHECK(parse_medit(replaced(good, "Tetrahedra\n1\n1 1 1 1 0\n", "Tetrahedra 0\n"), "").ok());
  CHECK(parse_medit(good.substr(0, good.find("Tetra")), "").error().code == ErrorCode::truncated);
}

TEST_CASE("bad solids") {
  const std::string head = "MeshVersionFormatted 2\nDimension 3\nVertices 1\n0 0 0 0\nTetrahedra\n1\n";
  CHECK(parse_medit("", "").error().code == ErrorCode::truncated);
  CHECK(parse_medit("Vertices 0\n", "").error().code == ErrorCode::syntax);
  CHECK(parse_medit("MeshVersionFormatted 1 Dimension 2", "").error().code == ErrorCode::syntax);
  CHECK(parse_medit(head, "").error().code == ErrorCode::truncated);
  CHECK(parse_medit(head + "0 1 1 1 0", "").error().code == ErrorCode::index_out_of_range);
  CHECK(parse_medit(head + "1 1 2 1 0", "").error().line == 7);
  CHECK(parse_vtu("", "").error().code == ErrorCode::syntax);
  CHECK(parse_vtu("<VTKFile type=\"UnstructuredGrid\">", "").error().code == ErrorCode::syntax);
}
