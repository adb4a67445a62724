#pragma once
/// The extension that decides the format of a file.

#include <string>
#include <string_view>

#include "../geom/result.h"

namespace crossloft {

/// "ply" for "dir.d/a.PLY", empty when the file name has none. Only A-Z are made lower case.
std::string file_extension(std::string_view path);

/// ErrorCode::usage for a path whose extension is none of `known`, e.g. ".contour or .csl".
Error unknown_extension(const std::string& path, const std::string& known);

}  // namespace crossloft
