#pragma once
/// Sign vectors: on which side of each of k planes something lies, as two rows of bits.
///
/// Bit p % 64 of word p / 64 belongs to plane p. `pos` is set where the sign is +, `zero` where it is 0;
/// never both. Bits from k on are 0. A point, and every open element of an arrangement (vertex, edge, face,
/// cell), has one sign vector; the zero row is its tag, the set of planes that contain it.

#include <cstddef>
#include <cstdint>
#include <span>

#include "../geom/ids.h"

namespace crossloft {

using SignWord = std::uint64_t;

/// Words of a row over `planes` planes, at least one.
constexpr std::size_t sign_words(std::size_t planes) { return planes == 0 ? 1 : (planes + 63) / 64; }

/// A sign vector stored elsewhere; both rows have the same length.
struct SignView {
  std::span<const SignWord> pos, zero;
};

inline bool has_bit(std::span<const SignWord> row, PlaneId plane) {
  return (row[plane.value / 64] >> (plane.value % 64) & 1) != 0;
}
inline void set_bit(std::span<SignWord> row, PlaneId plane) {
  row[plane.value / 64] |= SignWord{1} << (plane.value % 64);
}

/// -1, 0 or +1.
inline int sign_at(SignView v, PlaneId plane) {
  return has_bit(v.zero, plane) ? 0 : has_bit(v.pos, plane) ? 1 : -1;
}

/// True iff what has the signs `low` may lie in the closure of what has the signs `high`: every sign of `low`
/// is 0 or that of `high`. Within a box whose planes are not among the k, this is incidence with a cell.
/// O(words), no branches inside.
inline bool in_closure(SignView low, SignView high) {
  SignWord differs = 0;
  for (std::size_t w = 0; w < low.pos.size(); ++w)
    differs |= ((high.pos[w] ^ low.pos[w]) | high.zero[w]) & ~low.zero[w];
  return differs == 0;
}

inline bool equal_signs(SignView a, SignView b) {
  SignWord differs = 0;
  for (std::size_t w = 0; w < a.pos.size(); ++w) differs |= (a.pos[w] ^ b.pos[w]) | (a.zero[w] ^ b.zero[w]);
  return differs == 0;
}

}  // namespace crossloft
