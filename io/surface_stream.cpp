#include "surface_stream.h"

#include <limits>
#include <utility>

#include "../geom/failing.h"
#include "atomic_file.h"
#include "file_extension.h"
#include "surface_format.h"

namespace crossloft {
namespace {

/// The header with the largest numbers that a surface can have is the longest one.
std::size_t longest_header(const SurfaceFormat& format) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::int32_t>::max();
  return format.header(kMost, kMost, 0).size();
}

std::string padded_header(const SurfaceFormat& format, std::uint64_t vertices, std::uint64_t triangles) {
  const std::size_t size = format.header(vertices, triangles, 0).size();
  return format.header(vertices, triangles, longest_header(format) - size);
}

}  // namespace

struct SurfaceStream::Parts {
  const SurfaceFormat* format;
  AtomicFile vertices, triangles;  ///< the first one with the header becomes the target
  std::uint64_t vertex_count = 0, triangle_count = 0;
  std::string buffer;
};

Result<SurfaceStream> SurfaceStream::create(const std::string& path) {
  return or_out_of_memory([&]() -> Result<SurfaceStream> {
    const std::string extension = file_extension(path);
    const SurfaceFormat* format = surface_format(extension);
    if (format == nullptr) return unknown_extension(path, ".ply, .obj and .off");
    auto vertices = AtomicFile::create(path);
    if (!vertices) return vertices.error();
    if (vertices->is_direct())
      return Error{ErrorCode::file_not_writable, "a stream needs a regular file: its header is written last", path,
                   0, kNone, kNone};
    auto triangles = AtomicFile::create(path);
    if (!triangles) return triangles.error();
    auto parts = std::make_unique<Parts>(
        Parts{format, std::move(vertices).value(), std::move(triangles).value(), 0, 0, {}});
    parts->vertices.append(std::string(longest_header(*format), ' '));
    return SurfaceStream(std::move(parts));
  });
}

SurfaceStream::SurfaceStream(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
SurfaceStream::SurfaceStream(SurfaceStream&&) noexcept = default;
SurfaceStream::~SurfaceStream() = default;

Result<Done> SurfaceStream::take(std::span<const Vec3> points,
                                 std::span<const std::array<std::uint32_t, 3>> triangles) {
  constexpr std::size_t kPiece = 1 << 16;
  Parts& parts = *parts_;
  const auto spill = [&](AtomicFile& file, std::size_t least) {
    if (parts.buffer.size() < least) return;
    file.append(parts.buffer);
    parts.buffer.clear();
  };
  for (const Vec3& p : points) parts.format->vertex(parts.buffer, p), spill(parts.vertices, kPiece);
  spill(parts.vertices, 0);
  for (const auto& t : triangles) parts.format->triangle(parts.buffer, t), spill(parts.triangles, kPiece);
  spill(parts.triangles, 0);
  parts.vertex_count += points.size();
  parts.triangle_count += triangles.size();
  // The reason of a failure is told by commit(); there is no use in going on.
  if (parts.vertices.failed()) return parts.vertices.commit();
  if (parts.triangles.failed()) return parts.triangles.commit();
  return Done{};
}

Result<Done> SurfaceStream::finish(const Context& context) {
  Parts& parts = *parts_;
  parts.vertices.overwrite(padded_header(*parts.format, parts.vertex_count, parts.triangle_count));
  const auto moved = parts.triangles.move_to(parts.vertices, [&] { return context.cancelled(); });
  if (!moved) return moved;
  return parts.vertices.commit();
}

}  // namespace crossloft
