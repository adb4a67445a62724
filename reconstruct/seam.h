#pragma once
/// Where two windows of a stack are joined: at a plane, if they agree about what is around each vertex there.

#include <cstdint>
#include <vector>

#include "window.h"

namespace crossloft {

/// An edge opposite to a vertex in a triangle at it: vertex, from, to is counter-clockwise.
struct LinkEdge {
  std::uint32_t vertex = 0;  ///< number in the seam
  /// Vertices of the seam by number, others by name: different ones by different names.
  std::uint64_t from = 0, to = 0;
};

/// The vertices of a surface in one plane, copies told apart, with the triangles below the plane.
struct Seam {
  std::uint32_t position = kNone;  ///< of its plane in the file
  std::vector<Vec3> points;
  std::vector<LinkEdge> below;
};

/// The numbers of the surface's vertices in the plane, ascending: their order is geometry, so that two
/// windows that agree have the same list.
std::vector<std::uint32_t> vertices_in(const Window& window, std::uint32_t plane);

/// REQUIRES: plane < window.planes.size().
Seam make_seam(const Window& window, std::uint32_t plane);

/// True iff what the seam has below the plane and what the window has above it are, together, one cycle of
/// triangles around each of the same vertices: then both parts are a closed manifold there. O(n log n).
bool fits(const Seam& below, const Window& above, std::uint32_t plane);

}  // namespace crossloft
