#pragma once
/// A plain pool for independent items.

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <string_view>
#include <vector>

#include "context.h"
#include "result.h"

namespace crossloft {

/// Calls work(i) once for each i < count, on context.threads threads (the calling one works too and alone
/// reports progress). Items must be independent; which thread does which is open, so results go to slots by
/// i. False if cancelled: then some items were not done. Fails on the calling thread if an item has failed on
/// any.
bool parallel_for(std::size_t count, const Context& context, std::string_view stage,
                  const std::function<void(std::size_t)>& work);

/// Items of little work each that are one item of parallel_for together.
inline constexpr std::size_t kBlock = std::size_t{1} << 13;

/// Calls work(first, last) for each block of 0..count-1. False if cancelled.
template <class Work>
bool for_blocks(std::size_t count, const Context& context, std::string_view stage, Work&& work) {
  return parallel_for((count + kBlock - 1) / kBlock, context, stage,
                      [&](std::size_t b) { work(b * kBlock, std::min(count, (b + 1) * kBlock)); });
}

/// Numbers the i < count with is_kept(i) from 0 on, in their order: start(how many), then take(i, number) for
/// each, which may change is_kept(i). False if cancelled.
template <class IsKept, class Start, class Take>
bool number_kept(std::size_t count, const Context& context, std::string_view stage, const IsKept& is_kept,
                 const Start& start, const Take& take) {
  std::vector<std::size_t> begin((count + kBlock - 1) / kBlock + 1, 0);  // by block
  const bool counted = for_blocks(count, context, stage, [&](std::size_t first, std::size_t last) {
    std::size_t kept = 0;
    for (std::size_t i = first; i < last; ++i) kept += is_kept(i) ? 1U : 0U;
    begin[first / kBlock + 1] = kept;
  });
  if (!counted) return false;
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  start(begin.back());
  return for_blocks(count, context, stage, [&](std::size_t first, std::size_t last) {
    std::size_t next = begin[first / kBlock];
    for (std::size_t i = first; i < last; ++i)
      if (is_kept(i)) take(i, next++);
  });
}

/// parallel_for for items that may fail: work(i) returns a Result<Done>. The first error by number, or that
/// the user cancelled.
template <class Work>
Result<Done> for_all(std::size_t count, const Context& context, std::string_view stage, Work&& work) {
  std::vector<std::optional<Error>> errors(count);
  const bool complete = parallel_for(count, context, stage, [&](std::size_t i) {
    if (auto done = work(i); !done) errors[i] = done.error();
  });
  if (!complete) return make_error(ErrorCode::cancelled, "cancelled");
  for (const std::optional<Error>& error : errors)
    if (error) return *error;
  return Done{};
}

}  // namespace crossloft
