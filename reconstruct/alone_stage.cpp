/// Bodies and bubbles that one plane alone would show: asked to change where that is surest.

#include <algorithm>

#include "pipeline.h"

namespace crossloft {
namespace {

/// A part as one of the cells at its face sees it.
struct Sight {
  Triangle name{};
  std::uint32_t face = 0, cell = 0;
  std::int32_t confidence = 0;
  bool can_change = false;

  bool same_part(const Sight& o) const { return name == o.name && face == o.face; }
};

std::vector<Sight> sights_of(std::span<const CellState> cells, std::vector<AlonePart> AloneParts::*list) {
  std::vector<Sight> sights;
  for (std::uint32_t c = 0; c < cells.size(); ++c)
    for (const AlonePart& part : cells[c].alone.*list)
      sights.push_back({part.name, part.face, c, part.confidence, part.can_change});
  std::sort(sights.begin(), sights.end(), [](const Sight& x, const Sight& y) {
    return std::tie(x.name, x.face, x.cell) < std::tie(y.name, y.face, y.cell);
  });
  return sights;
}

/// Calls visit(sights) for each part that both cells at its face see as alone, or the only one that has
/// tetrahedra.
template <class Visit>
void for_alone(const std::vector<Sight>& sights, const Arrangement& arrangement, std::span<const CellState> cells,
               Visit visit) {
  for (std::size_t first = 0, last = 0; first < sights.size(); first = last) {
    while (last < sights.size() && sights[last].same_part(sights[first])) ++last;
    const auto& sides = arrangement.cells_of(FaceId{sights[first].face});
    const auto is_empty = [&](CellId c) { return cells[c.value].report.tets_r0 == 0; };
    const std::size_t empty = std::count_if(sides.begin(), sides.end(), is_empty);
    if (last - first + empty >= 2) visit(std::span(sights).subspan(first, last - first));
  }
}

}  // namespace

/// Cells that are asked to join or to open something are pruned once more.
Result<Done> Pipeline::reconsider_alone() {
  TopologyReport& report = result_.report.topology;
  const auto surer = [](const Sight& x, const Sight& y) { return x.confidence < y.confidence; };
  for_alone(sights_of(cells_, &AloneParts::bodies), *arrangement_, cells_, [&](std::span<const Sight> seen) {
    std::vector<Sight> able;
    std::copy_if(seen.begin(), seen.end(), std::back_inserter(able), [](const Sight& s) { return s.can_change; });
    if (able.empty()) return;
    const Sight& best = *std::max_element(able.begin(), able.end(), surer);
    cells_[best.cell].asked.joined.push_back(best.name);
    ++report.alone_joined;
  });
  for_alone(sights_of(cells_, &AloneParts::bubbles), *arrangement_, cells_, [&](std::span<const Sight> seen) {
    if (seen.size() < 2) return;
    const Sight& best = *std::min_element(seen.begin(), seen.end(), surer);
    if (!best.can_change) return;
    cells_[best.cell].asked.opened.push_back(best.name);
    ++report.alone_opened;
  });
  for (CellState& cell : cells_) cell.due |= !cell.asked.joined.empty() || !cell.asked.opened.empty();
  return prune_due_cells();
}

}  // namespace crossloft
