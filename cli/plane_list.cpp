#include "plane_list.h"

#include <charconv>
#include <optional>
#include <string_view>

#include "../io/atomic_file.h"
#include "../io/token_reader.h"

namespace crossloft::cli {
namespace {

constexpr std::string_view kBlank = " \t\r";

/// The numbers of a line, or nothing if something else is on it.
std::optional<std::vector<double>> numbers_of(std::string_view line) {
  std::vector<double> numbers;
  line = line.substr(0, line.find('#'));
  for (;;) {
    line.remove_prefix(std::min(line.size(), line.find_first_not_of(kBlank)));
    if (line.empty()) return numbers;
    if (line.front() == '+') line.remove_prefix(1);
    double number = 0;
    const auto [end, failure] = std::from_chars(line.data(), line.data() + line.size(), number);
    if (failure != std::errc()) return std::nullopt;
    numbers.push_back(number);
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    if (!line.empty() && kBlank.find(line.front()) == kBlank.npos) return std::nullopt;
  }
}

Result<CuttingPlane> plane_of(const std::vector<double>& n, const Error& here) {
  const auto failure = [&here](ErrorCode code, const char* message) {
    Error error = here;
    error.code = code;
    error.message = message;
    return error;
  };
  if (n.size() != 4) return failure(ErrorCode::syntax, "expected four numbers A B C D");
  const CuttingPlane plane{{n[0], n[1], n[2]}, n[3]};
  if (!is_finite(plane.normal) || !std::isfinite(plane.offset)) {
    return failure(ErrorCode::not_finite, "a plane's coefficients must be finite");
  }
  if (plane.normal == Vec3{}) return failure(ErrorCode::zero_normal, "the plane's normal is zero");
  return plane;
}

}  // namespace

Result<std::vector<CuttingPlane>> parse_planes(std::string_view text, const std::string& name) {
  std::vector<CuttingPlane> planes;
  std::string_view rest = without_byte_order_mark(text);
  for (std::uint32_t line = 1; !rest.empty(); ++line) {
    const std::size_t end = std::min(rest.size(), rest.find('\n'));
    const auto numbers = numbers_of(rest.substr(0, end));
    rest.remove_prefix(std::min(rest.size(), end + 1));
    if (numbers && numbers->empty()) continue;
    const auto plane = plane_of(numbers.value_or(std::vector<double>{}), {ErrorCode::syntax, "", name, line});
    if (!plane) return plane.error();
    planes.push_back(*plane);
  }
  if (planes.empty()) return Error{ErrorCode::no_plane, "no plane in the file", name};
  return planes;
}

Result<std::vector<CuttingPlane>> read_planes(const std::string& path) {
  const auto text = read_file(path);
  if (!text) return text.error();
  return parse_planes(*text, path);
}

}  // namespace crossloft::cli
