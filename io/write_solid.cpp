#include "../geom/failing.h"
#include "cell_writer.h"
#include "write_mesh.h"

namespace crossloft {

Result<Done> write_solid(const std::string& path, const Solid& solid, const Context& context) {
  return or_out_of_memory([&]() -> Result<Done> {
    return detail::write_cells(path, solid.points, std::span(solid.tets), context);
  });
}

}  // namespace crossloft
