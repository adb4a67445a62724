#include "stitcher.h"

#include <limits>

#include "../geom/disjoint_sets.h"

namespace crossloft {

std::vector<Stitcher::Triangle> Stitcher::between(const Window& window, std::uint32_t lower,
                                                  std::uint32_t upper) const {
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t < window.triangle_slab.size(); ++t) {
    const std::uint32_t slab = window.triangle_slab[t];  // which has as many planes below it
    if ((lower == kNone || slab > lower) && (upper == kNone || slab <= upper))
      triangles.push_back(window.surface.triangles[t]);
  }
  return triangles;
}

/// Vertices that triangles connect are of one shell. A part begins a new one unless a vertex of the seam
/// brings one along.
void Stitcher::count_shells(const Window& window, const std::vector<Triangle>& triangles,
                            const std::vector<std::uint32_t>& fresh, std::vector<Known>& known) {
  DisjointSets parts(known.size());
  for (const Triangle& t : triangles) parts.join(t[0], t[1]), parts.join(t[1], t[2]);
  std::vector<std::uint32_t> shell(known.size(), kNone);  // by the root of a part
  for (std::uint32_t v = 0; v < known.size(); ++v) {
    if (known[v].shell == kNone) continue;
    std::uint32_t& of_part = shell[parts.find(v)];
    if (of_part == kNone) of_part = known[v].shell;
    shells_.join(of_part, known[v].shell);
  }
  std::vector<ShellPart> sums(known.size());
  for (const std::uint32_t v : fresh) ++sums[parts.find(v)].vertices;
  for (const Triangle& t : triangles) {
    ShellPart& sum = sums[parts.find(t[0])];
    const Vec3 a = window.surface.points[t[0]] - origin_, b = window.surface.points[t[1]] - origin_,
               c = window.surface.points[t[2]] - origin_;
    ++sum.triangles;
    sum.volume += dot(a, cross(b, c)) / 6;
  }
  for (std::uint32_t v = 0; v < known.size(); ++v) {
    if (sums[v].triangles == 0) continue;
    if (shell[v] == kNone) shell[v] = shells_.add();
    shells_.count(shell[v], sums[v]);
  }
  for (std::uint32_t v = 0; v < known.size(); ++v)
    if (known[v].number != kNone) known[v].shell = shell[parts.find(v)];
}

Result<Done> Stitcher::take(const Window& window, std::uint32_t lower, std::uint32_t upper) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::int32_t>::max();
  std::vector<Triangle> triangles = between(window, lower, upper);
  std::vector<Known> known(window.surface.points.size());
  if (lower != kNone) {
    const std::vector<std::uint32_t> vertices = vertices_in(window, lower);
    for (std::size_t i = 0; i < vertices.size(); ++i) known[vertices[i]] = seam_[i];
  }
  std::vector<std::uint8_t> is_used(known.size(), 0);
  for (const Triangle& t : triangles) is_used[t[0]] = is_used[t[1]] = is_used[t[2]] = 1;
  std::vector<std::uint32_t> fresh;
  std::vector<Vec3> points;
  for (std::uint32_t v = 0; v < known.size(); ++v) {
    if (is_used[v] == 0 || known[v].number != kNone) continue;
    known[v].number = static_cast<std::uint32_t>(points_ + points.size());
    fresh.push_back(v);
    points.push_back(window.surface.points[v]);
  }
  points_ += points.size(), triangles_ += triangles.size();
  if (points_ > kMost || triangles_ > kMost)
    return make_error(ErrorCode::too_large, "the surface has more than 2^31 - 1 elements");
  count_shells(window, triangles, fresh, known);
  seam_.clear();
  if (upper != kNone)
    for (const std::uint32_t v : vertices_in(window, upper)) seam_.push_back(known[v]);
  for (Triangle& t : triangles) t = {known[t[0]].number, known[t[1]].number, known[t[2]].number};
  return sink_.take(points, triangles);
}

}  // namespace crossloft
