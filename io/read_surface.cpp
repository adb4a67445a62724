#include "../geom/failing.h"
#include "atomic_file.h"
#include "file_extension.h"
#include "read_mesh.h"

namespace crossloft {

Result<Surface> read_surface(const std::string& path, const Context& context) {
  return or_out_of_memory([&]() -> Result<Surface> {
    const std::string extension = file_extension(path);
    const bool known = extension == "ply" || extension == "obj" || extension == "off" || extension == "stl";
    if (!known) return unknown_extension(path, ".ply, .obj, .off and .stl");
    const Result<std::string> bytes = read_file(path);
    if (!bytes.ok()) return bytes.error();
    if (extension == "ply") return parse_ply(*bytes, path);
    if (extension == "obj") return parse_obj(*bytes, path);
    return extension == "off" ? parse_off(*bytes, path) : parse_stl(*bytes, path, context);
  });
}

}  // namespace crossloft
