#pragma once
/// Lists by key in two flat arrays; sorting by vertex.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace crossloft {

/// From pairs (key, item), keys 0..size-1.
struct Lists {
  std::vector<std::size_t> begin;
  std::vector<std::uint32_t> items;

  Lists() = default;
  Lists(std::size_t size, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& sorted)
      : begin(size + 1, 0) {
    for (const auto& [key, item] : sorted) {
      ++begin[key + std::size_t{1}];
      items.push_back(item);
    }
    for (std::size_t k = 0; k < size; ++k) begin[k + 1] += begin[k];
  }
  std::span<const std::uint32_t> of(std::size_t key) const {
    return {items.data() + begin[key], begin[key + 1] - begin[key]};
  }
};

/// By vertex, the triangles around it, ascending.
inline Lists umbrellas_of(std::size_t vertices, std::span<const std::array<std::uint32_t, 3>> triangles) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (const std::uint32_t v : triangles[t]) found.emplace_back(v, t);
  std::sort(found.begin(), found.end());
  return Lists(vertices, found);
}

/// Sorts by the first vertex in linear time, then within the few that have the same one. first_vertex(item)
/// is what items are compared by first.
template <class Item, class FirstVertex>
void sort_by_vertex(std::vector<Item>& items, FirstVertex first_vertex) {
  std::uint32_t count = 0;
  for (const Item& item : items) count = std::max(count, first_vertex(item) + 1);
  std::vector<std::uint32_t> begin(std::size_t{count} + 1, 0);
  for (const Item& item : items) ++begin[first_vertex(item) + std::size_t{1}];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Item> sorted(items.size());
  std::vector<std::uint32_t> next(begin);
  for (const Item& item : items) sorted[next[first_vertex(item)]++] = item;
  for (std::uint32_t v = 0; v < count; ++v)
    std::sort(sorted.begin() + begin[v], sorted.begin() + begin[v + std::size_t{1}]);
  items = std::move(sorted);
}

}  // namespace crossloft
