#pragma once
/// Looking up numbers that mostly come in ascending order.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace crossloft {

/// In a list of ascending numbers, from where the last one was found.
class RisingSearch {
 public:
  /// `all` must outlive the search.
  explicit RisingSearch(std::span<const std::uint32_t> all) : all_(all) {}

  /// Position of the first that is not less than `number`. O(log of the way from the last one if that is
  /// forward, else of all).
  std::size_t lower_bound(std::uint32_t number) {
    if (at_ == all_.size() || all_[at_] > number) at_ = 0;
    std::size_t step = 1;
    while (all_.size() - at_ > step && all_[at_ + step] < number) at_ += step, step *= 2;
    const auto from = all_.subspan(at_, std::min(step + 1, all_.size() - at_));
    return at_ += static_cast<std::size_t>(std::lower_bound(from.begin(), from.end(), number) - from.begin());
  }

 private:
  std::span<const std::uint32_t> all_;
  std::size_t at_ = 0;
};

}  // namespace crossloft
