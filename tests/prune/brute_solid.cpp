#include "brute_solid.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace crossloft::test {

Simplex sorted(Simplex s) {
  std::sort(s.begin(), s.end());
  return s;
}

bool has(const Simplex& s, const Simplex& face) {
  return std::includes(s.begin(), s.end(), face.begin(), face.end());
}

Simplex common(const Simplex& s, const Simplex& t) {
  Simplex both;
  std::set_intersection(s.begin(), s.end(), t.begin(), t.end(), std::back_inserter(both));
  return both;
}

namespace {

std::vector<Simplex> faces_of(const Simplex& s, std::size_t size) {
  std::vector<Simplex> faces;
  for (unsigned bits = 0; bits < 1U << s.size(); ++bits) {
    Simplex face;
    for (unsigned i = 0; i < s.size(); ++i)
      if ((bits >> i & 1U) != 0) face.push_back(s[i]);
    if (face.size() == size) faces.push_back(face);
  }
  return faces;
}

}  // namespace

Groups::Groups(std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) group_.push_back(i);
}

void Groups::put_together(std::size_t a, std::size_t b) {
  const std::size_t low = std::min(group_[a], group_[b]), high = std::max(group_[a], group_[b]);
  std::replace(group_.begin(), group_.end(), high, low);
}

std::size_t Groups::count() const { return std::set<std::size_t>(group_.begin(), group_.end()).size(); }

BruteSolid::BruteSolid(const CellComplex& cell) : tets_(cell.mesh.size()) {
  std::map<Simplex, int> uses;
  std::map<Simplex, FacetKind> kinds;
  for (std::uint32_t t = 0; t < tets_; ++t) {
    const auto& v = cell.mesh.vertices[t];
    pieces_.emplace_back(v.begin(), v.end());
    std::sort(pieces_.back().begin(), pieces_.back().end());
    for (unsigned i = 0; i < 4; ++i) {
      Simplex f;
      for (const std::uint8_t slot : kFacetSlots[i]) f.push_back(v[slot]);
      std::sort(f.begin(), f.end());
      ++uses[f];
      kinds[f] = cell.facets[t][i];
    }
  }
  is_ground_.assign(tets_, 0);
  for (const auto& [triangle, count] : uses) {
    if (count != 1) continue;
    pieces_.push_back(triangle);
    is_ground_.push_back(kinds[triangle] == FacetKind::internal);
  }
  for (std::size_t a = 0; a < pieces_.size(); ++a) {
    for (std::size_t size = 1; size <= 3; ++size)
      for (const Simplex& face : faces_of(pieces_[a], size)) faces_[size - 1][face].push_back(a);
    for (std::size_t b = 0; b < a; ++b) {
      const Simplex both = common(pieces_[a], pieces_[b]);
      if (both.size() == 3 || (both.size() == 2 && b >= tets_)) touches_.push_back({a, b, both});
    }
  }
}

bool BruteSolid::is_solid(const Flags& kept, std::size_t piece) const {
  return piece < tets_ ? kept[piece] != 0 : is_ground_[piece] != 0;
}

std::vector<std::size_t> BruteSolid::ground() const {
  std::vector<std::size_t> list;
  for (std::size_t p = tets_; p < pieces_.size(); ++p)
    if (is_ground_[p] != 0) list.push_back(p);
  return list;
}

std::size_t BruteSolid::across(std::uint32_t t, const Simplex& triangle) const {
  const auto& both = faces_[2].at(triangle);
  return both[0] == t ? both[1] : both[0];
}

Groups BruteSolid::star(const Flags& kept, const Simplex& simplex) const {
  Groups groups(pieces_.size());
  for (const Touch& x : touches_)
    if (has(x.common, simplex) && is_solid(kept, x.a) && is_solid(kept, x.b)) groups.put_together(x.a, x.b);
  return groups;
}

Groups BruteSolid::bodies(const Flags& kept) const { return star(kept, {}); }

/// Pieces outside hang together at facets and at edges.
Groups BruteSolid::outsides(const Flags& kept) const {
  Groups groups(pieces_.size());
  for (const auto& [edge, pieces] : faces_[1]) {
    std::vector<std::size_t> outside;
    for (const std::size_t p : pieces)
      if (!is_solid(kept, p)) outside.push_back(p);
    for (const std::size_t p : outside) groups.put_together(p, outside[0]);
  }
  return groups;
}

std::vector<BruteSolid::Wall> BruteSolid::walls(const Flags& kept) const {
  std::vector<Wall> list;
  for (const auto& [triangle, pieces] : faces_[2]) {
    if (is_solid(kept, pieces[0]) == is_solid(kept, pieces[1])) continue;
    list.push_back({triangle, is_solid(kept, pieces[0]) ? pieces[0] : pieces[1]});
  }
  return list;
}

std::int64_t BruteSolid::euler_of_solid(const Flags& kept) const {
  std::int64_t euler = 0;
  for (std::size_t t = 0; t < tets_; ++t) euler -= kept[t] != 0 ? 1 : 0;
  for (const auto& [triangle, pieces] : faces_[2])
    euler +=
        std::any_of(pieces.begin(), pieces.end(), [&](std::size_t p) { return is_solid(kept, p); }) ? 1 : 0;
  for (const std::size_t size : {1, 2})
    for (const auto& [simplex, pieces] : faces_[size - 1]) {
      const Groups groups = star(kept, simplex);
      std::set<std::size_t> parts;
      for (const std::size_t p : pieces)
        if (is_solid(kept, p)) parts.insert(groups.of(p));
      euler += size == 1 ? static_cast<std::int64_t>(parts.size()) : -static_cast<std::int64_t>(parts.size());
    }
  return euler;
}

/// Two walls are paired at an edge iff they are the ends of one wedge of the solid; umbrellas are walls at a
/// vertex that hang together by pairs with it.
void BruteSolid::count_surface(const Flags& kept, Counts& counts) const {
  const std::vector<Wall> s = walls(kept);
  struct Pair {
    std::size_t a, b;
    Simplex edge;
  };
  std::vector<Pair> pairs, ends;  // an end has one wall, twice
  std::map<Simplex, std::vector<std::size_t>> at;
  for (std::size_t w = 0; w < s.size(); ++w)
    for (const Simplex& edge : faces_of(s[w].triangle, 2)) at[edge].push_back(w);
  for (const auto& [edge, here] : at) {
    const Groups wedges = star(kept, edge);
    std::map<std::size_t, std::vector<std::size_t>> of_wedge;
    for (const std::size_t w : here) of_wedge[wedges.of(s[w].solid)].push_back(w);
    for (const auto& [wedge, w] : of_wedge) {
      counts.every_part_is_a_surface &= w.size() <= 2;
      (w.size() == 2 ? pairs : ends).push_back({w.front(), w.back(), edge});
    }
  }
  Groups parts(s.size()), curves(ends.size());
  for (const Pair& p : pairs) parts.put_together(p.a, p.b);
  std::map<std::size_t, std::int64_t> euler, boundary;  // by part
  for (std::size_t w = 0; w < s.size(); ++w) ++euler[parts.of(w)];
  for (const Pair& p : pairs) --euler[parts.of(p.a)];
  for (const Pair& p : ends) --euler[parts.of(p.a)];
  for (const auto& [vertex, unused] : faces_[0]) {
    Groups umbrellas(s.size());
    for (const Pair& p : pairs)
      if (has(p.edge, vertex)) umbrellas.put_together(p.a, p.b);
    for (std::size_t w = 0; w < s.size(); ++w)
      if (has(s[w].triangle, vertex) && umbrellas.of(w) == w) ++euler[parts.of(w)];
    for (std::size_t e = 0; e < ends.size(); ++e)
      for (std::size_t f = 0; f < e; ++f)
        if (has(ends[e].edge, vertex) && has(ends[f].edge, vertex) &&
            umbrellas.of(ends[e].a) == umbrellas.of(ends[f].a))
          curves.put_together(e, f);
  }
  for (std::size_t e = 0; e < ends.size(); ++e)
    if (curves.of(e) == e) ++boundary[parts.of(ends[e].a)];
  for (const auto& [part, chi] : euler) {
    const std::int64_t twice = 2 - chi - boundary[part];
    counts.every_part_is_a_surface &= twice >= 0 && twice % 2 == 0;
    counts.genus += twice / 2;
    counts.euler += chi;
    counts.voids += boundary[part] == 0 ? 1U : 0U;
  }
  counts.curves = curves.count();
}

BruteSolid::Counts BruteSolid::count(const Flags& kept) const {
  Counts counts;
  const Groups in = bodies(kept), out = outsides(kept), sections = bodies(Flags(tets_, 0));
  for (std::size_t p = 0; p < pieces_.size(); ++p) {
    if (is_ground_[p] != 0) counts.sections += sections.of(p) == p ? 1U : 0U;
    if (is_solid(kept, p)) {
      counts.bodies += in.of(p) == p ? 1U : 0U;
    } else {
      counts.outsides += out.of(p) == p ? 1U : 0U;
    }
    if (is_ground_[p] != 0) {
      const auto& both = faces_[2].at(pieces_[p]);
      counts.bare += is_solid(kept, both[0] == p ? both[1] : both[0]) ? 0U : 1U;
    }
  }
  count_surface(kept, counts);
  return counts;
}

}  // namespace crossloft::test
