#include "seam.h"

#include <algorithm>
#include <span>
#include <tuple>

namespace crossloft {
namespace {

/// Names of vertices that are not in the seam begin here, those of the window above behind those below.
constexpr std::uint64_t kBelow = std::uint64_t{1} << 32, kAbove = std::uint64_t{2} << 32;

/// The link edges of the vertices in a plane from the triangles on one side of it.
std::vector<LinkEdge> links_on(const Window& window, std::uint32_t plane, bool above,
                               const std::vector<std::uint32_t>& vertices) {
  std::vector<std::uint32_t> number(window.surface.points.size(), kNone);
  for (std::uint32_t i = 0; i < vertices.size(); ++i) number[vertices[i]] = i;
  const auto name = [&](std::uint32_t v) {
    return number[v] != kNone ? std::uint64_t{number[v]} : (above ? kAbove : kBelow) + v;
  };
  std::vector<LinkEdge> links;
  for (std::size_t t = 0; t < window.triangle_slab.size(); ++t) {
    // Slab p is the one below plane p.
    const std::uint32_t slab = window.triangle_slab[t];
    if (slab != (above ? plane + 1 : plane)) continue;
    const auto& v = window.surface.triangles[t];
    for (std::size_t i = 0; i < 3; ++i)
      if (number[v[i]] != kNone) links.push_back({number[v[i]], name(v[(i + 1) % 3]), name(v[(i + 2) % 3])});
  }
  return links;
}

/// REQUIRES: sorted by `from`.
bool is_one_cycle(std::span<const LinkEdge> links) {
  std::uint64_t at = links[0].from;
  for (std::size_t steps = 1; steps <= links.size(); ++steps) {
    const auto next = std::lower_bound(links.begin(), links.end(), at,
                                       [](const LinkEdge& e, std::uint64_t from) { return e.from < from; });
    if (next == links.end() || next->from != at) return false;
    at = next->to;
    if (at == links[0].from) return steps == links.size();
  }
  return false;
}

}  // namespace

std::vector<std::uint32_t> vertices_in(const Window& window, std::uint32_t plane) {
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t v = 0; v < window.vertex_plane.size(); ++v)
    if (window.vertex_plane[v] == plane) vertices.push_back(v);
  return vertices;
}

Seam make_seam(const Window& window, std::uint32_t plane) {
  Seam seam;
  seam.position = window.planes[plane];
  const std::vector<std::uint32_t> vertices = vertices_in(window, plane);
  for (const std::uint32_t v : vertices) seam.points.push_back(window.surface.points[v]);
  seam.below = links_on(window, plane, false, vertices);
  return seam;
}

bool fits(const Seam& below, const Window& above, std::uint32_t plane) {
  const std::vector<std::uint32_t> vertices = vertices_in(above, plane);
  if (vertices.size() != below.points.size()) return false;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (above.surface.points[vertices[i]] != below.points[i]) return false;
  std::vector<LinkEdge> links = links_on(above, plane, true, vertices);
  links.insert(links.end(), below.below.begin(), below.below.end());
  std::sort(links.begin(), links.end(), [](const LinkEdge& a, const LinkEdge& b) {
    return std::tie(a.vertex, a.from, a.to) < std::tie(b.vertex, b.from, b.to);
  });
  std::uint32_t seen = 0;
  for (std::size_t first = 0, last = 0; first < links.size(); first = last, ++seen) {
    while (last < links.size() && links[last].vertex == links[first].vertex) ++last;
    if (links[first].vertex != seen || !is_one_cycle({links.data() + first, last - first})) return false;
  }
  return seen == vertices.size();
}

}  // namespace crossloft
