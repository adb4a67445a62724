#pragma once
/// Writes Delaunay and regular triangulations of any dimension.

#include <span>
#include <string>

#include "../delaunay/triangulation.h"
#include "../geom/context.h"
#include "../geom/result.h"
#include "../geom/vec3.h"

namespace crossloft {

/// Writes a triangulation of `points` as `.vtu` or `.mesh` (formats as in write_solid): tetrahedra,
/// triangles, edges, or the one point, by its dimension. All points are written, in their order, also those
/// that are no vertex: indices are the input's. Nothing is copied. The target appears whole or stays as it
/// was. Errors: usage (extension), file_not_writable, index_out_of_range (not a triangulation of these
/// points), too_large (2^31 points or cells), cancelled.
Result<Done> write_triangulation(const std::string& path, std::span<const Vec3> points,
                                 const Triangulation& triangulation, const Context& context = {});

}  // namespace crossloft
