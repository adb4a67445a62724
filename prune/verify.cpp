#include "verify.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "../geom/disjoint_sets.h"
#include "cell_topology.h"
#include "star.h"

namespace crossloft {
namespace {

using Triple = std::array<std::uint32_t, 3>;

struct KeptFacet {
  Triple vertices;  ///< sorted
  std::uint32_t tet;
};

Triple sorted_facet(const std::array<std::uint32_t, 4>& tet, unsigned facet) {
  Triple triple{};
  for (unsigned i = 0; i < 3; ++i) triple[i] = tet[kFacetSlots[facet][i]];
  std::sort(triple.begin(), triple.end());
  return triple;
}

bool has_right_sizes(const CellComplex& complex) {
  const std::size_t n = complex.mesh.vertices.size();
  return complex.mesh.neighbours.size() == n && complex.facets.size() == n && complex.edges.size() == n &&
         complex.words >= 1 && complex.face_masks.size() == std::size_t{complex.words} * complex.vertex_count;
}

bool has_distinct_vertices(const CellComplex& complex, std::uint32_t t) {
  auto v = complex.mesh.vertices[t];
  std::sort(v.begin(), v.end());
  return std::adjacent_find(v.begin(), v.end()) == v.end() && v[3] < complex.vertex_count;
}

bool is_mutual(const TetMesh& mesh, std::uint32_t t, unsigned facet) {
  const std::uint32_t n = mesh.neighbours[t][facet];
  if (n == kNone) return true;
  if (n >= mesh.size() || n == t) return false;
  const auto& back = mesh.neighbours[n];
  const auto way = static_cast<unsigned>(std::find(back.begin(), back.end(), t) - back.begin());
  return way < 4 && sorted_facet(mesh.vertices[t], facet) == sorted_facet(mesh.vertices[n], way);
}

/// True iff some face of the cell passes through all the vertices.
bool share_a_face(const CellComplex& complex, std::initializer_list<std::uint32_t> vertices) {
  for (std::uint32_t w = 0; w < complex.words; ++w) {
    std::uint64_t common = ~std::uint64_t{0};
    for (const std::uint32_t v : vertices) common &= complex.faces_of(v)[w];
    if (common != 0) return true;
  }
  return false;
}

bool has_right_kinds(const CellComplex& complex, std::uint32_t t) {
  const auto& v = complex.mesh.vertices[t];
  for (unsigned i = 0; i < 4; ++i) {
    const auto& s = kFacetSlots[i];
    const bool grounded = complex.facets[t][i] != FacetKind::free;
    if (grounded != share_a_face(complex, {v[s[0]], v[s[1]], v[s[2]]})) return false;
    if (grounded && complex.mesh.neighbours[t][i] != kNone) return false;
  }
  for (unsigned e = 0; e < 6; ++e) {
    const bool grounded = complex.edges[t][e] != EdgeKind::free;
    if (grounded != share_a_face(complex, {v[kEdgeSlots[e][0]], v[kEdgeSlots[e][1]]})) return false;
  }
  return true;
}

/// An edge has one kind, whichever tetrahedron is asked.
bool edges_agree(const CellComplex& complex) {
  using Entry = std::tuple<std::uint32_t, std::uint32_t, EdgeKind>;
  std::vector<Entry> all;
  all.reserve(std::size_t{6} * complex.mesh.size());
  for (std::uint32_t t = 0; t < complex.mesh.size(); ++t) {
    for (unsigned e = 0; e < 6; ++e) {
      const auto [a, b] =
          std::minmax(complex.mesh.vertices[t][kEdgeSlots[e][0]], complex.mesh.vertices[t][kEdgeSlots[e][1]]);
      all.emplace_back(a, b, complex.edges[t][e]);
    }
  }
  std::sort(all.begin(), all.end());
  return std::adjacent_find(all.begin(), all.end(), [](const Entry& p, const Entry& q) {
           return std::get<0>(p) == std::get<0>(q) && std::get<1>(p) == std::get<1>(q) &&
                  std::get<2>(p) != std::get<2>(q);
         }) == all.end();
}

std::vector<KeptFacet> facets_of_kept(const TetMesh& mesh, const std::vector<std::uint8_t>& kept) {
  std::vector<KeptFacet> all;
  for (std::uint32_t t = 0; t < mesh.size(); ++t) {
    if (kept[t] == 0) continue;
    for (unsigned i = 0; i < 4; ++i) all.push_back({sorted_facet(mesh.vertices[t], i), t});
  }
  std::sort(all.begin(), all.end(), [](const KeptFacet& p, const KeptFacet& q) {
    return std::tie(p.vertices, p.tet) < std::tie(q.vertices, q.tet);
  });
  return all;
}

std::uint32_t node(const TetMesh& mesh, std::uint32_t t, std::uint32_t a, std::uint32_t b) {
  const unsigned i = slot_of(mesh.vertices[t], a);
  const unsigned j = slot_of(mesh.vertices[t], b);
  return t * kCorners + (i == j ? i : kEdgeCorner[i][j]);
}

/// One set for each part of a star that is connected across facets: nodes are t * kCorners + corner.
DisjointSets star_parts(const TetMesh& mesh, const std::vector<std::uint8_t>& kept) {
  DisjointSets parts(std::size_t{kCorners} * mesh.size());
  const std::vector<KeptFacet> facets = facets_of_kept(mesh, kept);
  for (std::size_t k = 0; k + 1 < facets.size(); ++k) {
    if (facets[k].vertices != facets[k + 1].vertices) continue;
    for (const std::uint32_t a : facets[k].vertices) {
      for (const std::uint32_t b : facets[k].vertices) {
        parts.join(node(mesh, facets[k].tet, a, b), node(mesh, facets[k + 1].tet, a, b));
      }
    }
  }
  return parts;
}

bool is_solid(const CellComplex& complex, const std::vector<std::uint8_t>& kept) {
  DisjointSets parts = star_parts(complex.mesh, kept);
  std::vector<std::uint8_t> grounded(std::size_t{kCorners} * kept.size(), 0);
  for (std::uint32_t t = 0; t < kept.size(); ++t) {
    for (unsigned corner = 0; corner < kCorners; ++corner) {
      if (kept[t] != 0 && is_on_ground(complex, t, corner)) grounded[parts.find(t * kCorners + corner)] = 1;
    }
  }
  for (std::uint32_t t = 0; t < kept.size(); ++t) {
    for (unsigned corner = 0; corner < kCorners; ++corner) {
      if (kept[t] == 0 || !is_grounded(complex, t, corner)) continue;
      if (grounded[parts.find(t * kCorners + corner)] == 0) return false;
    }
  }
  return true;
}

bool conforms(const CellComplex& complex, const std::vector<std::uint8_t>& kept) {
  for (std::uint32_t t = 0; t < kept.size(); ++t) {
    if (kept[t] == 0) continue;
    for (const FacetKind kind : complex.facets[t]) {
      if (kind == FacetKind::external) return false;
    }
    for (const EdgeKind kind : complex.edges[t]) {
      if (kind == EdgeKind::external) return false;
    }
  }
  return true;
}

bool counts_fit(const PruneResult& result) {
  return result.r0 == result.kept.size() && result.r0 >= result.r1 && result.r1 >= result.r3 &&
         result.r1 >= result.r2 &&
         result.r3 ==
             static_cast<std::size_t>(std::count(result.kept.begin(), result.kept.end(), std::uint8_t{1}));
}

}  // namespace

bool verify(const CellComplex& complex) {
  if (!has_right_sizes(complex)) return false;
  for (std::uint32_t t = 0; t < complex.mesh.size(); ++t) {
    if (!has_distinct_vertices(complex, t)) return false;
  }
  for (std::uint32_t t = 0; t < complex.mesh.size(); ++t) {
    for (unsigned i = 0; i < 4; ++i) {
      if (!is_mutual(complex.mesh, t, i)) return false;
    }
    if (!has_right_kinds(complex, t)) return false;
  }
  return edges_agree(complex);
}

bool verify(const CellComplex& complex, const PruneResult& result) {
  return result.kept.size() == complex.mesh.size() && counts_fit(result) && result.r3 >= result.r2 &&
         conforms(complex, result.kept) && is_solid(complex, result.kept);
}

bool verify_natural(const CellComplex& complex, const PruneResult& result) {
  if (result.kept.size() != complex.mesh.size() || !counts_fit(result)) return false;
  const CellTopology found = count_topology(complex, Ground(complex), result.kept);
  return conforms(complex, result.kept) && found == result.natural.after &&
         found.genus <= result.natural.handles && found.voids == 0 && found.bodies <= found.sections;
}

}  // namespace crossloft
