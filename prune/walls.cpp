#include "walls.h"

#include <algorithm>

#include "../geom/disjoint_sets.h"
#include "ground.h"
#include "joins.h"
#include "outside.h"
#include "star.h"

namespace crossloft {
namespace {

/// Parts of the hull outside of the sections: its facets, as far as they hang together at edges outside.
class HullParts {
 public:
  explicit HullParts(const CellComplex& complex)
      : complex_(complex), of_(complex.mesh.size(), {kNone, kNone, kNone, kNone}) {
    for (std::uint32_t t = 0; t < complex.mesh.size(); ++t)
      for (unsigned i = 0; i < 4; ++i)
        if (is_outside(t, i) && of_[t][i] == kNone) flood(t, i);
  }

  std::uint32_t count() const { return static_cast<std::uint32_t>(wide_.size()); }
  /// Several faces, or the space beyond the hull.
  const std::vector<std::uint8_t>& wide() const { return wide_; }
  /// Of the facets of t, kNone for others.
  const std::array<std::uint32_t, 4>& at(std::uint32_t t) const { return of_[t]; }

 private:
  bool is_outside(std::uint32_t t, unsigned i) const {
    return complex_.mesh.neighbours[t][i] == kNone && complex_.facets[t][i] != FacetKind::internal;
  }

  void flood(std::uint32_t t, unsigned i) {
    OpeningOf opening(complex_);
    std::vector<Facet> list{{t, static_cast<std::uint8_t>(i)}};
    of_[t][i] = count();
    for (std::size_t head = 0; head < list.size(); ++head) {
      const Facet f = list[head];
      opening.add(f.tet, f.facet);
      for (unsigned corner = 4; corner < kCorners; ++corner) {
        const EdgeKind kind = complex_.edges[f.tet][corner - 4];
        if (!facet_contains(f.facet, corner) || kind == EdgeKind::contour || kind == EdgeKind::internal)
          continue;
        const Facet next = across(f, corner);
        if (of_[next.tet][next.facet] != kNone) continue;
        of_[next.tet][next.facet] = count();
        list.push_back(next);
      }
    }
    wide_.push_back(opening.kind() == Opening::wide ? 1 : 0);
  }

  /// The other facet of the hull at an edge: it is outside too, as the edge is.
  Facet across(Facet f, unsigned corner) const {
    Turn turn(f.tet, other_facet(f.facet, corner), f.facet);
    for (std::uint32_t n; (n = turn.next(complex_.mesh)) != kNone;) turn.enter(complex_.mesh, n);
    return {turn.tet(), turn.out()};
  }

  const CellComplex& complex_;
  std::vector<std::array<std::uint32_t, 4>> of_;
  std::vector<std::uint8_t> wide_;  ///< by part
};

/// Parts of the outside while tetrahedra come to it. Elements are the parts of the hull, then tetrahedra.
class GrowingOutside {
 public:
  GrowingOutside(const CellComplex& complex, const HullParts& hull)
      : complex_(complex),
        hull_(hull),
        sets_(hull.count() + complex.mesh.size()),
        wide_(hull.wide()),
        has_(complex.mesh.size(), 0) {
    wide_.resize(hull.count() + complex.mesh.size(), 0);
  }

  /// False, and nothing done, if t would connect two wide parts and may not.
  bool add(std::uint32_t t, bool may_connect) {
    gather(t);
    const auto wide = std::count_if(around_.begin(), around_.end(), [&](auto s) { return wide_[s] != 0; });
    if (wide > 1 && !may_connect) return false;
    has_[t] = 1;
    for (const std::uint32_t s : around_) sets_.join(s, element(t));
    wide_[sets_.find(element(t))] = wide > 0 ? 1 : 0;
    return true;
  }

 private:
  std::uint32_t element(std::uint32_t t) const { return hull_.count() + t; }

  /// The sets that t touches.
  void gather(std::uint32_t t) {
    around_.clear();
    for (const std::uint32_t part : hull_.at(t))
      if (part != kNone) around_.push_back(sets_.find(part));
    for (unsigned corner = 4; corner < kCorners; ++corner)
      visit_around_edge(complex_.mesh, t, corner, [&](std::uint32_t n, unsigned) {
        if (has_[n] != 0) around_.push_back(sets_.find(element(n)));
      });
    std::sort(around_.begin(), around_.end());
    around_.erase(std::unique(around_.begin(), around_.end()), around_.end());
  }

  const CellComplex& complex_;
  const HullParts& hull_;
  DisjointSets sets_;
  std::vector<std::uint8_t> wide_;  ///< by root
  std::vector<std::uint8_t> has_;   ///< tetrahedra that have come
  std::vector<std::uint32_t> around_;
};

/// Parts of the outside across facets.
struct OutsideAcrossFacets {
  std::vector<std::uint32_t> of;  ///< by tetrahedron, kNone for others
  std::uint32_t count = 0;

  OutsideAcrossFacets(const CellComplex& complex, const std::vector<std::uint8_t>& outside)
      : of(outside.size(), kNone) {
    std::vector<std::uint32_t> stack;
    for (std::uint32_t start = 0; start < outside.size(); ++start) {
      if (outside[start] == 0 || of[start] != kNone) continue;
      of[start] = count++;
      for (stack.assign(1, start); !stack.empty();) {
        const std::uint32_t t = stack.back();
        stack.pop_back();
        for (const std::uint32_t n : complex.mesh.neighbours[t]) {
          if (n == kNone || outside[n] == 0 || of[n] != kNone) continue;
          of[n] = of[start];
          stack.push_back(n);
        }
      }
    }
  }
};

/// By vertex the part that its tetrahedra outside are in; kNone if there are none, kSeveral.
constexpr std::uint32_t kSeveral = kNone - 1;
std::vector<std::uint32_t> parts_at_vertices(const CellComplex& complex, const OutsideAcrossFacets& parts) {
  std::vector<std::uint32_t> at(complex.vertex_count, kNone);
  for (std::uint32_t t = 0; t < parts.of.size(); ++t) {
    if (parts.of[t] == kNone) continue;
    for (const std::uint32_t v : complex.mesh.vertices[t])
      at[v] = at[v] == kNone || at[v] == parts.of[t] ? parts.of[t] : kSeveral;
  }
  return at;
}

/// Parts can meet only at edges with several of them at both ends: most need not be walked around.
bool connects_wide_parts(const CellComplex& complex, const HullParts& hull,
                         const std::vector<std::uint8_t>& outside) {
  const OutsideAcrossFacets parts(complex, outside);
  const std::vector<std::uint32_t> at = parts_at_vertices(complex, parts);
  DisjointSets sets(hull.count() + parts.count);
  for (std::uint32_t t = 0; t < outside.size(); ++t) {
    if (outside[t] == 0) continue;
    const auto& v = complex.mesh.vertices[t];
    for (const std::uint32_t part : hull.at(t))
      if (part != kNone) sets.join(part, hull.count() + parts.of[t]);
    for (unsigned e = 0; e < 6; ++e) {
      if (at[v[kEdgeSlots[e][0]]] != kSeveral || at[v[kEdgeSlots[e][1]]] != kSeveral) continue;
      visit_around_edge(complex.mesh, t, 4 + e, [&](std::uint32_t n, unsigned) {
        if (outside[n] != 0) sets.join(hull.count() + parts.of[t], hull.count() + parts.of[n]);
      });
    }
  }
  std::vector<std::uint8_t> has_wide(hull.count(), 0);  // the root of a set with a part of the hull is one
  for (std::uint32_t part = 0; part < hull.count(); ++part)
    if (hull.wide()[part] != 0 && has_wide[sets.find(part)]++ != 0) return true;
  return false;
}

}  // namespace

Walls find_walls(const CellComplex& complex, const std::vector<std::uint8_t>& solid, std::int32_t least,
                 const std::function<std::int32_t(std::uint32_t)>& confidence) {
  const HullParts hull(complex);
  Walls walls;
  walls.hull_parts = hull.count();
  if (std::count(hull.wide().begin(), hull.wide().end(), std::uint8_t{1}) < 2) return walls;
  std::vector<std::uint8_t> outside(solid.size());
  for (std::uint32_t t = 0; t < solid.size(); ++t) outside[t] = solid[t] == 0 ? 1 : 0;
  if (!connects_wide_parts(complex, hull, outside)) return walls;
  std::vector<std::int32_t> negative(solid.size());
  for (std::uint32_t t = 0; t < solid.size(); ++t)
    if (outside[t] != 0) negative[t] = -confidence(t);
  GrowingOutside growing(complex, hull);
  for (const std::uint32_t t : by_confidence(complex, outside, negative))
    if (!growing.add(t, -negative[t] < least)) walls.lacking.push_back(t);
  return walls;
}

}  // namespace crossloft
