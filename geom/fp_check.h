#pragma once
/// Refuses compiler modes under which the error bounds of the filters do not hold: included by every header
/// whose inline code decides something from rounded doubles.

#include <cfloat>
#include <limits>

#if defined(__FAST_MATH__)
#error "crossloft: -ffast-math reorders and drops roundings; the exact predicates need IEEE 754 arithmetic"
#endif
#if defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error \
    "crossloft: -fassociative-math, -freciprocal-math (parts of -funsafe-math-optimizations) drop roundings"
#endif
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0
#error "crossloft: -ffinite-math-only makes comparisons with NaN and infinity true that must be false"
#endif
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
#error "crossloft: doubles are evaluated in a wider format here (x87?); build with -msse2 -mfpmath=sse"
#endif

// A fused multiply-add is no danger to a bound but makes results depend on the target: the build passes
// -ffp-contract=off to everybody who links the library, which no macro can check.
static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53,
              "crossloft needs IEEE 754 binary64 doubles");
