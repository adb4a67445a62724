#include "link_parts.h"

namespace crossloft {

LinkParts::LinkParts(const CellComplex& complex, const Ground& ground, const std::vector<std::uint8_t>& kept)
    : complex_(complex),
      ground_(ground),
      parts_(4 * (complex.mesh.size() + ground.size())),
      bodies_(complex.mesh.size() + ground.size()) {
  join_kept(kept);
  join_ground(kept);
}

/// Across each facet between two, from the smaller number.
void LinkParts::join_kept(const std::vector<std::uint8_t>& kept) {
  for (std::uint32_t t = 0; t < complex_.mesh.size(); ++t)
    for (unsigned i = 0; i < 4 && kept[t] != 0; ++i) {
      const std::uint32_t n = complex_.mesh.neighbours[t][i];
      if (n == kNone || n < t || kept[n] == 0) continue;
      bodies_.join(t, n);
      for (const unsigned slot : kFacetSlots[i])
        parts_.join(4 * t + slot, corner_of(n, complex_.mesh.vertices[t][slot]));
    }
}

void LinkParts::join_ground(const std::vector<std::uint8_t>& kept) {
  for (std::uint32_t g = 0; g < ground_.size(); ++g) {
    const auto& [t, facet] = ground_.facet(g);
    const auto& slots = kFacetSlots[facet];
    if (kept[t] != 0) bodies_.join(t, number_of_ground(g));
    for (unsigned k = 0; k < 3; ++k) {
      const std::uint32_t v = complex_.mesh.vertices[t][slots[k]],
                          w = complex_.mesh.vertices[t][slots[(k + 1) % 3]];
      if (kept[t] != 0) parts_.join(corner_of(t, v), ground_corner_of(g, v));
      const std::uint32_t other = ground_.neighbour(g, k);
      if (other == kNone) continue;
      bodies_.join(number_of_ground(g), number_of_ground(other));
      for (const std::uint32_t end : {v, w})
        parts_.join(ground_corner_of(g, end), ground_corner_of(other, end));
    }
  }
}

}  // namespace crossloft
