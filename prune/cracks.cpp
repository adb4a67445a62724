#include "cracks.h"

#include <algorithm>
#include <span>

#include "../geom/disjoint_sets.h"
#include "contact.h"
#include "star.h"

namespace crossloft {
namespace {

using Crack = std::vector<std::uint32_t>;

/// Parts of what is allowed but not kept; tetrahedra that share a vertex (`wide`) or a facet are in one part.
std::vector<Crack> find_cracks(const CellComplex& complex, const std::vector<std::uint8_t>& allowed,
                               const std::vector<std::uint8_t>& kept, bool wide) {
  const std::uint32_t n = complex.mesh.size();
  std::vector<std::uint32_t> open;
  for (std::uint32_t t = 0; t < n; ++t)
    if (allowed[t] != 0 && kept[t] == 0) open.push_back(t);
  std::sort(open.begin(), open.end(), [&](std::uint32_t a, std::uint32_t b) {
    return sorted_vertices(complex.mesh, a) < sorted_vertices(complex.mesh, b);
  });
  DisjointSets parts(open.size());
  std::vector<std::uint32_t> place(n, kNone), at_vertex(complex.vertex_count, kNone);
  for (std::uint32_t i = 0; i < open.size(); ++i) {
    place[open[i]] = i;
    if (wide)
      for (const std::uint32_t v : complex.mesh.vertices[open[i]]) {
        if (at_vertex[v] == kNone) at_vertex[v] = i;
        parts.join(i, at_vertex[v]);
      }
  }
  for (std::uint32_t i = 0; i < open.size(); ++i)
    for (const std::uint32_t other : complex.mesh.neighbours[open[i]])
      if (other != kNone && place[other] != kNone) parts.join(i, place[other]);
  std::vector<Crack> cracks;
  std::vector<std::uint32_t> number(open.size(), kNone);
  for (std::uint32_t i = 0; i < open.size(); ++i) {
    std::uint32_t& k = number[parts.find(i)];
    if (k == kNone) {
      k = static_cast<std::uint32_t>(cracks.size());
      cracks.emplace_back();
    }
    cracks[k].push_back(open[i]);
  }
  return cracks;
}

/// The solid is as it was but for what is filled.
bool is_as_good(const CellTopology& now, const CellTopology& before) {
  return now.genus == before.genus && now.voids <= before.voids && now.bodies == before.bodies &&
         now.outsides <= before.outsides;
}

/// Vertices where sections touch: the umbrellas there can change how boundary curves follow each other.
std::vector<std::uint8_t> touching_vertices(const CellComplex& complex, const Ground& ground) {
  std::vector<std::uint8_t> ends(complex.vertex_count, 0);
  for (std::uint32_t g = 0; g < ground.size(); ++g)
    for (unsigned k = 0; k < 3; ++k) {
      if (ground.neighbour(g, k) != kNone) continue;
      const Facet& f = ground.facet(g);
      for (const unsigned end : {k, (k + 1) % 3}) {
        std::uint8_t& count = ends[complex.mesh.vertices[f.tet][kFacetSlots[f.facet][end]]];
        count = static_cast<std::uint8_t>(std::min(count + 1, 3));
      }
    }
  for (std::uint8_t& count : ends) count = count > 2 ? 1 : 0;
  return ends;
}

/// Sets of cracks are tried as a whole, then by halves where that is not good: few are bad.
///
/// A set changes euler + curves of S by twice the sum of what its tetrahedra change in the solid
/// (simple_growth.h), unless sections touch there. While the cell keeps its handles,
///     genus = components - (euler + curves) / 2 and components = bodies + outsides - 1
/// leave a good set nothing but to change `outsides` by that sum. Parts of the outside never come together,
/// and one vanishes only with all cracks that it consists of. So a sum above 0, or below what parts of cracks
/// alone there are, rules a set out, and so does a change of bodies.
class Refill {
 public:
  /// `cracks`: those across facets.
  Refill(const CellComplex& complex, const Ground& ground, GrowingSolid& solid,
         const std::vector<Crack>& cracks)
      : complex_(complex),
        ground_(ground),
        cracks_(cracks),
        solid_(solid),
        topology_(count_topology(complex, ground, solid.kept())),
        touching_(touching_vertices(complex, ground)),
        crack_of_(solid.kept().size(), kNone),
        closes_(cracks.size(), 0) {
    for (std::uint32_t c = 0; c < cracks.size(); ++c)
      for (const std::uint32_t t : cracks[c]) crack_of_[t] = c;
    find_closed();
  }

  void run(std::span<const Crack> cracks) {
    std::vector<std::span<const Crack>> next;
    if (!cracks.empty()) next.push_back(cracks);
    while (!next.empty() && trials_ < kMostTrials) {
      const std::span<const Crack> set = next.back();
      next.pop_back();
      if (fill(set) || set.size() == 1) continue;
      next.push_back(set.subspan(set.size() / 2));
      next.push_back(set.first(set.size() / 2));
    }
  }

  const CellTopology& topology() const { return topology_; }

 private:
  static constexpr int kMostTrials = 40;

  bool is_filled(const Crack& crack) const { return solid_.has(crack[0]); }

  /// Marks the first crack of each part of the outside that consists of open cracks alone.
  void find_closed() {
    DisjointSets parts(cracks_.size());
    std::vector<std::uint8_t> opens(cracks_.size(), 0);
    for (std::uint32_t c = 0; c < cracks_.size(); ++c)
      for (const std::uint32_t t : cracks_[c]) {
        if (is_filled(cracks_[c])) continue;
        for_outside(t, [&](std::uint32_t n) {
          if (n == kNone || crack_of_[n] == kNone) {
            opens[c] = 1;
          } else {
            parts.join(c, crack_of_[n]);
          }
        });
      }
    for (std::uint32_t c = 0; c < cracks_.size(); ++c) opens[parts.find(c)] |= opens[c];
    for (std::uint32_t c = 0; c < cracks_.size(); ++c)
      closes_[c] = parts.is_root(c) && opens[c] == 0 && !is_filled(cracks_[c]) ? 1 : 0;
  }

  bool fill(std::span<const Crack> set) {
    ++trials_;
    solid_.begin_trial();
    bool good = add(set);
    if (good) {
      const CellTopology now = count_topology(complex_, ground_, solid_.kept());
      good = is_as_good(now, topology_);
      if (good) topology_ = now;
    }
    solid_.end_trial(good);
    if (good) find_closed();
    return good;
  }

  /// Visits what is outside across a facet of t, or beyond the solid at an edge of a facet; kNone is beyond
  /// the hull.
  template <class Visit>
  void for_outside(std::uint32_t t, Visit visit) const {
    for (std::uint8_t i = 0; i < 4; ++i) {
      const std::uint32_t n = complex_.mesh.neighbours[t][i];
      if (n == kNone ? !ground_.is_ground(t, i) : !solid_.has(n)) {
        visit(n);
        continue;
      }
      for (unsigned corner = 4; corner < kCorners; ++corner) {
        if (!facet_contains(i, corner)) continue;
        const Facet end = turn_through_solid(complex_, ground_, solid_.kept(), {t, i}, corner);
        if (end.tet != kNone)
          visit(solid_.has(end.tet) ? complex_.mesh.neighbours[end.tet][end.facet] : end.tet);
      }
    }
  }

  /// Adds the set to the solid; false if that rules it out.
  bool add(std::span<const Crack> set) {
    int change = 0, bodies = 0, closed = 0;
    bool touches = false;
    for (const Crack& crack : set)
      for (const std::uint32_t t : crack) {
        const Contact contact = solid_.contact(t);
        change += contact.change();
        bodies += 1 - contact.different_bodies();
        const std::uint32_t c = crack_of_[t];
        closed += cracks_[c][0] == t ? closes_[c] : 0;
        for (const std::uint32_t v : complex_.mesh.vertices[t]) touches |= touching_[v] != 0;
        solid_.add(t);
      }
    if (bodies != 0) return false;
    return touches || (change <= 0 && change >= -closed);
  }

  const CellComplex& complex_;
  const Ground& ground_;
  const std::vector<Crack>& cracks_;
  GrowingSolid& solid_;
  CellTopology topology_;
  std::vector<std::uint8_t> touching_;   ///< by vertex
  std::vector<std::uint32_t> crack_of_;  ///< by tetrahedron
  std::vector<std::uint8_t> closes_;     ///< by crack
  int trials_ = 0;
};

}  // namespace

CellTopology refill_cracks(const CellComplex& complex, const Ground& ground,
                           const std::vector<std::uint8_t>& allowed, GrowingSolid& solid) {
  const std::vector<Crack> cracks = find_cracks(complex, allowed, solid.kept(), false);
  if (cracks.empty()) return count_topology(complex, ground, solid.kept());
  Refill refill(complex, ground, solid, cracks);
  refill.run(find_cracks(complex, allowed, solid.kept(), true));
  std::vector<Crack> open = cracks;
  std::erase_if(open, [&](const Crack& crack) { return solid.has(crack[0]); });
  refill.run(open);
  return refill.topology();
}

}  // namespace crossloft
