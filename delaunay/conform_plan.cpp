#include "conform_plan.h"

#include <cmath>

namespace crossloft::detail {

double shell_fraction(double length) {
  int exponent = 0;
  const double mantissa = std::frexp(length, &exponent);  // exact, in [1/2, 1)
  constexpr double kRootOfHalf = 0.70710678118654752;
  return (mantissa < kRootOfHalf ? 0.25 : 0.5) / mantissa;
}

}  // namespace crossloft::detail
