#include "outside.h"

#include <algorithm>
#include <array>

#include "disjoint_sets.h"
#include "star.h"

namespace crossloft {
namespace {

struct EdgeUse {
  std::uint32_t a, b, tet;
  friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
};

/// Tetrahedra that share an edge share a part; those with a common facet have one, too.
DisjointSets parts_of(const CellComplex& complex, const std::vector<std::uint8_t>& kept) {
  std::vector<EdgeUse> uses;
  for (std::uint32_t t = 0; t < kept.size(); ++t) {
    if (kept[t] != 0) continue;
    for (const auto& ends : kEdgeSlots) {
      const std::uint32_t a = complex.mesh.vertices[t][ends[0]], b = complex.mesh.vertices[t][ends[1]];
      uses.push_back({std::min(a, b), std::max(a, b), t});
    }
  }
  std::sort(uses.begin(), uses.end());
  DisjointSets parts(kept.size());
  for (std::size_t i = 1; i < uses.size(); ++i)
    if (uses[i].a == uses[i - 1].a && uses[i].b == uses[i - 1].b) parts.join(uses[i].tet, uses[i - 1].tet);
  return parts;
}

}  // namespace

void OpeningOf::add(std::uint32_t t) {
  for (unsigned i = 0; i < 4 && kind_ != Opening::wide; ++i) {
    if (complex_.mesh.neighbours[t][i] != kNone || complex_.facets[t][i] == FacetKind::internal) continue;
    if (complex_.facets[t][i] == FacetKind::free) {
      kind_ = Opening::wide;
      continue;
    }
    const auto& v = complex_.mesh.vertices[t];
    const auto& slots = kFacetSlots[i];
    const std::uint32_t face = complex_.common_face(v[slots[0]], v[slots[1]], v[slots[2]]);
    if (kind_ == Opening::none) {
      kind_ = Opening::hole;
      face_ = face;
    } else if (face != face_) {
      kind_ = Opening::wide;
    }
  }
}

OutsidePart outside_part(const CellComplex& complex, const std::vector<std::uint8_t>& kept, std::uint32_t start) {
  OutsidePart part{{start}, OpeningOf(complex)};
  std::vector<std::uint8_t> seen(kept.begin(), kept.end());
  seen[start] = 1;
  for (std::size_t head = 0; head < part.tets.size(); ++head) {
    const std::uint32_t t = part.tets[head];
    part.opening.add(t);
    for (unsigned corner = 4; corner < kCorners; ++corner)
      visit_around_edge(complex.mesh, t, corner, [&](std::uint32_t n) {
        if (seen[n] == 0) part.tets.push_back(n);
        seen[n] = 1;
      });
  }
  return part;
}

bool has_dome(const CellComplex& complex, const std::vector<std::uint8_t>& kept) {
  DisjointSets parts = parts_of(complex, kept);
  std::vector<std::uint32_t> number(kept.size(), kNone);
  std::vector<OpeningOf> openings;
  for (std::uint32_t t = 0; t < kept.size(); ++t) {
    if (kept[t] != 0) continue;
    std::uint32_t& n = number[parts.find(t)];
    if (n == kNone) {
      n = static_cast<std::uint32_t>(openings.size());
      openings.emplace_back(complex);
    }
    openings[n].add(t);
  }
  return std::any_of(openings.begin(), openings.end(),
                     [](const OpeningOf& o) { return o.kind() == Opening::hole; });
}

}  // namespace crossloft
