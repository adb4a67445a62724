#pragma once
// Pruning written down again from the definitions, on sets of vertices: no neighbours, no slots, no
// shortcuts.

#include <algorithm>
#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <vector>

#include "prune/prune.h"

namespace crossloft::test {

class BruteForce {
 public:
  using Simplex = std::set<std::uint32_t>;
  using Solid = std::set<Simplex>;

  explicit BruteForce(const CellComplex& cell) {
    for (std::uint32_t t = 0; t < cell.mesh.size(); ++t) {
      const auto& v = cell.mesh.vertices[t];
      r0_.insert({v[0], v[1], v[2], v[3]});
      for (unsigned i = 0; i < 4; ++i) {
        const auto& s = kFacetSlots[i];
        if (cell.facets[t][i] != FacetKind::free) triangles_[{v[s[0]], v[s[1]], v[s[2]]}] = cell.facets[t][i];
      }
      for (unsigned e = 0; e < 6; ++e) {
        const auto& s = kEdgeSlots[e];
        if (cell.edges[t][e] != EdgeKind::free) edges_[{v[s[0]], v[s[1]]}] = cell.edges[t][e];
      }
    }
  }

  Solid run(PruneMode mode) const {
    Solid r1;
    for (const Simplex& t : r0_) {
      if (!is_external(t)) r1.insert(t);
    }
    if (mode == PruneMode::joint) return largest_solid(r1);
    Solid two_plane;
    for (const Simplex& t : r1) {
      if (is_two_plane(t)) two_plane.insert(t);
    }
    return step3(r1, two_plane, mode == PruneMode::paper);
  }

  bool is_solid(const Solid& r) const {
    return std::all_of(r.begin(), r.end(), [&](const Simplex& t) { return is_solid_at(r, t); });
  }

 private:
  static bool has(const Simplex& t, const Simplex& face) {
    return std::includes(t.begin(), t.end(), face.begin(), face.end());
  }
  static Simplex common(const Simplex& s, const Simplex& t) {
    Simplex both;
    std::set_intersection(s.begin(), s.end(), t.begin(), t.end(), std::inserter(both, both.end()));
    return both;
  }

  bool is_external(const Simplex& t) const {
    return std::any_of(triangles_.begin(), triangles_.end(),
                       [&](const auto& x) { return x.second == FacetKind::external && has(t, x.first); }) ||
           std::any_of(edges_.begin(), edges_.end(),
                       [&](const auto& x) { return x.second == EdgeKind::external && has(t, x.first); });
  }

  /// T_vf: a grounded triangle; T_ee: two grounded edges without a common vertex.
  bool is_two_plane(const Simplex& t) const {
    for (const auto& [triangle, kind] : triangles_) {
      if (has(t, triangle)) return true;
    }
    for (const auto& [e, kind] : edges_) {
      for (const auto& [f, other_kind] : edges_) {
        if (has(t, e) && has(t, f) && common(e, f).empty()) return true;
      }
    }
    return false;
  }

  bool touches_ground(const Simplex& t, const Simplex& s) const {
    return std::any_of(triangles_.begin(), triangles_.end(), [&](const auto& x) {
      return x.second == FacetKind::internal && has(t, x.first) && has(x.first, s);
    });
  }

  /// Definition 9 for one tetrahedron of the shell of s.
  bool reaches_ground(const Solid& r, const Simplex& start, const Simplex& s) const {
    std::set<Simplex> seen{start};
    std::deque<Simplex> next{start};
    for (; !next.empty(); next.pop_front()) {
      if (touches_ground(next.front(), s)) return true;
      for (const Simplex& t : r) {
        if (has(t, s) && common(t, next.front()).size() == 3 && seen.insert(t).second) next.push_back(t);
      }
    }
    return false;
  }

  bool is_solid_at(const Solid& r, const Simplex& t) const {
    for (const std::uint32_t v : t) {
      if (!reaches_ground(r, t, {v})) return false;
    }
    for (const auto& [edge, kind] : edges_) {
      if (has(t, edge) && !reaches_ground(r, t, edge)) return false;
    }
    return true;
  }

  Solid largest_solid(Solid r) const {
    for (bool changed = true; changed;) {
      changed = false;
      for (auto t = r.begin(); t != r.end();) {
        const bool good = is_solid_at(r, *t);
        changed |= !good;
        t = good ? std::next(t) : r.erase(t);
      }
    }
    return r;
  }

  static std::vector<Simplex> glued_facets(const Solid& r, const Simplex& t) {
    std::vector<Simplex> facets;
    for (const Simplex& other : r) {
      if (other != t && common(t, other).size() == 3) facets.push_back(common(t, other));
    }
    return facets;
  }

  bool may_join(const Solid& r, const Simplex& t, bool corrected) const {
    const auto facets = glued_facets(r, t);
    if (facets.size() != 2) return facets.size() > 2;
    if (!corrected) return true;
    Simplex far;  // the two vertices that are in one of the two facets only
    std::set_symmetric_difference(facets[0].begin(), facets[0].end(), facets[1].begin(), facets[1].end(),
                                  std::inserter(far, far.end()));
    const bool in_solid = std::any_of(r.begin(), r.end(), [&](const Simplex& x) { return has(x, far); });
    return !in_solid && edges_.count(far) == 0;
  }

  Solid step3(const Solid& r1, const Solid& two_plane, bool corrected) const {
    Solid r = largest_solid(two_plane);
    std::deque<Simplex> list;
    const auto list_all = [&](auto wanted) {  // std::set is in the canonical order
      for (const Simplex& t : r1) {
        const bool listed = std::find(list.begin(), list.end(), t) != list.end();
        if (!listed && two_plane.count(t) == 0 && r.count(t) == 0 && wanted(t) &&
            glued_facets(r, t).size() >= 2) {
          list.push_back(t);
        }
      }
    };
    list_all([](const Simplex&) { return true; });
    while (!list.empty()) {
      const Simplex t = list.front();
      list.pop_front();
      if (!may_join(r, t, corrected)) continue;
      r.insert(t);
      list_all([&](const Simplex& s) { return common(s, t).size() == 3; });
    }
    return r;
  }

  Solid r0_;
  std::map<Simplex, FacetKind> triangles_;
  std::map<Simplex, EdgeKind> edges_;
};

}  // namespace crossloft::test
