#pragma once
/// A plain pool for independent items.

#include <cstddef>
#include <functional>
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

/// The same for items that may fail: work(i) returns a Result<Done>. The first error by number, or that the
/// user cancelled.
template <class Work>
Result<Done> for_all(std::size_t count, const Context& context, std::string_view stage, Work&& work) {
  std::vector<Error> errors(count);
  const bool complete = parallel_for(count, context, stage, [&](std::size_t i) {
    if (auto done = work(i); !done) errors[i] = done.error();
  });
  if (!complete) return make_error(ErrorCode::cancelled, "cancelled");
  for (const Error& error : errors)
    if (!error.message.empty()) return error;
  return Done{};
}

}  // namespace crossloft
