#include "joins.h"

#include <algorithm>
#include <array>

#include "../geom/disjoint_sets.h"

namespace crossloft {
namespace {

/// Sets of ground triangles, then tetrahedra: a set has a ground triangle iff its root is one.
class Bodies {
 public:
  Bodies(const CellComplex& complex, const Ground& ground)
      : ground_(ground.size()),
        sets_(std::size_t{ground.size()} + complex.mesh.size()),
        names_(part_names(complex, ground)) {
    for (std::uint32_t g = 0; g < ground.size(); ++g) sets_.join(g, ground.part(g));
  }

  std::uint32_t tet(std::uint32_t t) const { return ground_ + t; }

  /// Tetrahedron t joins the pieces next to it, in the order of their names: not in that of its slots.
  void add(std::uint32_t t, std::span<std::uint32_t> pieces, std::int32_t confidence) {
    for (std::size_t k = 0; k < pieces.size(); ++k) {  // four at most: sorted as they come
      pieces[k] = sets_.find(pieces[k]);
      for (std::size_t i = k; i > 0 && pieces[i] < pieces[i - 1]; --i) std::swap(pieces[i], pieces[i - 1]);
    }
    pieces =
        pieces.first(static_cast<std::size_t>(std::unique(pieces.begin(), pieces.end()) - pieces.begin()));
    for (const std::uint32_t p : pieces) sets_.join(tet(t), p);
    if (pieces.size() < 2 || pieces[1] >= ground_) return;
    const auto bodies = pieces.begin(), end = std::lower_bound(bodies, pieces.end(), ground_);
    std::vector<std::uint32_t> names;
    for (auto p = bodies; p != end; ++p) names.push_back(names_[*p]);
    std::sort(names.begin(), names.end());
    for (std::size_t i = 1; i < names.size(); ++i) joins_.push_back({names[0], names[i], confidence, true});
    names_[pieces[0]] = names[0];
  }

  std::vector<Join> take() { return std::move(joins_); }

 private:
  std::uint32_t ground_;
  DisjointSets sets_;
  std::vector<std::uint32_t> names_;
  std::vector<Join> joins_;
};

}  // namespace

std::vector<std::uint32_t> part_names(const CellComplex& complex, const Ground& ground) {
  std::vector<std::uint32_t> names(ground.size(), kNone);
  for (std::uint32_t g = 0; g < ground.size(); ++g) {
    const Facet& f = ground.facet(g);
    std::uint32_t& name = names[ground.part(g)];
    for (const std::uint8_t slot : kFacetSlots[f.facet])
      name = std::min(name, complex.mesh.vertices[f.tet][slot]);
  }
  return names;
}

std::vector<std::uint32_t> by_confidence(const CellComplex& complex, const std::vector<std::uint8_t>& chosen,
                                         std::span<const std::int32_t> confidence) {
  std::vector<std::uint64_t> entries;  // by falling confidence, then tetrahedron
  for (std::uint32_t t = 0; t < chosen.size(); ++t)
    if (chosen[t] != 0)
      entries.push_back(static_cast<std::uint64_t>(std::int64_t{INT32_MAX} - confidence[t]) << 32 | t);
  std::sort(entries.begin(), entries.end());
  std::vector<std::uint32_t> order;
  order.reserve(entries.size());
  for (const std::uint64_t e : entries) order.push_back(static_cast<std::uint32_t>(e));
  for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
    while (last < order.size() && confidence[order[last]] == confidence[order[first]]) ++last;
    if (last - first < 2) continue;
    const auto at = order.begin();
    std::sort(at + static_cast<std::ptrdiff_t>(first), at + static_cast<std::ptrdiff_t>(last),
              [&](std::uint32_t x, std::uint32_t y) {
                return sorted_vertices(complex.mesh, x) < sorted_vertices(complex.mesh, y);
              });
  }
  return order;
}

std::vector<Join> find_joins(const CellComplex& complex, const Ground& ground,
                             const std::vector<std::uint8_t>& kept,
                             std::span<const std::int32_t> confidence) {
  Bodies bodies(complex, ground);
  std::vector<std::uint8_t> in(kept.size(), 0);
  for (const std::uint32_t t : by_confidence(complex, kept, confidence)) {
    in[t] = 1;
    std::array<std::uint32_t, 4> pieces;
    std::size_t count = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t other = complex.mesh.neighbours[t][i];
      if (other != kNone && in[other] != 0) pieces[count++] = bodies.tet(other);
      if (ground.is_ground(t, i)) pieces[count++] = ground.at(t, i);
    }
    bodies.add(t, std::span(pieces).first(count), confidence[t]);
  }
  return bodies.take();
}

}  // namespace crossloft
