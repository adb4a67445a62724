#include "cell_writer.h"
#include "write_mesh.h"

namespace crossloft {

Result<Done> write_solid(const std::string& path, const Solid& solid, const Context& context) {
  return detail::write_cells(path, solid.points, std::span(solid.tets), context);
}

}  // namespace crossloft
