#include "../geom/failing.h"
#include "atomic_file.h"
#include "file_extension.h"
#include "read_mesh.h"

namespace crossloft {

Result<Solid> read_solid(const std::string& path, const Context&) {
  return or_out_of_memory([&]() -> Result<Solid> {
    const std::string extension = file_extension(path);
    if (extension != "mesh" && extension != "vtu") return unknown_extension(path, ".mesh and .vtu");
    const Result<std::string> bytes = read_file(path);
    if (!bytes.ok()) return bytes.error();
    return extension == "vtu" ? parse_vtu(*bytes, path) : parse_medit(*bytes, path);
  });
}

}  // namespace crossloft
