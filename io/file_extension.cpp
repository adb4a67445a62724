#include "file_extension.h"

namespace crossloft {

std::string file_extension(std::string_view path) {
  const std::size_t slash = path.find_last_of("/\\");
  const std::string_view name = slash == std::string_view::npos ? path : path.substr(slash + 1);
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return {};
  std::string extension(name.substr(dot + 1));
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return extension;
}

Error unknown_extension(const std::string& path, const std::string& known) {
  const std::string extension = file_extension(path);
  const std::string found = extension.empty() ? "no extension" : "the extension ." + extension;
  return {.code = ErrorCode::usage, .message = "has " + found + "; known here are " + known, .file = path};
}

}  // namespace crossloft
