#include <utility>
#include <vector>

#include "../geom/failing.h"
#include "read_mesh.h"
#include "surface_builder.h"
#include "token_reader.h"

namespace crossloft {
namespace {

/// Reads "[ST][C][N]OFF" and the counts of vertices and faces; the count of edges is ignored.
std::pair<std::uint32_t, std::uint32_t> read_header(TokenReader& in) {
  const std::string_view keyword = in.token("the word OFF");
  if (in.ok() && !keyword.ends_with("OFF")) {
    in.fail(ErrorCode::syntax, "the file begins with " + quoted(keyword) + ", not OFF");
  }
  if (in.ok() &&
      (keyword.find('4') != std::string_view::npos || keyword.find('n') != std::string_view::npos)) {
    in.fail(ErrorCode::syntax, quoted(keyword) + " files, which are not three-dimensional, are not read");
  }
  const std::uint32_t vertices = in.count("the number of vertices");
  const std::uint32_t faces = in.count("the number of faces");
  in.skip_line();
  return {vertices, faces};
}

void read_face(TokenReader& in, Surface& surface, std::vector<std::uint32_t>& corners) {
  const std::uint32_t size = in.count("the number of corners of a face");
  corners.clear();
  for (std::uint32_t i = 0; i < size && in.ok(); ++i) {
    corners.push_back(in.index("a corner of a face", static_cast<std::uint32_t>(surface.points.size())));
  }
  add_polygon(in, surface, corners);
  in.skip_line();  // colours
}

}  // namespace

Result<Surface> parse_off(std::string_view text, std::string name) {
  return or_out_of_memory([&]() -> Result<Surface> {
    constexpr std::size_t kLeastVertexBytes = 6, kLeastFaceBytes = 8;  // "0 0 0 " and "3 0 1 2 "
    Surface surface;
    std::vector<std::uint32_t> corners;
    TokenReader in(text, std::move(name), '#');
    const auto [vertices, faces] = read_header(in);
    surface.points.reserve(in.room_for(vertices, kLeastVertexBytes));
    for (std::uint32_t v = 0; v < vertices && in.ok(); ++v) {
      surface.points.push_back(in.point("a vertex coordinate"));
      in.skip_line();  // normals and colours
    }
    surface.triangles.reserve(in.room_for(faces, kLeastFaceBytes));
    for (std::uint32_t f = 0; f < faces && in.ok(); ++f) read_face(in, surface, corners);
    in.expect_end();
    if (!in.ok()) return in.error();
    return surface;
  });
}

}  // namespace crossloft
