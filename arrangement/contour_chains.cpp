#include "contour_chains.h"

namespace crossloft::section_steps {

ContourChains::ContourChains(std::vector<Wall>& walls, std::uint32_t vertices)
    : walls_(walls), around_(vertices), replaced_(walls.size()), dead_(walls.size(), false) {
  for (std::uint32_t w = 0; w < walls.size(); ++w)
    for (const std::uint32_t v : {walls[w].a, walls[w].b}) around_[v].push_back(w);
}

bool ContourChains::joined(std::uint32_t u, std::uint32_t w) const {
  return std::any_of(around_[u].begin(), around_[u].end(),
                     [&](std::uint32_t wall) { return other_end(wall, u) == w; });
}

void ContourChains::remove(std::uint32_t v) {
  const std::uint32_t first = around_[v][0], second = around_[v][1], w = other_end(second, v);
  (walls_[first].a == v ? walls_[first].a : walls_[first].b) = w;
  std::replace(around_[w].begin(), around_[w].end(), second, first);
  // The shorter list is copied: each vertex O(log n) times in all.
  std::vector<std::uint32_t>&into = replaced_[first], &from = replaced_[second];
  if (into.size() < from.size()) into.swap(from);
  into.insert(into.end(), from.begin(), from.end());
  into.push_back(v);
  from = {};
  dead_[second] = true;
  around_[v].clear();
}

void ContourChains::finish() {
  std::uint32_t w = 0;
  std::erase_if(walls_, [&](const Wall&) { return dead_[w++]; });
}

}  // namespace crossloft::section_steps
