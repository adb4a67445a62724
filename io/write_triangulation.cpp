#include "write_triangulation.h"

#include "cell_writer.h"
#include "triangulation_cells.h"

namespace crossloft {

Result<Done> write_triangulation(const std::string& path, std::span<const Vec3> points,
                                 const Triangulation& triangulation, const Context& context) {
  return visit_cells(triangulation,
                     [&](const auto& cells) { return detail::write_cells(path, points, cells, context); });
}

}  // namespace crossloft
