#pragma once
/// Error bounds of filters once more, in rational arithmetic: values that know their size and error.

#include <doctest/doctest.h>
#include <gmpxx.h>

#include "../../geom/difference_filters.h"

namespace crossloft::tracked {

inline const mpq_class kUnit(filters::kU);

/// What is known of a computed value: its size and its distance from the true one, as multiples of the
/// product of the maxima that the bound is expressed in.
struct Tracked {
  mpq_class size, error;
};

inline Tracked rounded(const mpq_class& size, const mpq_class& error) {
  return {size * (1 + kUnit), error + size * kUnit};
}
inline Tracked operator+(const Tracked& a, const Tracked& b) {
  return rounded(a.size + b.size, a.error + b.error);
}
inline Tracked operator-(const Tracked& a, const Tracked& b) { return a + b; }
inline Tracked operator*(const Tracked& a, const Tracked& b) {
  return rounded(a.size * b.size, a.size * b.error + b.size * a.error + a.error * b.error);
}

inline Tracked det2_of(const Tracked& d) { return d * d - d * d; }
inline Tracked det3_of(const Tracked& d) {
  const Tracked term = det2_of(d) * d;
  return (term - term) + term;
}

/// The bound itself: constant * (at most four factors) is rounded five times downwards at worst, and one more
/// addition of the blur.
inline void check_constant(double constant, const Tracked& determinant) {
  mpq_class least = mpq_class(constant);
  for (int i = 0; i < 6; ++i) least *= 1 - kUnit;
  CHECK(least >= determinant.error);
  CHECK(least <= determinant.error * mpq_class(101, 100));
}

}  // namespace crossloft::tracked
