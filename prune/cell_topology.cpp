#include "cell_topology.h"

#include <array>

#include "disjoint_sets.h"

namespace crossloft {
namespace {

/// S as triangles with paired sides. Triangle = a facet of a kept tetrahedron, or of the bare one above a
/// ground triangle; its sides and corners in the order of kFacetSlots.
class CellSurface {
 public:
  CellSurface(const CellComplex& complex, const Ground& ground, const std::vector<std::uint8_t>& kept)
      : complex_(complex), ground_(ground), kept_(kept), of_facet_(kept.size()) {
    collect();
    pair_sides();
  }

  std::uint32_t size() const { return static_cast<std::uint32_t>(facets_.size()); }
  std::uint32_t bare() const { return bare_; }

  void count(CellTopology& topology) {
    const std::uint32_t components = components_.count();
    const auto edges = (3 * std::int64_t{size()} + static_cast<std::int64_t>(ends_.size())) / 2;
    const std::int64_t euler = std::int64_t{corners_.count()} - edges + size();
    topology.euler = euler;
    topology.curves = curves();
    topology.genus = static_cast<std::uint32_t>(components - (euler + topology.curves) / 2);
    topology.outsides = components + 1 - topology.bodies;
    std::vector<std::uint8_t> has_boundary(size(), 0);
    std::uint32_t open = 0;
    for (const std::uint32_t side : ends_) {
      std::uint8_t& seen = has_boundary[components_.find(side / 3)];
      open += seen == 0 ? 1U : 0U;
      seen = 1;
    }
    topology.voids = components - open;
  }

 private:
  void collect() {
    for (std::uint32_t t = 0; t < kept_.size(); ++t)
      for (std::uint8_t i = 0; i < 4; ++i) {
        of_facet_[t][i] = kNone;
        const std::uint32_t n = complex_.mesh.neighbours[t][i];
        const bool on_ground = ground_.is_ground(t, i);
        const bool ends_here = kept_[t] != 0 ? !on_ground && (n == kNone || kept_[n] == 0) : on_ground;
        if (!ends_here) continue;
        of_facet_[t][i] = size();
        facets_.push_back({t, i});
        bare_ += on_ground ? 1U : 0U;
      }
  }

  /// Sides are paired through the solid, as in gluing.
  void pair_sides() {
    corners_.reset(std::size_t{3} * size());
    components_.reset(size());
    for (std::uint32_t s = 0; s < size(); ++s)
      for (unsigned k = 0; k < 3; ++k) {
        const auto& slots = kFacetSlots[facets_[s].facet];
        const unsigned corner = kEdgeCorner[slots[k]][slots[(k + 1) % 3]];
        const Facet mate = across(facets_[s], corner);
        if (mate.tet == kNone) {
          ends_.push_back(3 * s + k);
        } else {
          join(s, k, mate);
        }
      }
  }

  Facet across(Facet f, unsigned corner) const {
    if (kept_[f.tet] == 0) return turn_through_solid(complex_, ground_, kept_, f, corner);
    return turn_through_solid(complex_, ground_, kept_, {f.tet, other_facet(f.facet, corner)}, corner);
  }

  void join(std::uint32_t s, unsigned k, Facet mate) {
    const std::uint32_t m = of_facet_[mate.tet][mate.facet];
    components_.join(s, m);
    const auto& here = complex_.mesh.vertices[facets_[s].tet];
    const auto& there = complex_.mesh.vertices[mate.tet];
    for (const unsigned end : {k, (k + 1) % 3}) {
      const std::uint32_t v = here[kFacetSlots[facets_[s].facet][end]];
      for (unsigned j = 0; j < 3; ++j)
        if (there[kFacetSlots[mate.facet][j]] == v) corners_.join(3 * s + end, 3 * m + j);
    }
  }

  /// Boundary curves: unpaired sides that follow each other. An umbrella has none or two of them.
  std::uint32_t curves() {
    DisjointSets sets(ends_.size());
    std::vector<std::uint32_t> first(std::size_t{3} * size(), kNone);  // by umbrella
    for (std::uint32_t e = 0; e < ends_.size(); ++e) {
      const std::uint32_t s = ends_[e] / 3, k = ends_[e] % 3;
      for (const std::uint32_t end : {k, (k + 1) % 3}) {
        std::uint32_t& other = first[corners_.find(3 * s + end)];
        if (other == kNone) {
          other = e;
        } else {
          sets.join(e, other);
        }
      }
    }
    return sets.count();
  }

  const CellComplex& complex_;
  const Ground& ground_;
  const std::vector<std::uint8_t>& kept_;
  std::vector<std::array<std::uint32_t, 4>> of_facet_;
  std::vector<Facet> facets_;
  std::vector<std::uint32_t> ends_;  ///< unpaired sides, 3 * triangle + side
  std::uint32_t bare_ = 0;
  DisjointSets components_, corners_;
};

std::uint32_t count_bodies(const CellComplex& complex, const Ground& ground,
                           const std::vector<std::uint8_t>& kept) {
  const std::uint32_t n = complex.mesh.size();
  DisjointSets bodies(std::size_t{n} + ground.size());
  for (std::uint32_t t = 0; t < n; ++t) {
    if (kept[t] == 0) continue;
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t other = complex.mesh.neighbours[t][i];
      if (other != kNone && kept[other] != 0 && other < t) bodies.join(t, other);
      if (ground.is_ground(t, i)) bodies.join(t, n + ground.at(t, i));
    }
  }
  std::uint32_t count = 0;
  for (std::uint32_t g = 0; g < ground.size(); ++g) bodies.join(n + g, n + ground.part(g));
  for (std::uint32_t x = 0; x < n + ground.size(); ++x)
    count += bodies.is_root(x) && (x >= n || kept[x] != 0) ? 1U : 0U;
  return count;
}

}  // namespace

CellTopology count_topology(const CellComplex& complex, const Ground& ground,
                            const std::vector<std::uint8_t>& kept) {
  CellTopology topology;
  topology.sections = ground.part_count();
  topology.bodies = count_bodies(complex, ground, kept);
  CellSurface surface(complex, ground, kept);
  topology.bare = surface.bare();
  surface.count(topology);
  return topology;
}

}  // namespace crossloft
