#pragma once
/// Lists by key in two flat arrays.

#include <cstddef>
#include <cstdint>
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

}  // namespace crossloft
