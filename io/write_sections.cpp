#include "write_sections.h"

#include "../arrangement/normalise.h"
#include "../geom/failing.h"
#include "atomic_file.h"
#include "byte_writer.h"
#include "file_extension.h"

namespace crossloft {
namespace {

void append_plane(std::string& text, const PlaneSection& plane) {
  append_decimal(text, plane.normal);
  append_decimal(text += ' ', plane.offset);
  append_decimal(text += '\n', plane.vertices.size());
  append_decimal(text += ' ', plane.edges.size());
  text += '\n';
  for (const Vec3& vertex : plane.vertices) {
    append_decimal(text, vertex);
    text += '\n';
  }
  for (const ContourEdge& edge : plane.edges) {
    append_decimal(text, edge.a);
    append_decimal(text += ' ', edge.b);
    append_decimal(text += ' ', edge.material_a);
    append_decimal(text += ' ', edge.material_b);
    text += '\n';
  }
}

}  // namespace

std::string format_contour(const Sections& sections) {
  std::string text = std::to_string(sections.planes.size()) + '\n';
  for (const PlaneSection& plane : sections.planes) append_plane(text, plane);
  return text;
}

Result<Done> write_sections(const std::string& path, const Sections& sections, const Context& context) {
  return or_out_of_memory([&]() -> Result<Done> {
    const std::string extension = file_extension(path);
    if (extension != "contour" && extension != "csl") return unknown_extension(path, ".contour and .csl");
    if (Result<Done> good = check_numbers(sections); !good) return good;
    if (extension == "contour") return write_file(path, format_contour(sections));
    const Result<std::string> text = format_csl(sections, context);
    return text.ok() ? write_file(path, *text) : Result<Done>(text.error());
  });
}

}  // namespace crossloft
