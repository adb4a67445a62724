#include "contacts.h"

#include <algorithm>

#include "../geom/triangle_meeting.h"
#include "close_pairs.h"

namespace crossloft {
namespace {

using Triple = std::array<std::uint32_t, 3>;

/// Puts the vertices that both have first and in one order; their number.
int align(Triple& a, Triple& b) {
  int shared = 0;
  for (int i = 0; i < 3; ++i) {
    const auto at = std::find(b.begin() + shared, b.end(), a[static_cast<std::size_t>(i)]);
    if (at == b.end()) continue;
    std::swap(*at, b[static_cast<std::size_t>(shared)]);
    std::swap(a[static_cast<std::size_t>(i)], a[static_cast<std::size_t>(shared)]);
    ++shared;
  }
  return shared;
}

}  // namespace

std::vector<std::array<std::uint32_t, 2>> find_contacts(const Surface& surface, const Context& context) {
  const auto corners = [&](const Triple& t) {
    return Corners{surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]};
  };
  std::vector<std::array<std::uint32_t, 2>> found;
  const std::vector<std::uint8_t> all(surface.triangles.size(), 1);
  for_close_pairs(surface, all, SameCorner::index, context.cancel, [&](std::uint32_t i, std::uint32_t j) {
    Triple a = surface.triangles[i], b = surface.triangles[j];
    const int shared = align(a, b);
    if (shared == 3 || touch(corners(a), corners(b), shared))
      found.push_back({std::min(i, j), std::max(i, j)});
  });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace crossloft
