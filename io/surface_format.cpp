#include "surface_format.h"

#include "byte_writer.h"

namespace crossloft {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

std::string ply_header(std::uint64_t vertices, std::uint64_t triangles, std::size_t padding) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment Crossloft" + std::string(padding, ' ');
  append_decimal(text += "\nelement vertex ", vertices);
  append_decimal(text += "\nproperty double x\nproperty double y\nproperty double z\nelement face ",
                 triangles);
  return text += "\nproperty list uchar int vertex_indices\nend_header\n";
}

void ply_vertex(std::string& bytes, const Vec3& p) {
  for (const double c : {p.x, p.y, p.z}) append_little_endian(bytes, c);
}

void ply_triangle(std::string& bytes, const Triangle& t) {
  bytes += '\3';
  for (const std::uint32_t v : t) append_little_endian(bytes, v);
}

std::string obj_header(std::uint64_t, std::uint64_t, std::size_t padding) {
  return "# Crossloft" + std::string(padding, ' ') + "\n";
}

void obj_vertex(std::string& bytes, const Vec3& p) {
  append_decimal(bytes += "v ", p);
  bytes += '\n';
}

void append_numbers(std::string& bytes, const Triangle& t, std::uint32_t first) {
  for (const std::uint32_t v : t) append_decimal(bytes += ' ', v + first);
  bytes += '\n';
}

void obj_triangle(std::string& bytes, const Triangle& t) { append_numbers(bytes += 'f', t, 1); }

std::string off_header(std::uint64_t vertices, std::uint64_t triangles, std::size_t padding) {
  std::string text = "OFF\n";
  append_decimal(text, vertices);
  append_decimal(text += ' ', triangles);
  return text += " 0" + std::string(padding, ' ') + "\n";
}

void off_vertex(std::string& bytes, const Vec3& p) {
  append_decimal(bytes, p);
  bytes += '\n';
}

void off_triangle(std::string& bytes, const Triangle& t) { append_numbers(bytes += '3', t, 0); }

}  // namespace

const SurfaceFormat* surface_format(const std::string& extension) {
  static constexpr SurfaceFormat kPly{ply_header, ply_vertex, ply_triangle},
      kObj{obj_header, obj_vertex, obj_triangle}, kOff{off_header, off_vertex, off_triangle};
  return extension == "ply" ? &kPly : extension == "obj" ? &kObj : extension == "off" ? &kOff : nullptr;
}

}  // namespace crossloft
