#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "../geom/failing.h"
#include "byte_writer.h"
#include "file_extension.h"
#include "surface_format.h"
#include "write_mesh.h"

namespace crossloft {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Unit normal, zero for a triangle without area. The edges are scaled so that their product can't overflow.
Vec3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a, v = c - a;
  const double scale =
      std::max({std::abs(u.x), std::abs(u.y), std::abs(u.z), std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(scale > 0)) return {};
  const Vec3 n = cross({u.x / scale, u.y / scale, u.z / scale}, {v.x / scale, v.y / scale, v.z / scale});
  const double length = norm(n);
  return length > 0 ? Vec3{n.x / length, n.y / length, n.z / length} : Vec3{};
}

/// Coordinates beyond the range of a float become its largest value.
void write_floats(ByteWriter& out, const Vec3& v) {
  constexpr double kMost = std::numeric_limits<float>::max();
  for (const double c : {v.x, v.y, v.z}) out.little_endian(static_cast<float>(std::clamp(c, -kMost, kMost)));
}

void write_stl(ByteWriter& out, const Surface& surface) {
  constexpr std::size_t kHeaderBytes = 80;
  std::string header = "Crossloft";  // must not begin with "solid", the mark of the text form
  header.resize(kHeaderBytes, ' ');
  out.text(header).little_endian(static_cast<std::uint32_t>(surface.triangles.size()));
  for (const auto& [a, b, c] : surface.triangles) {
    const Vec3 corners[] = {surface.points[a], surface.points[b], surface.points[c]};
    write_floats(out, unit_normal(corners[0], corners[1], corners[2]));
    for (const Vec3& corner : corners) write_floats(out, corner);
    out.little_endian(std::uint16_t{0});
  }
}

void write_numbered(ByteWriter& out, const SurfaceFormat& format, const Surface& surface) {
  out.text(format.header(surface.points.size(), surface.triangles.size(), 0));
  for (const Vec3& p : surface.points) out.from([&](std::string& bytes) { format.vertex(bytes, p); });
  for (const Triangle& t : surface.triangles)
    out.from([&](std::string& bytes) { format.triangle(bytes, t); });
}

/// All four formats are read by programs that number with 32 bit signed integers.
Result<Done> check(const std::string& path, const Surface& surface) {
  constexpr std::size_t kMost = std::numeric_limits<std::int32_t>::max();
  if (surface.points.size() > kMost || surface.triangles.size() > kMost) {
    return Error{
        .code = ErrorCode::too_large, .message = "the surface has more than 2^31 - 1 elements", .file = path};
  }
  for (const Triangle& t : surface.triangles) {
    if (*std::max_element(t.begin(), t.end()) < surface.points.size()) continue;
    return Error{
        .code = ErrorCode::index_out_of_range, .message = "a triangle names a missing vertex", .file = path};
  }
  return Done{};
}

}  // namespace

Result<Done> write_surface(const std::string& path, const Surface& surface, const Context& context) {
  return or_out_of_memory([&]() -> Result<Done> {
    const std::string extension = file_extension(path);
    const SurfaceFormat* format = surface_format(extension);
    const bool is_stl = extension == "stl";
    if (format == nullptr && !is_stl) return unknown_extension(path, ".ply, .obj, .off and .stl");
    if (Result<Done> good = check(path, surface); !good.ok()) return good;
    if (is_stl) {
      context.warn(
          "STL rounds to 32 bits and its readers join equal points: the file can't carry the guarantees");
    }
    Result<AtomicFile> file = AtomicFile::create(path);
    if (!file.ok()) return file.error();
    ByteWriter out(std::move(*file), context);
    if (is_stl)
      write_stl(out, surface);
    else
      write_numbered(out, *format, surface);
    return out.finish();
  });
}

}  // namespace crossloft
