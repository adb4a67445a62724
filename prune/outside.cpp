#include "outside.h"

#include "../geom/disjoint_sets.h"
#include "star.h"

namespace crossloft {
namespace {

/// Parts of what is not kept, across facets, and what each opens to.
struct OutsideParts {
  OutsideParts(const CellComplex& complex, const std::vector<std::uint8_t>& kept) : of(kept.size(), kNone) {
    std::vector<std::uint32_t> stack;
    for (std::uint32_t start = 0; start < kept.size(); ++start) {
      if (kept[start] != 0 || of[start] != kNone) continue;
      const auto part = static_cast<std::uint32_t>(openings.size());
      openings.emplace_back(complex);
      of[start] = part;
      for (stack.assign(1, start); !stack.empty();) {
        const std::uint32_t t = stack.back();
        stack.pop_back();
        openings[part].add(t);
        for (const std::uint32_t n : complex.mesh.neighbours[t]) {
          if (n == kNone || kept[n] != 0 || of[n] != kNone) continue;
          of[n] = part;
          stack.push_back(n);
        }
      }
    }
  }

  std::vector<std::uint32_t> of;  ///< by tetrahedron, kNone for kept ones
  std::vector<OpeningOf> openings;
};

}  // namespace

void OpeningOf::add(std::uint32_t t) {
  for (unsigned i = 0; i < 4 && kind_ != Opening::wide; ++i) add(t, i);
}

void OpeningOf::add(std::uint32_t t, unsigned facet) {
  const FacetKind kind = complex_->facets[t][facet];
  if (complex_->mesh.neighbours[t][facet] != kNone || kind == FacetKind::internal) return;
  if (kind == FacetKind::free) {
    kind_ = Opening::wide;
    return;
  }
  const auto& v = complex_->mesh.vertices[t];
  const auto& slots = kFacetSlots[facet];
  add_hole(complex_->common_face(v[slots[0]], v[slots[1]], v[slots[2]]));
}

void OpeningOf::add(const OpeningOf& other) {
  if (other.kind_ == Opening::wide) kind_ = Opening::wide;
  if (other.kind_ == Opening::hole) add_hole(other.face_);
}

void OpeningOf::add_hole(std::uint32_t face) {
  if (kind_ == Opening::none) {
    kind_ = Opening::hole;
    face_ = face;
  } else if (face != face_) {
    kind_ = Opening::wide;
  }
}

OutsidePart outside_part(const CellComplex& complex, const std::vector<std::uint8_t>& kept,
                         std::uint32_t start) {
  OutsidePart part{{start}, OpeningOf(complex)};
  std::vector<std::uint8_t> seen(kept.begin(), kept.end());
  seen[start] = 1;
  for (std::size_t head = 0; head < part.tets.size(); ++head) {
    const std::uint32_t t = part.tets[head];
    part.opening.add(t);
    for (unsigned corner = 4; corner < kCorners; ++corner)
      visit_around_edge(complex.mesh, t, corner, [&](std::uint32_t n, unsigned) {
        if (seen[n] == 0) part.tets.push_back(n);
        seen[n] = 1;
      });
  }
  return part;
}

bool has_dome(const CellComplex& complex, const std::vector<std::uint8_t>& kept) {
  OutsideParts parts(complex, kept);
  std::vector<OpeningOf>& openings = parts.openings;
  DisjointSets together(openings.size());
  // What is wide stays so with more of it: only the edges of the rest, which is little, are walked around.
  for (std::uint32_t t = 0; t < kept.size(); ++t) {
    if (kept[t] != 0 || openings[parts.of[t]].kind() == Opening::wide) continue;
    for (unsigned corner = 4; corner < kCorners; ++corner)
      visit_around_edge(complex.mesh, t, corner, [&](std::uint32_t n, unsigned) {
        if (kept[n] == 0) together.join(parts.of[t], parts.of[n]);
      });
  }
  for (std::uint32_t part = 0; part < openings.size(); ++part)
    openings[together.find(part)].add(openings[part]);
  for (std::uint32_t part = 0; part < openings.size(); ++part)
    if (together.is_root(part) && openings[part].kind() == Opening::hole) return true;
  return false;
}

}  // namespace crossloft
