#include "contact.h"

#include <algorithm>
#include <bit>

namespace crossloft {

int Contact::different_bodies() const {
  int count = 0;
  for (unsigned i = 0; i < 4; ++i) {
    bool is_new = (facets >> i & 1U) != 0;
    for (unsigned j = 0; j < i; ++j) is_new &= (facets >> j & 1U) == 0 || bodies[j] != bodies[i];
    count += is_new ? 1 : 0;
  }
  return count;
}

GrowingSolid::GrowingSolid(const CellComplex& complex, const Ground& ground)
    : complex_(complex),
      ground_(ground),
      kept_(complex.mesh.size(), 0),
      corners_(std::size_t{3} * ground.size() + std::size_t{4} * complex.mesh.size()),
      bodies_(std::size_t{ground.size()} + complex.mesh.size()),
      first_tet_corner_(3 * ground.size()) {
  for (std::uint32_t g = 0; g < ground.size(); ++g) {
    bodies_.join(g, ground.part(g));
    const Facet& f = ground.facet(g);
    for (unsigned k = 0; k < 3; ++k) {
      const std::uint32_t n = ground.neighbour(g, k);
      if (n == kNone) continue;
      for (const unsigned end : {k, (k + 1) % 3}) {
        const std::uint32_t v = complex.mesh.vertices[f.tet][kFacetSlots[f.facet][end]];
        corners_.join(3 * g + end, ground_corner(n, v));
      }
    }
  }
}

std::uint32_t GrowingSolid::ground_corner(std::uint32_t g, std::uint32_t v) const {
  const Facet& f = ground_.facet(g);
  const auto& vertices = complex_.mesh.vertices[f.tet];
  const auto& slots = kFacetSlots[f.facet];
  return 3 * g + (vertices[slots[0]] == v ? 0U : vertices[slots[1]] == v ? 1U : 2U);
}

/// The corner at vertex v of what is on the other side of a facet of the contact.
std::uint32_t GrowingSolid::across(std::uint32_t t, unsigned i, std::uint32_t v) const {
  if (const std::uint32_t g = ground_.at(t, i); g != kNone) return ground_corner(g, v);
  const std::uint32_t n = complex_.mesh.neighbours[t][i];
  return first_tet_corner_ + 4 * n + slot_of(complex_.mesh.vertices[n], v);
}

std::uint32_t GrowingSolid::body_across(std::uint32_t t, unsigned i) {
  const std::uint32_t g = ground_.at(t, i);
  return find(bodies_, g != kNone ? g : ground_.size() + complex_.mesh.neighbours[t][i]);
}

unsigned GrowingSolid::glued_facets(std::uint32_t t) const {
  unsigned bits = 0;
  for (unsigned i = 0; i < 4; ++i) {
    const std::uint32_t n = complex_.mesh.neighbours[t][i];
    if (n != kNone ? kept_[n] != 0 : ground_.is_ground(t, i)) bits |= 1U << i;
  }
  return bits;
}

/// Where the solid around the edge between facets i and j of t ends, starting across i.
Facet GrowingSolid::end_of_turn(std::uint32_t t, unsigned i, unsigned j) const {
  return turn_through_solid(complex_, ground_, kept_, Turn(t, i, j));
}

std::vector<std::uint32_t> GrowingSolid::outside_around(std::uint32_t t, const Contact& contact) const {
  std::vector<std::uint32_t> around;
  for (unsigned i = 0; i < 4; ++i) {
    const std::uint32_t n = complex_.mesh.neighbours[t][i];
    if ((contact.facets >> i & 1U) == 0) {
      if (n != kNone) around.push_back(n);
      continue;
    }
    for (unsigned j = 0; j < 4; ++j) {
      if (j == i || (contact.facets >> j & 1U) == 0 || closes_edge(t, i, j)) continue;
      const Facet end = end_of_turn(t, i, j);
      if (end.tet == kNone) continue;
      const std::uint32_t beyond =
          kept_[end.tet] == 0 ? end.tet : complex_.mesh.neighbours[end.tet][end.facet];
      if (beyond != kNone) around.push_back(beyond);
    }
  }
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  return around;
}

/// Whether the edge between two facets of the contact becomes an inner one with t: from facet i around it
/// through the solid one comes to facet j.
bool GrowingSolid::closes_edge(std::uint32_t t, unsigned i, unsigned j) const {
  const Facet end = end_of_turn(t, i, j);
  if (end.tet == kNone) return false;
  if (end.tet == t) return end.facet == j;
  return complex_.mesh.neighbours[end.tet][end.facet] == t && complex_.mesh.neighbours[t][j] == end.tet;
}

Contact GrowingSolid::contact(std::uint32_t t) {
  Contact contact;
  contact.facets = glued_facets(t);
  if (std::has_single_bit(contact.facets)) {  // a disk, whatever is around
    const auto i = static_cast<unsigned>(std::countr_zero(contact.facets));
    contact.bodies[i] = body_across(t, i);
    contact.parts = 1;
    return contact;
  }
  std::array<unsigned, 4> part{0, 1, 2, 3};  // of each facet of the contact: its smallest one
  const auto unite = [&](unsigned i, unsigned j) {
    const auto [low, high] = std::minmax({part[i], part[j]});
    for (unsigned& p : part)
      if (p == high) p = low;
  };
  int change = 1;  // of the Euler characteristic
  for (unsigned i = 0; i < 4; ++i) {
    if ((contact.facets >> i & 1U) == 0) continue;
    change += 2;
    for (unsigned j = 0; j < i; ++j)
      if ((contact.facets >> j & 1U) != 0 && closes_edge(t, i, j)) --change;
    contact.bodies[i] = body_across(t, i);
  }
  for (unsigned slot = 0; slot < 4; ++slot) {
    std::array<std::uint32_t, 4> root{};
    for (unsigned i = 0; i < 4; ++i) {
      if (i == slot || (contact.facets >> i & 1U) == 0) continue;
      root[i] = find(corners_, across(t, i, complex_.mesh.vertices[t][slot]));
      bool is_new = true;
      for (unsigned j = 0; j < i; ++j) {
        if (j == slot || (contact.facets >> j & 1U) == 0 || root[j] != root[i]) continue;
        is_new = false;
        unite(i, j);
      }
      if (is_new) --change;
    }
  }
  for (unsigned i = 0; i < 4; ++i) contact.parts += (contact.facets >> i & 1U) != 0 && part[i] == i ? 1 : 0;
  contact.loops = change - 1 + contact.parts;
  return contact;
}

void GrowingSolid::join(DisjointSets& sets, std::vector<std::uint32_t>& joined, std::uint32_t a,
                        std::uint32_t b) {
  a = find(sets, a);
  b = find(sets, b);
  sets.join(a, b);
  if (in_trial_ && a != b) joined.push_back(std::max(a, b));
}

void GrowingSolid::add(std::uint32_t t) {
  const unsigned facets = glued_facets(t);
  for (unsigned i = 0; i < 4; ++i) {
    if ((facets >> i & 1U) == 0) continue;
    join(bodies_, joined_bodies_, body_across(t, i), ground_.size() + t);
    for (const std::uint8_t slot : kFacetSlots[i])
      join(corners_, joined_corners_, first_tet_corner_ + 4 * t + slot,
           across(t, i, complex_.mesh.vertices[t][slot]));
  }
  kept_[t] = 1;
  if (in_trial_) tried_.push_back(t);
}

void GrowingSolid::end_trial(bool keep) {
  if (!keep) {
    for (const std::uint32_t t : tried_) kept_[t] = 0;
    for (; !joined_corners_.empty(); joined_corners_.pop_back()) corners_.part(joined_corners_.back());
    for (; !joined_bodies_.empty(); joined_bodies_.pop_back()) bodies_.part(joined_bodies_.back());
  }
  tried_.clear();
  joined_corners_.clear();
  joined_bodies_.clear();
  in_trial_ = false;
}

}  // namespace crossloft
