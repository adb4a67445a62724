#include <string>
#include <utility>
#include <vector>

#include "../geom/failing.h"
#include "read_mesh.h"
#include "surface_builder.h"
#include "token_reader.h"

namespace crossloft {
namespace {

/// The vertex of a corner "v", "v/vt", "v//vn" or "v/vt/vn": from 1 up, or from -1 down counting back from
/// the last.
std::uint32_t read_corner(TokenReader& in, std::size_t vertices) {
  const std::string_view text = in.token("a corner of a face");
  const std::string_view number = text.substr(0, text.find('/'));
  const auto size = static_cast<std::int64_t>(vertices);
  std::int64_t value = 0;
  if (!parse_integer(number, value)) {
    in.fail(ErrorCode::syntax, quoted(text) + " stands where a corner of a face should be");
    return 0;
  }
  // The text bounds `size`, and both ends are tested before they are combined: no overflow.
  const bool inside = value != 0 && value <= size && value >= -size;
  if (!inside) {
    in.fail(ErrorCode::index_out_of_range, "a corner of a face is " + quoted(text) + ", but " +
                                               std::to_string(vertices) + " vertices are known here");
    return 0;
  }
  return static_cast<std::uint32_t>(value > 0 ? value - 1 : size + value);
}

}  // namespace

Result<Surface> parse_obj(std::string_view text, std::string name) {
  return or_out_of_memory([&]() -> Result<Surface> {
    Surface surface;
    std::vector<std::uint32_t> corners;
    TokenReader in(text, std::move(name), '#');
    while (in.ok() && !in.at_end()) {
      const std::string_view keyword = in.token("a keyword");
      if (keyword == "v") {
        surface.points.push_back(in.point("a vertex coordinate"));
        if (surface.points.size() >= kNone)
          in.fail(ErrorCode::too_large, "the file has more than 2^32 - 2 vertices");
      } else if (keyword == "f") {
        corners.clear();
        while (in.ok() && !in.at_line_end()) corners.push_back(read_corner(in, surface.points.size()));
        add_polygon(in, surface, corners);
      }
      in.skip_line();
    }
    if (!in.ok()) return in.error();
    return surface;
  });
}

}  // namespace crossloft
