#pragma once
/// Flats: parts of the sections that no tetrahedron stands on, on either side.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "../geom/grid.h"
#include "face_triangulation.h"
#include "numbering.h"

namespace crossloft {

struct PlaneAreas {
  double section = 0, flat = 0;  ///< input units squared
};

struct Flats {
  std::vector<PlaneAreas> planes;  ///< by plane of the section graph
  std::uint32_t regions = 0;       ///< edge-connected flat regions, each within one plane
};

/// True for a section triangle of a face that counts.
using TriangleFilter = std::function<bool(std::size_t face, std::size_t triangle)>;

/// Edge-connected regions of the section triangles that count, each within one plane.
std::uint32_t count_regions(std::span<const FaceTriangulation> faces, const Numbering& numbering,
                            const TriangleFilter& counts);

/// REQUIRES: the faces' `covered` filled by all cells.
Flats measure_flats(std::span<const FaceTriangulation> faces, const Numbering& numbering,
                    const WorldGrid& grid, std::size_t plane_count);

}  // namespace crossloft
