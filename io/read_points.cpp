#include "read_points.h"
#include "../geom/failing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>

#include "atomic_file.h"
#include "byte_reader.h"
#include "file_extension.h"
#include "read_mesh.h"
#include "token_reader.h"

namespace crossloft {
namespace {

/// A point as N numbers: 3, or 4 with a weight.
template <std::size_t N>
using Numbers = std::array<double, N>;

Vec3 to_point(const Numbers<3>& n) { return {n[0], n[1], n[2]}; }
WeightedPoint to_point(const Numbers<4>& n) { return {{n[0], n[1], n[2]}, n[3]}; }

template <std::size_t N>
using Points = std::vector<decltype(to_point(Numbers<N>{}))>;

bool is_finite(const WeightedPoint& p) { return crossloft::is_finite(p.position) && std::isfinite(p.weight); }

Error too_many(const std::string& path) {
  return {.code = ErrorCode::too_large,
          .message = "has more than " + std::to_string(kMostPoints) + " points",
          .file = path};
}

template <std::size_t N>
Numbers<N> read_line(TokenReader& in) {
  static constexpr const char* kNames[] = {"the x of a point", "the y of a point", "the z of a point",
                                           "the weight of a point"};
  const std::string wanted = N == 3 ? ", where a point is x y z" : ", where a point is x y z w";
  Numbers<N> numbers{};
  for (std::size_t i = 0; i < N && in.ok(); ++i) {
    if (i > 0 && in.at_line_end())
      in.fail(ErrorCode::syntax,
              std::to_string(i) + (i == 1 ? " number" : " numbers") + " on the line" + wanted);
    numbers[i] = in.real(kNames[i]);
  }
  if (in.ok() && !in.at_line_end())
    in.fail(ErrorCode::syntax, "more than " + std::to_string(N) + " numbers on the line" + wanted);
  return numbers;
}

/// No more points than lines, nor than the bytes can hold: safe to reserve.
std::size_t room_for_points(std::string_view text) {
  constexpr std::size_t kLeastBytes = 6;  // "0 0 0 "
  const auto is_line_end = [](char c) { return c == '\n' || c == '\r'; };
  const auto lines = std::count_if(text.begin(), text.end(), is_line_end);
  return std::min(static_cast<std::size_t>(lines), text.size() / kLeastBytes) + 1;
}

template <std::size_t N>
Result<Points<N>> parse(std::string_view text, std::string name) {
  Points<N> points;
  points.reserve(room_for_points(text));
  TokenReader in(text, std::move(name), '#');
  while (in.ok() && !in.at_end()) {
    if (points.size() == kMostPoints) return too_many(in.error().file);
    points.push_back(to_point(read_line<N>(in)));
  }
  if (!in.ok()) return in.error();
  return points;
}

template <std::size_t N>
Result<Points<N>> read_text(const std::string& path) {
  const Result<std::string> text = read_file(path);
  if (!text.ok()) return text.error();
  return parse<N>(*text, path);
}

template <std::size_t N>
Result<Done> check_raw(const Points<N>& points, std::uint64_t bytes, const std::string& path) {
  constexpr std::size_t kPointBytes = 8 * N;
  if (bytes % kPointBytes != 0)
    return Error{.code = ErrorCode::truncated,
                 .message = "has " + std::to_string(bytes) + " bytes, which is no multiple of the " +
                            std::to_string(kPointBytes) + " bytes of a point (" + std::to_string(N) +
                            " doubles)",
                 .file = path};
  const auto bad = std::find_if_not(points.begin(), points.end(), [](const auto& p) { return is_finite(p); });
  if (bad != points.end())
    return Error{.code = ErrorCode::not_finite,
                 .message = "point " + std::to_string(bad - points.begin()) +
                            ", counted from 0, has a value that is no finite number",
                 .file = path};
  return Done{};
}

/// Straight into the points: beside them there is but one piece of the file.
template <std::size_t N>
Result<Points<N>> read_raw(const std::string& path) {
  constexpr std::size_t kPointBytes = 8 * N;
  static_assert(kPieceBytes % kPointBytes == 0);
  Points<N> points;
  std::error_code unknown;  // a pipe has no size
  const std::uint64_t size = std::filesystem::file_size(path, unknown);
  if (!unknown && size / kPointBytes > kMostPoints) return too_many(path);
  if (!unknown) points.reserve(static_cast<std::size_t>(size / kPointBytes));
  std::uint64_t bytes = 0;
  const Result<Done> read = read_pieces(path, [&](std::string_view piece) {
    bytes += piece.size();
    ByteReader in(piece);
    while (in.left() >= kPointBytes) {
      Numbers<N> numbers;
      for (double& number : numbers) number = in.read<double>();
      points.push_back(to_point(numbers));
    }
    return points.size() <= kMostPoints;
  });
  if (!read.ok()) return read.error();
  if (points.size() > kMostPoints) return too_many(path);
  if (const Result<Done> good = check_raw<N>(points, bytes, path); !good.ok()) return good.error();
  return points;
}

bool is_text(const std::string& extension) {
  return extension == "txt" || extension == "xyz" || extension == "pts";
}

}  // namespace

Result<std::vector<Vec3>> parse_points(std::string_view text, std::string name) {
  return or_out_of_memory([&]() -> Result<std::vector<Vec3>> { return parse<3>(text, std::move(name)); });
}

Result<std::vector<WeightedPoint>> parse_weighted_points(std::string_view text, std::string name) {
  return or_out_of_memory(
      [&]() -> Result<std::vector<WeightedPoint>> { return parse<4>(text, std::move(name)); });
}

Result<std::vector<Vec3>> read_points(const std::string& path) {
  return or_out_of_memory([&]() -> Result<std::vector<Vec3>> {
    const std::string extension = file_extension(path);
    if (is_text(extension)) return read_text<3>(path);
    if (extension == "f64") return read_raw<3>(path);
    if (extension != "off" && extension != "ply")
      return unknown_extension(path, ".txt, .xyz, .pts, .f64, .off and .ply");
    Result<Surface> surface = read_surface(path);
    if (!surface.ok()) return surface.error();
    if (surface->points.size() > kMostPoints) return too_many(path);
    return std::move(surface->points);
  });
}

Result<std::vector<WeightedPoint>> read_weighted_points(const std::string& path) {
  return or_out_of_memory([&]() -> Result<std::vector<WeightedPoint>> {
    const std::string extension = file_extension(path);
    if (is_text(extension)) return read_text<4>(path);
    if (extension == "f64") return read_raw<4>(path);
    return unknown_extension(path, ".txt, .xyz, .pts and .f64, which have weights");
  });
}

}  // namespace crossloft
