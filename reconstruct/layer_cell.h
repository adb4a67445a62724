#pragma once
/// A cell between two planes that have no section vertex in common, as those of a stack are: built from the
/// triangulations of its two faces, and classified on the way, as each tetrahedron is known by its triangle
/// or its edges in them.

#include <optional>
#include <span>

#include "cell_builder.h"

namespace crossloft {

/// What build_cell makes of the cell's triangulation, its tetrahedra in another order. Nothing if other faces
/// have vertices, or there are some on a common line, or a vertex has too many neighbours
/// (delaunay/between_planes.h).
std::optional<BuiltCell> build_layer_cell(std::span<const CellFace> faces,
                                          std::span<const LatticePoint> points);

}  // namespace crossloft
