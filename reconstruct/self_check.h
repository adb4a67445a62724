#pragma once
/// Checks at the stage borders, in builds with CROSSLOFT_VERIFY (the preset dev): each structure's own verify().

#include <string>

#include "../geom/result.h"

namespace crossloft {

#ifdef CROSSLOFT_VERIFY
inline constexpr bool kSelfCheck = true;
#else
inline constexpr bool kSelfCheck = false;
#endif

/// Runs `complaint` (which returns what is wrong, empty if nothing is) in checking builds only.
template <class Complaint>
Result<Done> self_check(const char* stage, Complaint&& complaint) {
  if constexpr (kSelfCheck)
    if (const std::string found = complaint(); !found.empty())
      return make_error(ErrorCode::internal, std::string(stage) + ": " + found);
  return Done{};
}

}  // namespace crossloft
