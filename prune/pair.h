#pragma once
/// Two numbers in one register; the compiler has no such type of its own.

namespace crossloft {

using Pair = double __attribute__((vector_size(16)));

inline Pair both(double x) { return Pair{x, x}; }
inline Pair least_of(Pair a, Pair b) { return a < b ? a : b; }
inline Pair largest_of(Pair a, Pair b) { return a > b ? a : b; }

}  // namespace crossloft
