#pragma once
/// A plain pool for independent items.

#include <cstddef>
#include <functional>
#include <string_view>

#include "../geom/context.h"

namespace crossloft {

/// Calls work(i) once for each i < count, on context.threads threads (the calling one works too and alone reports
/// progress). Items must be independent; which thread does which is open, so results go to slots by i.
/// False if cancelled: then some items were not done. Fails on the calling thread if an item has failed on any.
bool parallel_for(std::size_t count, const Context& context, std::string_view stage,
                  const std::function<void(std::size_t)>& work);

}  // namespace crossloft
