/// Spikes on sections that have solid on their other side.

#include <algorithm>
#include <tuple>

#include "pipeline.h"

namespace crossloft {
namespace {

struct SpikeInCell {
  std::uint32_t cell = 0;
  const SpikeOnFace* spike = nullptr;

  friend bool operator<(const SpikeInCell& x, const SpikeInCell& y) {
    return std::tie(x.spike->confidence, x.cell, x.spike->tet) <
           std::tie(y.spike->confidence, y.cell, y.spike->tet);
  }
};

/// The least sure first.
std::vector<SpikeInCell> all_spikes(std::span<const CellState> cells) {
  std::vector<SpikeInCell> list;
  for (std::uint32_t c = 0; c < cells.size(); ++c)
    for (const SpikeOnFace& spike : cells[c].spikes) list.push_back({c, &spike});
  std::sort(list.begin(), list.end());
  return list;
}

}  // namespace

/// A section in one plane alone may have a spike on either side; it keeps the surer one.
Result<Done> Pipeline::drop_spikes() {
  const std::vector<SpikeInCell> spikes = all_spikes(cells_);
  if (spikes.empty()) return Done{};
  for (std::uint32_t c = 0; c < cells_.size(); ++c)
    if (cells_[c].report.tets_r0 != 0) cover(CellId{c}, cells_[c].ground);
  bool changes = false;
  for (const SpikeInCell& s : spikes) {
    const std::vector<FaceId> ids = inner_faces(CellId{s.cell});
    const auto side = [&](const GroundTriangle& g) {
      return arrangement_->cells_of(ids[g.face])[0] == CellId{s.cell} ? 0U : 1U;
    };
    const auto covered = [&](const GroundTriangle& g, unsigned of) -> auto& {
      return faces_[ids[g.face].value].covered[of][g.triangle];
    };
    const std::vector<GroundTriangle>& ground = s.spike->ground;
    if (!std::all_of(ground.begin(), ground.end(),
                     [&](const GroundTriangle& g) { return covered(g, 1 - side(g)) != 0; }))
      continue;
    for (const GroundTriangle& g : ground) covered(g, side(g)) = 0;
    cells_[s.cell].asked.dropped.push_back(s.spike->tet);
    cells_[s.cell].due = changes = true;
  }
  return changes ? prune_again() : Result<Done>(Done{});
}

}  // namespace crossloft
