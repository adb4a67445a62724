#include <array>
#include <string>
#include <utility>

#include "../geom/failing.h"
#include "read_mesh.h"
#include "token_reader.h"

namespace crossloft {
namespace {

void read_medit_vertices(TokenReader& in, Solid& solid) {
  constexpr std::size_t kLeastBytes = 8;  // "0 0 0 0 "
  const std::uint32_t count = in.count("the number of vertices");
  solid.points.reserve(in.room_for(count, kLeastBytes));
  for (std::uint32_t v = 0; v < count && in.ok(); ++v) {
    solid.points.push_back(in.point("a vertex coordinate"));
    in.integer("the reference of a vertex");
  }
}

void read_medit_tets(TokenReader& in, Solid& solid) {
  constexpr std::size_t kLeastBytes = 10;  // "1 2 3 4 0 "
  const std::uint32_t count = in.count("the number of tetrahedra");
  solid.tets.reserve(in.room_for(count, kLeastBytes));
  for (std::uint32_t t = 0; t < count && in.ok(); ++t) {
    std::array<std::uint32_t, 4> corners{};
    for (std::uint32_t& corner : corners) {
      const std::int32_t number = in.integer("a corner of a tetrahedron");
      if (number < 1 || static_cast<std::size_t>(number) > solid.points.size()) {
        in.fail(ErrorCode::index_out_of_range, "a corner of a tetrahedron is " + std::to_string(number) +
                                                   ", but there are " + std::to_string(solid.points.size()) +
                                                   ", counted from 1");
      }
      corner = static_cast<std::uint32_t>(number - 1);
    }
    in.integer("the reference of a tetrahedron");
    solid.tets.push_back(corners);
  }
}

}  // namespace

Result<Solid> parse_medit(std::string_view text, std::string name) {
  return or_out_of_memory([&]() -> Result<Solid> {
    Solid solid;
    TokenReader in(text, std::move(name), '#');
    if (in.token("the word MeshVersionFormatted") != "MeshVersionFormatted") {
      in.fail(ErrorCode::syntax, "the file does not begin with the word MeshVersionFormatted");
    }
    bool has_tets = false;
    while (in.ok() && !in.at_end()) {
      const std::string_view keyword = in.token("a keyword");
      if (keyword == "End") break;
      if (keyword == "Vertices") {
        read_medit_vertices(in, solid);
      } else if (keyword == "Tetrahedra") {
        read_medit_tets(in, solid);
        has_tets = true;
      } else if (keyword == "Dimension" && in.integer("the dimension") != 3) {
        in.fail(ErrorCode::syntax, "the mesh is not three-dimensional");
      }
      // Anything else is the name or a number of a section without interest here.
    }
    // Not every program writes the word End, but a solid has tetrahedra: a file without was cut, or is none.
    if (!has_tets) in.fail(ErrorCode::truncated, "the file ends before a section Tetrahedra");
    if (!in.ok()) return in.error();
    return solid;
  });
}

}  // namespace crossloft
