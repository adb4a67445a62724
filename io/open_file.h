#pragma once
/// Files opened to be read, and what is said of those that can't be.

#include <cstdio>
#include <memory>
#include <string>

#include "../geom/result.h"

namespace crossloft {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, CloseFile>;

/// From the beginning, as bytes. Error: file_not_readable, with the reason (missing, a directory, no
/// permission).
Result<OpenFile> open_to_read(const std::string& path);

/// The system's text for an errno.
std::string reason(int error);
Error not_readable(const std::string& path, const std::string& why);

}  // namespace crossloft
