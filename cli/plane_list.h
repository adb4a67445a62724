#pragma once
/// Files that list cutting planes: "A B C D" a line for A x + B y + C z + D = 0.

#include <string>
#include <string_view>
#include <vector>

#include "../geom/result.h"
#include "../inspect/slice.h"

namespace crossloft::cli {

/// Blank lines, a byte order mark and what follows a '#' are skipped. Errors: file_not_readable, syntax,
/// not_finite, zero_normal, no_plane, with the line.
Result<std::vector<CuttingPlane>> read_planes(const std::string& path);

/// The same from the text of a file; `name` is the file name used in messages.
Result<std::vector<CuttingPlane>> parse_planes(std::string_view text, const std::string& name);

}  // namespace crossloft::cli
