#include "section_parts.h"

#include <algorithm>

namespace crossloft {
namespace {

void sort_and_thin(std::vector<std::uint32_t>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace

std::vector<SectionPart> section_parts(const CellComplex& complex, const Ground& ground) {
  std::vector<SectionPart> parts;
  for (std::uint32_t g = 0; g < ground.size(); ++g) {
    if (ground.part(g) == g) parts.push_back({g, {}, {}});
    const auto part =
        std::lower_bound(parts.begin(), parts.end(), ground.part(g),
                         [](const SectionPart& p, std::uint32_t number) { return p.number < number; });
    const Facet& f = ground.facet(g);
    std::array<std::uint32_t, 3> v;
    for (unsigned k = 0; k < 3; ++k) v[k] = complex.mesh.vertices[f.tet][kFacetSlots[f.facet][k]];
    part->vertices.insert(part->vertices.end(), v.begin(), v.end());
    part->faces.push_back(complex.common_face(v[0], v[1], v[2]));
  }
  for (SectionPart& part : parts) sort_and_thin(part.vertices), sort_and_thin(part.faces);
  std::sort(parts.begin(), parts.end(),
            [](const SectionPart& p, const SectionPart& q) { return p.vertices < q.vertices; });
  return parts;
}

SeenBodies::SeenBodies(std::span<const SectionPart> parts) : sets_(parts.size()) {
  for (const SectionPart& part : parts) faces_.push_back(part.faces);
}

std::size_t SeenBodies::planes_at_both(std::uint32_t a, std::uint32_t b) const {
  return std::min(faces_[a].size(), faces_[b].size());
}

void SeenBodies::join(std::uint32_t a, std::uint32_t b) {
  std::vector<std::uint32_t> both = faces_[a];
  both.insert(both.end(), faces_[b].begin(), faces_[b].end());
  sort_and_thin(both);
  sets_.join(a, b);
  faces_[sets_.find(a)] = std::move(both);
}

std::optional<std::array<std::uint32_t, 2>> bodies_of(const Join& join, std::span<const SectionPart> parts,
                                                      SeenBodies& bodies) {
  for (std::uint32_t a = 0; a < parts.size(); ++a)
    for (std::uint32_t b = 0; b < parts.size(); ++b)
      if (parts[a].vertices.front() == join.a && parts[b].vertices.front() == join.b &&
          bodies.body_of(a) != bodies.body_of(b))
        return std::array{bodies.body_of(a), bodies.body_of(b)};
  return std::nullopt;
}

}  // namespace crossloft
