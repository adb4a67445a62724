#pragma once
/// Writes triangle surfaces and tetrahedral solids. Coordinates keep all bits in every format but STL.

#include <string>

#include "../geom/context.h"
#include "../geom/result.h"
#include "../reconstruct/surface.h"

namespace crossloft {

/// Writes a surface by its extension, in any case: `.ply` (binary little-endian, double x y z, int indices),
/// `.obj` and `.off` (shortest decimals that read back as the same doubles), `.stl` (binary; it rounds to
/// float32 and its readers weld by coordinates, so the context is warned that it can't carry the guarantees).
/// The target appears whole or stays as it was. Errors: usage (extension), file_not_writable,
/// index_out_of_range, too_large (more vertices than the format can number), cancelled.
Result<Done> write_surface(const std::string& path, const Surface& surface, const Context& context = {});

/// Writes a solid as `.vtu` (VTK XML, appended raw little-endian data) or `.mesh` (Medit, ASCII, version 2).
Result<Done> write_solid(const std::string& path, const Solid& solid, const Context& context = {});

}  // namespace crossloft
