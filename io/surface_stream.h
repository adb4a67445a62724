#pragma once
/// A surface file that is written while the surface is being made.

#include <cstdint>
#include <memory>
#include <string>

#include "../geom/context.h"
#include "../geom/result.h"
#include "../reconstruct/stack.h"

namespace crossloft {

/// Writes `.ply`, `.obj` or `.off` as write_surface() does, but for a comment that fills the place kept for
/// the numbers of vertices and triangles. Points go to the file beside the target, triangles to a second one;
/// both become one at the end. The target appears whole or stays as it was. STL has no shared vertices to
/// number: it is an error, as is a target that is no regular file.
class SurfaceStream : public SurfaceSink {
 public:
  /// Errors: usage (extension), file_not_writable.
  static Result<SurfaceStream> create(const std::string& path);
  ~SurfaceStream() override;
  SurfaceStream(SurfaceStream&&) noexcept;

  /// Errors: file_not_writable, usage after finish().
  Result<Done> take(std::span<const Vec3> points,
                    std::span<const std::array<std::uint32_t, 3>> triangles) override;
  /// Completes the file, or leaves nothing. Errors: file_not_writable, cancelled, usage if called again.
  Result<Done> finish(const Context& context = {});

 private:
  struct Parts;
  explicit SurfaceStream(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

}  // namespace crossloft
