#pragma once
/// Whether callers may inline the first stages of predicates. They do, but in the copy of the library in which
/// bench/pipeline/ puts strategies in the place of the predicates: there every question is a call.

namespace crossloft {

#ifdef CROSSLOFT_BENCH_STRATEGIES
inline constexpr bool kInlineFilters = false;
#else
inline constexpr bool kInlineFilters = true;
#endif

}  // namespace crossloft
