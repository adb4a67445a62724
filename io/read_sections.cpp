#include "read_sections.h"
#include "../geom/failing.h"

#include "atomic_file.h"
#include "file_extension.h"

namespace crossloft {

Result<Sections> read_sections(const std::string& path, const Context& context) {
  return or_out_of_memory([&]() -> Result<Sections> {
    const std::string extension = file_extension(path);
    if (extension != "contour" && extension != "csl") return unknown_extension(path, ".contour and .csl");
    const Result<std::string> text = read_file(path);
    if (!text.ok()) return text.error();
    return extension == "csl" ? parse_csl(*text, path, context) : parse_contour(*text, path, context);
  });
}

}  // namespace crossloft
