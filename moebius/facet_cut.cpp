#include "facet_cut.h"

namespace crossloft {

void cut_facet(std::span<const Passage> sides, std::vector<FacetArc>& arcs) {
  FacetCrossing open, first_entry;  // the last exit without its entry; the first entry without its exit
  const auto enter = [&](std::uint32_t side) {
    if (open.side == kNone)
      first_entry = {side, 0};
    else
      arcs.push_back({open, {side, 0}});
    open = {};
  };
  for (std::uint32_t s = 0; s < sides.size(); ++s) {
    if (sides[s] == Passage::enters || sides[s] == Passage::dips) enter(s);
    if (sides[s] == Passage::leaves) open = {s, 0};
    if (sides[s] == Passage::dips) open = {s, 1};
  }
  // The cycle closes: what left last comes in where the walk first met the surface.
  if (open.side != kNone) arcs.push_back({open, first_entry});
}

}  // namespace crossloft
