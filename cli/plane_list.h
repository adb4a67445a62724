#pragma once
/// Files that list cutting planes: "A B C D" a line for A x + B y + C z + D = 0.

#include <string>
#include <vector>

#include "../geom/result.h"
#include "../inspect/slice.h"

namespace crossloft::cli {

/// Blank lines and what follows a '#' are skipped. Errors: file_not_readable, syntax, not_finite,
/// zero_normal, no_plane, with the line.
Result<std::vector<CuttingPlane>> read_planes(const std::string& path);

}  // namespace crossloft::cli
