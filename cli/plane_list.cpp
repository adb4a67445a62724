#include "plane_list.h"

#include <array>

#include "../io/atomic_file.h"
#include "../io/token_reader.h"

namespace crossloft::cli {
namespace {

CuttingPlane read_line(TokenReader& in) {
  constexpr const char* kWrongCount = "expected four numbers A B C D";
  std::array<double, 4> n{};
  for (std::size_t i = 0; i < n.size(); ++i) {
    if (i > 0 && in.at_line_end()) in.fail(ErrorCode::syntax, kWrongCount);
    n[i] = in.real("a coefficient of a plane");
  }
  if (!in.at_line_end()) in.fail(ErrorCode::syntax, kWrongCount);
  const CuttingPlane plane{{n[0], n[1], n[2]}, n[3]};
  if (plane.normal == Vec3{}) in.fail(ErrorCode::zero_normal, "the plane's normal is zero");
  return plane;
}

}  // namespace

Result<std::vector<CuttingPlane>> parse_planes(std::string_view text, const std::string& name) {
  std::vector<CuttingPlane> planes;
  TokenReader in(text, name, '#');
  while (in.ok() && !in.at_end()) planes.push_back(read_line(in));
  if (!in.ok()) return in.error();
  if (planes.empty()) return Error{ErrorCode::no_plane, "no plane in the file", name};
  return planes;
}

Result<std::vector<CuttingPlane>> read_planes(const std::string& path) {
  const auto text = read_file(path);
  if (!text) return text.error();
  return parse_planes(*text, path);
}

}  // namespace crossloft::cli
