#pragma once
/// Flats: parts of the sections that no tetrahedron stands on, on either side.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "../geom/context.h"
#include "../geom/grid.h"
#include "face_triangulation.h"
#include "numbering.h"

namespace crossloft {

struct PlaneAreas {
  double section = 0, flat = 0;  ///< input units squared
};

/// True for a section triangle of a face that counts.
using TriangleFilter = std::function<bool(std::size_t face, std::size_t triangle)>;

/// By plane of the section graph: edge-connected regions of its section triangles that count. `counts` is
/// called by several threads. Of no use if the context has been cancelled, as are areas.
std::vector<std::uint32_t> count_regions(std::span<const FaceTriangulation> faces, const Numbering& numbering,
                                         std::size_t plane_count, const TriangleFilter& counts,
                                         const Context& context);

/// By plane of the section graph. REQUIRES: the faces' `covered` filled by all cells.
std::vector<PlaneAreas> measure_flats(std::span<const FaceTriangulation> faces, const Numbering& numbering,
                                      const WorldGrid& grid, std::size_t plane_count, const Context& context);

}  // namespace crossloft
