#include "open_file.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace crossloft {

Result<OpenFile> open_to_read(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return not_readable(path, "it is a directory");
  errno = 0;
  OpenFile file(std::fopen(path.c_str(), "rb"));
  if (file == nullptr) return not_readable(path, reason(errno));
  return file;
}

std::string reason(int error) { return std::error_code(error, std::generic_category()).message(); }

Error not_readable(const std::string& path, const std::string& why) {
  return {.code = ErrorCode::file_not_readable, .message = "cannot be read: " + why, .file = path};
}

}  // namespace crossloft
