#pragma once
/// Values over GMP's classes without their lazy expressions, which must not outlive their operands. A sum or
/// product of a value that is about to die is made in its place, so no limbs are allocated for it.

#include <gmpxx.h>

#include <utility>

namespace crossloft::strategies {

/// T is mpz_class or mpq_class.
template <class T>
struct Gmp {
  T value;

  friend Gmp operator+(const Gmp& a, const Gmp& b) { return {T(a.value + b.value)}; }
  friend Gmp operator+(Gmp&& a, const Gmp& b) { return a.value += b.value, std::move(a); }
  friend Gmp operator+(const Gmp& a, Gmp&& b) { return b.value += a.value, std::move(b); }
  friend Gmp operator+(Gmp&& a, Gmp&& b) { return a.value += b.value, std::move(a); }
  friend Gmp operator-(const Gmp& a, const Gmp& b) { return {T(a.value - b.value)}; }
  friend Gmp operator-(Gmp&& a, const Gmp& b) { return a.value -= b.value, std::move(a); }
  friend Gmp operator-(const Gmp& a, Gmp&& b) { return b.value = a.value - b.value, std::move(b); }
  friend Gmp operator-(Gmp&& a, Gmp&& b) { return a.value -= b.value, std::move(a); }
  friend Gmp operator*(const Gmp& a, const Gmp& b) { return {T(a.value * b.value)}; }
  friend Gmp operator*(Gmp&& a, const Gmp& b) { return a.value *= b.value, std::move(a); }
  friend Gmp operator*(const Gmp& a, Gmp&& b) { return b.value *= a.value, std::move(b); }
  friend Gmp operator*(Gmp&& a, Gmp&& b) { return a.value *= b.value, std::move(a); }
};

}  // namespace crossloft::strategies
