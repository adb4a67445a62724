#include "../../io/read_points.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <random>

#include <doctest/doctest.h>

#include "../../io/byte_writer.h"
#include "scratch.h"

using namespace crossloft;

namespace {

/// What is wrong with the file or text, as the user sees it.
template <class Points>
std::string complaint(const Result<Points>& points) {
  REQUIRE(!points.ok());
  return to_string(points.error());
}

std::string raw(const std::vector<double>& numbers) {
  std::string bytes;
  for (const double number : numbers) append_little_endian(bytes, number);
  return bytes;
}

/// Doubles of all magnitudes, `count` of them.
std::vector<double> random_numbers(std::size_t count) {
  constexpr unsigned kSeed = 11;
  MESSAGE("seed " << kSeed);
  std::mt19937_64 random(kSeed);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-1000, 1000);
  std::vector<double> numbers;
  while (numbers.size() < count) numbers.push_back(std::ldexp(mantissa(random), exponent(random)));
  return numbers;
}

}  // namespace

TEST_CASE("points: x y z a line, comments, blank lines, any line ends") {
  const auto points = parse_points("# x y z\n1 2 3\n\n  -3.5 4e-1 +2 # last\r\n0 0 -0\r7 8 9", "");
  REQUIRE(points.ok());
  CHECK(*points == std::vector<Vec3>{{1, 2, 3}, {-3.5, 0.4, 2}, {0, 0, 0}, {7, 8, 9}});
  CHECK(std::signbit((*points)[2].z));
}

TEST_CASE("points: a comment may follow a number without a blank") {
  const auto points = parse_points("1 2 3# last\n4 5 6#\n", "");
  REQUIRE(points.ok());
  CHECK(*points == std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}});
  CHECK(complaint(parse_points("1 2#3\n", "p.txt")).starts_with("p.txt:1: 2 numbers on the line"));
}

TEST_CASE("points: a weight is the fourth number") {
  const auto points = parse_weighted_points("1 2 3 4\n0 0 0 -0.5\n", "");
  REQUIRE(points.ok());
  REQUIRE(points->size() == 2);
  CHECK((*points)[0].position == Vec3{1, 2, 3});
  CHECK((*points)[0].weight == 4);
  CHECK((*points)[1].weight == -0.5);
}

TEST_CASE("points: none at all is good") {
  for (const char* text : {"", "\n\r\n", "# nothing\n"}) {
    CHECK(parse_points(text, "")->empty());
    CHECK(parse_weighted_points(text, "")->empty());
  }
}

TEST_CASE("points: a bad line is named") {
  const auto plain = [](std::string_view text) { return complaint(parse_points(text, "p.txt")); };
  CHECK(plain("0 0 0\n1\n") == "p.txt:2: 1 number on the line, where a point is x y z");
  CHECK(plain("0 0 0\n\n1 2\n3\n") == "p.txt:3: 2 numbers on the line, where a point is x y z");
  CHECK(plain("0 0 0 1\n") == "p.txt:1: more than 3 numbers on the line, where a point is x y z");
  CHECK(plain("0 0 0\n1 two 3\n") == "p.txt:2: 'two' stands where the y of a point should be");
  CHECK(plain("1,2,3\n") == "p.txt:1: '1,2,3' stands where the x of a point should be");
  CHECK(plain("0 0 nan\n").starts_with("p.txt:1: the z of a point is 'nan'"));
  CHECK(plain("\n1e999 0 0\n").starts_with("p.txt:2: the x of a point is '1e999'"));
  const auto weighted = [](std::string_view text) { return complaint(parse_weighted_points(text, "p.txt")); };
  CHECK(weighted("0 0 0\n") == "p.txt:1: 3 numbers on the line, where a point is x y z w");
  CHECK(weighted("1 2 3 4 5\n") == "p.txt:1: more than 4 numbers on the line, where a point is x y z w");
  CHECK(weighted("1 2 3 inf\n").starts_with("p.txt:1: the weight of a point is 'inf'"));
}

TEST_CASE("points: raw doubles keep all bits, over the ends of pieces too") {
  const Scratch scratch;
  const std::vector<double> numbers = random_numbers(12 * 1000);
  const std::string path = scratch.add("a.F64", raw(numbers));
  const auto points = read_points(path);
  REQUIRE(points.ok());
  REQUIRE(points->size() == 4000);
  for (std::size_t i = 0; i < 4000; ++i)
    CHECK((*points)[i] == Vec3{numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]});
  const auto weighted = read_weighted_points(path);
  REQUIRE(weighted.ok());
  REQUIRE(weighted->size() == 3000);
  for (std::size_t i = 0; i < 3000; ++i) {
    CHECK((*weighted)[i].position == Vec3{numbers[4 * i], numbers[4 * i + 1], numbers[4 * i + 2]});
    CHECK((*weighted)[i].weight == numbers[4 * i + 3]);
  }
  CHECK(read_points(scratch.add("none.f64", ""))->empty());
}

TEST_CASE("points: raw doubles that are no points") {
  const Scratch scratch;
  const std::string half = scratch.add("half.f64", raw({0, 0, 0, 1}));
  CHECK(complaint(read_points(half)) ==
        half + ": has 32 bytes, which is no multiple of the 24 bytes of a point (3 doubles)");
  CHECK(read_points(half).error().code == ErrorCode::truncated);
  CHECK(read_weighted_points(half).ok());
  const std::string odd = scratch.add("odd.f64", raw({0, 0, 0}) + "x");
  CHECK(complaint(read_points(odd)).find("has 25 bytes") != std::string::npos);
  CHECK(complaint(read_weighted_points(odd)).find("25 bytes, which is no multiple of the 32") !=
        std::string::npos);
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const std::string infinite = scratch.add("inf.f64", raw({0, 0, 0, 1, 1, 1, 2, kInfinite, 2}));
  CHECK(complaint(read_points(infinite)) ==
        infinite + ": point 2, counted from 0, has a value that is no finite number");
  const std::string weight = scratch.add("nan.f64", raw({0, 0, 0, std::nan("")}));
  CHECK(complaint(read_weighted_points(weight)).find("point 0, counted") != std::string::npos);
  const std::string huge = scratch.add("huge.f64", "");
  std::filesystem::resize_file(huge, 24 * (kMostPoints + 1));  // a hole, which takes no room on the disk
  CHECK(read_points(huge).error().code == ErrorCode::too_large);
}

TEST_CASE("points: the vertices of surfaces, with or without faces") {
  const Scratch scratch;
  const std::vector<Vec3> expected{{0, 0, 0}, {1, 0, 0}, {0, 0.1, -3}};
  const std::string vertices = "0 0 0\n1 0 0\n0 0.1 -3\n";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
      "property double z\n";
  for (const std::string& path :
       {scratch.add("a.off", "OFF\n3 0 0\n" + vertices),
        scratch.add("b.OFF", "OFF\n3 1 0\n" + vertices + "3 0 1 2\n"),
        scratch.add("a.ply", ply + "end_header\n" + vertices),
        scratch.add("b.ply", ply + "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
                                 vertices + "3 0 1 2\n")}) {
    CAPTURE(path);
    const auto points = read_points(path);
    REQUIRE(points.ok());
    CHECK(*points == expected);
    CHECK(read_weighted_points(path).error().code == ErrorCode::usage);
  }
  CHECK(read_points(scratch.add("c.off", "OFF\n3 0 0\n0 0 0\n")).error().code == ErrorCode::truncated);
}

TEST_CASE("points: the extension decides") {
  const Scratch scratch;
  for (const char* name : {"a.txt", "a.xyz", "a.PTS"}) {
    CHECK(read_points(scratch.add(name, "1 2 3\n"))->front() == Vec3{1, 2, 3});
    CHECK(read_weighted_points(scratch.add(name, "1 2 3 4\n"))->front().weight == 4);
  }
  CHECK(read_points(scratch.add("a.stl", "")).error().code == ErrorCode::usage);
  CHECK(read_weighted_points(scratch.add("a", "")).error().code == ErrorCode::usage);
  for (const char* name : {"none.txt", "none.f64", "none.off", "none.ply"})
    CHECK(read_points(scratch.path(name)).error().code == ErrorCode::file_not_readable);
}
