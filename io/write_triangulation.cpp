#include "write_triangulation.h"
#include "../geom/failing.h"

#include "cell_writer.h"
#include "triangulation_cells.h"

namespace crossloft {

Result<Done> write_triangulation(const std::string& path, std::span<const Vec3> points,
                                 const Triangulation& triangulation, const Context& context) {
  return or_out_of_memory([&]() -> Result<Done> {
    return visit_cells(triangulation,
                       [&](const auto& cells) { return detail::write_cells(path, points, cells, context); });
  });
}

}  // namespace crossloft
