#pragma once
/// Images as PNG files.

#include <string>

#include "../../geom/result.h"
#include "canvas.h"

namespace crossloft::cli {

/// Writes the image whole or not at all. Errors: file_not_writable.
Result<Done> write_png(const std::string& path, const Image& image);

}  // namespace crossloft::cli
