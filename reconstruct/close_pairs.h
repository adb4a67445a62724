#pragma once
/// Pairs of triangles of a surface that may have more in common than corners, for exact questions.

#include <cstdint>
#include <functional>
#include <span>

#include "../geom/context.h"
#include "surface.h"

namespace crossloft {

/// What makes corners of two triangles one.
enum class SameCorner : std::uint8_t { index, place };

/// visit(s, t) once for each pair of which one is `asked` (by triangle), in no particular order: all whose
/// boxes meet, but for many of those that can't have more in common than one corner (SameCorner::index: than
/// one that they share by index; other common points count). These are pairs at a vertex of many triangles, a
/// *hub*, whose boxes all meet there, and pairs of a hub's triangle and another one beside it. A triangle
/// without area is in all pairs whose boxes meet. Stops early if `cancel` is raised.
///
/// Two triangles with area and a common corner have another common point iff the directions in which they
/// are seen from that corner have one: these are arcs of a sphere, which a tree finds. Another triangle is
/// asked only where its plane does not have the hub and the edges opposite to it strictly on one side.
/// Expected O(n log n) for n triangles, hubs or none; but long triangles that lie along each other without a
/// common corner, as those of a fan from each side over one straight row of points do, are n^2 pairs.
void for_close_pairs(const Surface& surface, std::span<const std::uint8_t> asked, SameCorner same,
                     CancelFlag cancel, const std::function<void(std::uint32_t, std::uint32_t)>& visit);

}  // namespace crossloft
