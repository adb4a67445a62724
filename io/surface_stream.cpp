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

Error ended() { return make_error(ErrorCode::usage, "the stream has ended: finish() is its last call"); }

}  // namespace

struct SurfaceStream::Parts {
  const SurfaceFormat* format;
  AtomicFile vertices, triangles;  ///< the first one with the header becomes the target
  std::uint64_t vertex_count = 0, triangle_count = 0;
  std::string buffer;
  bool finished = false;

  Result<Done> take(std::span<const Vec3> points, std::span<const std::array<std::uint32_t, 3>> faces);
  Result<Done> finish(const Context& context);
};

Result<SurfaceStream> SurfaceStream::create(const std::string& path) {
  return or_out_of_memory([&]() -> Result<SurfaceStream> {
    const std::string extension = file_extension(path);
    const SurfaceFormat* format = surface_format(extension);
    if (format == nullptr) return unknown_extension(path, ".ply, .obj and .off");
    auto vertices = AtomicFile::create(path);
    if (!vertices) return vertices.error();
    if (vertices->is_direct())
      return Error{ErrorCode::file_not_writable,
                   "a stream needs a regular file: its header is written last",
                   path,
                   0,
                   kNone,
                   kNone};
    auto triangles = AtomicFile::create(path);
    if (!triangles) return triangles.error();
    auto parts = std::make_unique<Parts>(
        Parts{format, std::move(vertices).value(), std::move(triangles).value(), 0, 0, {}, false});
    parts->vertices.append(std::string(longest_header(*format), ' '));
    return SurfaceStream(std::move(parts));
  });
}

SurfaceStream::SurfaceStream(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
SurfaceStream::SurfaceStream(SurfaceStream&&) noexcept = default;
SurfaceStream::~SurfaceStream() = default;

Result<Done> SurfaceStream::take(std::span<const Vec3> points,
                                 std::span<const std::array<std::uint32_t, 3>> triangles) {
  return or_out_of_memory([&] { return parts_->take(points, triangles); });
}

Result<Done> SurfaceStream::finish(const Context& context) {
  return or_out_of_memory([&] { return parts_->finish(context); });
}

Result<Done> SurfaceStream::Parts::take(std::span<const Vec3> points,
                                        std::span<const std::array<std::uint32_t, 3>> faces) {
  if (finished) return ended();
  constexpr std::size_t kPiece = 1 << 16;
  const auto spill = [&](AtomicFile& file, std::size_t least) {
    if (buffer.size() < least) return;
    file.append(buffer);
    buffer.clear();
  };
  for (const Vec3& p : points) format->vertex(buffer, p), spill(vertices, kPiece);
  spill(vertices, 0);
  for (const auto& t : faces) format->triangle(buffer, t), spill(triangles, kPiece);
  spill(triangles, 0);
  vertex_count += points.size();
  triangle_count += faces.size();
  // The reason of a failure is told by commit(); there is no use in going on.
  if (vertices.failed()) return vertices.commit();
  if (triangles.failed()) return triangles.commit();
  return Done{};
}

Result<Done> SurfaceStream::Parts::finish(const Context& context) {
  if (finished) return ended();
  finished = true;  // also if it fails: nothing is left then that could be tried again
  vertices.overwrite(padded_header(*format, vertex_count, triangle_count));
  const auto moved = triangles.move_to(vertices, [&] { return context.cancelled(); });
  if (!moved) return moved;
  return vertices.commit();
}

}  // namespace crossloft
