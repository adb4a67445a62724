#pragma once
/// How surface formats with numbered vertices write one: a header, the vertices, the triangles.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "../geom/vec3.h"

namespace crossloft {

struct SurfaceFormat {
  /// With the numbers of vertices and triangles; `padding` blanks in it say nothing.
  std::string (*header)(std::uint64_t vertices, std::uint64_t triangles, std::size_t padding);
  void (*vertex)(std::string& bytes, const Vec3& point);
  void (*triangle)(std::string& bytes, const std::array<std::uint32_t, 3>& triangle);
};

/// By extension in lower case, "ply", "obj" or "off"; null for others.
const SurfaceFormat* surface_format(const std::string& extension);

}  // namespace crossloft
