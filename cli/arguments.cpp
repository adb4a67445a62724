#include "arguments.h"

#include <algorithm>
#include <cctype>

namespace crossloft::cli {

CLI::Validator extension_in(std::vector<std::string> extensions) {
  std::string list;
  for (const std::string& extension : extensions) list += (list.empty() ? "" : " ") + extension;
  const auto check = [extensions = std::move(extensions), list](const std::string& path) -> std::string {
    const std::size_t dot = path.find_last_of("./");
    std::string extension = dot == std::string::npos || path[dot] == '/' ? "" : path.substr(dot);
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const bool known = std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
    return known ? "" : path + ": unknown extension, expected one of " + list;
  };
  return CLI::Validator(check, list);
}

}  // namespace crossloft::cli
