#include "fixed_int.h"

namespace crossloft::limbs {

namespace {

/// r[shift..nr) -= b, sign extended.
void subtract_shifted(Limb* r, std::size_t nr, const Limb* b, std::size_t nb, std::size_t shift) {
  const Limb fill = (b[nb - 1] >> 63) != 0 ? ~Limb{0} : 0;
  Limb carry = 1;
  for (std::size_t i = shift; i < nr; ++i) r[i] = add(r[i], ~(i - shift < nb ? b[i - shift] : fill), carry);
}

}  // namespace

void multiply(Limb* r, std::size_t nr, const Limb* a, std::size_t na, const Limb* b, std::size_t nb) {
  for (std::size_t i = 0; i < nr; ++i) r[i] = 0;
  for (std::size_t i = 0; i < na && i < nr; ++i) {
    if (a[i] == 0) continue;
    Limb high = 0;
    const std::size_t end = std::min(nb, nr - i);
    for (std::size_t j = 0; j < end; ++j) r[i + j] = multiply_add(a[i], b[j], r[i + j], high, high);
    if (i + nb < nr) r[i + nb] = high;
  }
  // As unsigned numbers, negative factors were too large by 2^(64 n).
  if ((a[na - 1] >> 63) != 0) subtract_shifted(r, nr, b, nb, na);
  if ((b[nb - 1] >> 63) != 0) subtract_shifted(r, nr, a, na, nb);
}

}  // namespace crossloft::limbs
