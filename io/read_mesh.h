#pragma once
/// Reads triangle surfaces (PLY, OBJ, OFF, STL) and tetrahedral solids (Medit .mesh, the .vtu written here).

#include <string>
#include <string_view>

#include "../geom/context.h"
#include "../geom/result.h"
#include "../reconstruct/surface.h"

namespace crossloft {

/// Reads a surface by its extension (.ply .obj .off .stl in any case; another one is ErrorCode::usage).
/// Polygons become fans around their first vertex. Vertices keep their indices: equal points stay different
/// vertices, but for STL, which has no indices: there points with equal coordinates become one vertex, and
/// the context is told. Errors: file_not_readable, syntax, truncated, bad_count, index_out_of_range,
/// not_finite, too_large.
Result<Surface> read_surface(const std::string& path, const Context& context = {});

/// The same from the bytes of a file; `name` is the file name used in messages.
Result<Surface> parse_ply(std::string_view bytes, std::string name);
Result<Surface> parse_obj(std::string_view text, std::string name);
Result<Surface> parse_off(std::string_view text, std::string name);
Result<Surface> parse_stl(std::string_view bytes, std::string name, const Context& context = {});

/// Reads a solid by its extension: `.mesh` (Medit, ASCII) or `.vtu` as written by write_solid.
Result<Solid> read_solid(const std::string& path, const Context& context = {});

Result<Solid> parse_medit(std::string_view text, std::string name);
Result<Solid> parse_vtu(std::string_view bytes, std::string name);

}  // namespace crossloft
