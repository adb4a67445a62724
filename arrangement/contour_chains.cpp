#include "contour_chains.h"

namespace crossloft::section_steps {

void ContourPlaces::renew(const std::vector<Wall>& walls) {
  for (const std::uint32_t v : vertices_) of_[v] = kNone;
  vertices_.clear();
  for (const Wall& w : walls)
    for (const std::uint32_t v : {w.a, w.b}) {
      if (of_[v] != kNone) continue;
      of_[v] = static_cast<std::uint32_t>(vertices_.size());
      vertices_.push_back(v);
    }
}

ContourChains::ContourChains(std::vector<Wall>& walls, ContourPlaces& places)
    : walls_(walls), places_(places) {
  places.renew(walls);
  const std::size_t count = places.vertices().size();
  degree_.assign(count, 0);
  for (const Wall& w : walls) ++degree_[places[w.a]], ++degree_[places[w.b]];
  begin_.assign(count, 0);
  for (std::size_t k = 1; k < count; ++k) begin_[k] = begin_[k - 1] + degree_[k - 1];
  around_.resize(2 * walls.size());
  std::vector<std::uint32_t> next = begin_;
  for (std::uint32_t w = 0; w < walls.size(); ++w)
    for (const std::uint32_t v : {walls[w].a, walls[w].b}) around_[next[places[v]]++] = w;
}

bool ContourChains::joined(std::uint32_t u, std::uint32_t w) const {
  const auto list = around(u);
  return std::any_of(list.begin(), list.end(), [&](std::uint32_t wall) { return other_end(wall, u) == w; });
}

void ContourChains::remove(std::uint32_t v) {
  if (replaced_.empty()) replaced_.resize(walls_.size()), dead_.resize(walls_.size(), false);
  const std::uint32_t first = around(v)[0], second = around(v)[1], w = other_end(second, v);
  (walls_[first].a == v ? walls_[first].a : walls_[first].b) = w;
  const auto list = around_.begin() + begin_[places_[w]];
  std::replace(list, list + degree_[places_[w]], second, first);
  // The shorter list is copied: each vertex O(log n) times in all.
  std::vector<std::uint32_t>&into = replaced_[first], &from = replaced_[second];
  if (into.size() < from.size()) into.swap(from);
  into.insert(into.end(), from.begin(), from.end());
  into.push_back(v);
  from = {};
  dead_[second] = true;
  degree_[places_[v]] = 0;
}

void ContourChains::finish() {
  if (dead_.empty()) return;
  std::uint32_t w = 0;
  std::erase_if(walls_, [&](const Wall&) { return dead_[w++]; });
}

}  // namespace crossloft::section_steps
