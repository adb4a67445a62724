#include "open_loops.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "../geom/disjoint_sets.h"
#include "star.h"

namespace crossloft {

OpenLoops::OpenLoops(const CellComplex& complex, const Ground& ground, GrowingSolid solid,
                     const std::vector<std::uint8_t>& wider)
    : complex_(complex), ground_(ground), solid_(std::move(solid)), wider_(wider) {
  fill();
  number_facets();
  std::vector<std::vector<std::uint32_t>> stars(complex.vertex_count);
  for (std::uint32_t t = 0; t < complex.mesh.size(); ++t)
    if (is_beside(t))
      for (const std::uint32_t v : complex.mesh.vertices[t]) stars[v].push_back(t);
  for (std::uint32_t v = 0; v < complex.vertex_count; ++v) add_ways(steps_at(v, stars[v]));
  solve();
}

/// With K + t in the place of K the classes are taken modulo H1(t, contact), which is 0 if the contact has
/// one part. If its parts are in different bodies, the class of a way through t from one to the other goes:
/// it joins bodies, so it is none of those asked for. The order tells what is left, not which classes are 0.
void OpenLoops::fill() {
  std::vector<std::uint32_t> stack;
  const auto grow_from = [&](std::uint32_t start) {
    stack.push_back(start);
    while (!stack.empty()) {
      const std::uint32_t t = stack.back();
      stack.pop_back();
      if (!is_beside(t)) continue;
      const Contact contact = solid_.contact(t);
      if (contact.facets == 0 || contact.parts != contact.different_bodies()) continue;
      solid_.add(t);
      for (const std::uint32_t n : complex_.mesh.neighbours[t])
        if (n != kNone) stack.push_back(n);
    }
    return solid_.has(start);
  };
  // What comes to an edge or a vertex alone may change a contact as well: until nothing does.
  for (bool some = true; some;) {
    some = false;
    for (std::uint32_t t = 0; t < complex_.mesh.size(); ++t) some |= is_beside(t) && grow_from(t);
  }
}

bool OpenLoops::leads_to_solid(std::uint32_t t, unsigned i) const {
  const std::uint32_t n = complex_.mesh.neighbours[t][i];
  return n == kNone ? ground_.is_ground(t, i) : solid_.has(n);
}

void OpenLoops::add(Row& row, const Row& other) {
  Row sum;
  std::set_symmetric_difference(row.begin(), row.end(), other.begin(), other.end(), std::back_inserter(sum));
  row = std::move(sum);
}

/// A cocycle may be changed by what comes together at any one tetrahedron: so the value is 0 on a forest over
/// K, as one, and the tetrahedra beside it.
void OpenLoops::number_facets() {
  const std::uint32_t n = complex_.mesh.size();
  unknown_.assign(std::size_t{4} * n, kNone);
  DisjointSets sets(std::size_t{n} + 1);
  std::uint32_t count = 0;
  for (std::uint32_t t = 0; t < n; ++t) {
    if (!is_beside(t)) continue;
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t next = complex_.mesh.neighbours[t][i];
      const bool ends = leads_to_solid(t, i);
      if (!ends && (next == kNone || wider_[next] == 0)) continue;
      if (!ends && next < t) {
        unknown_[4 * t + i] = unknown_[4 * next + facet_towards(complex_.mesh, next, t)];
        continue;
      }
      const std::uint32_t other = ends ? n : next;
      if (sets.find(t) == sets.find(other)) unknown_[4 * t + i] = count++;
      sets.join(t, other);
    }
  }
  equations_.resize(count);
  values_.resize(count);
}

/// `star`: the tetrahedra beside K at v, ascending. What K connects at v is one place.
std::vector<OpenLoops::Step> OpenLoops::steps_at(std::uint32_t v, std::span<const std::uint32_t> star) {
  std::vector<std::uint32_t> parts;
  std::vector<Step> steps;
  const auto count = static_cast<std::uint32_t>(star.size());
  for (std::uint32_t from = 0; from < count; ++from) {
    const std::uint32_t t = star[from];
    for (unsigned i = 0; i < 4; ++i) {
      if (complex_.mesh.vertices[t][i] == v) continue;
      const std::uint32_t next = complex_.mesh.neighbours[t][i];
      if (leads_to_solid(t, i)) {
        const std::uint32_t part = solid_.part_across(t, i, v);
        const auto found = std::find(parts.begin(), parts.end(), part);
        steps.push_back(
            {from, count + static_cast<std::uint32_t>(found - parts.begin()), unknown_[4 * t + i]});
        if (found == parts.end()) parts.push_back(part);
      } else if (next != kNone && next > t && wider_[next] != 0) {
        const auto at = std::lower_bound(star.begin(), star.end(), next);
        steps.push_back({from, static_cast<std::uint32_t>(at - star.begin()), unknown_[4 * t + i]});
      }
    }
  }
  return steps;
}

/// Breadth first from place to place; each step that comes to a place again closes a way.
void OpenLoops::add_ways(const std::vector<Step>& steps) {
  std::size_t places = 0;
  for (const Step& s : steps) places = std::max<std::size_t>(places, std::max(s.from, s.to) + std::size_t{1});
  std::vector<std::vector<std::uint32_t>> at(places);
  for (std::uint32_t s = 0; s < steps.size(); ++s) {
    at[steps[s].from].push_back(s);
    at[steps[s].to].push_back(s);
  }
  std::vector<Row> way(places);  // from where the search began
  std::vector<std::uint8_t> seen(places, 0), done(steps.size(), 0);
  for (std::uint32_t start = 0; start < places; ++start) {
    std::vector<std::uint32_t> queue;
    if (seen[start] == 0) queue.push_back(start);
    seen[start] = 1;
    for (std::size_t head = 0; head < queue.size(); ++head)
      for (const std::uint32_t s : at[queue[head]]) {
        if (std::exchange(done[s], std::uint8_t{1}) != 0) continue;
        const std::uint32_t to = steps[s].from ^ steps[s].to ^ queue[head];
        Row row = way[queue[head]];
        if (steps[s].unknown != kNone) add(row, {steps[s].unknown});
        if (std::exchange(seen[to], std::uint8_t{1}) == 0) {
          way[to] = std::move(row);
          queue.push_back(to);
        } else {
          add(row, way[to]);
          reduce(std::move(row));
        }
      }
  }
}

void OpenLoops::reduce(Row row) {
  while (!row.empty() && !equations_[row.back()].empty()) add(row, equations_[row.back()]);
  if (!row.empty()) equations_[row.back()] = std::move(row);
}

void OpenLoops::solve() {
  for (std::uint32_t u = 0; u < values_.size(); ++u) {
    const Row& row = equations_[u];
    if (row.empty()) values_[u] = {u};
    for (std::size_t k = 0; k + 1 < row.size(); ++k) add(values_[u], values_[row[k]]);
  }
}

bool OpenLoops::is_closed_by(std::uint32_t t, const Contact& contact) const {
  if (solid_.has(t)) return false;
  const auto value = [&](unsigned i) {
    const std::uint32_t u = unknown_[4 * t + i];
    return u == kNone ? Row{} : values_[u];
  };
  for (unsigned i = 0; i < 4; ++i)
    for (unsigned j = 0; j < i; ++j)
      if ((contact.facets >> i & 1U) != 0 && (contact.facets >> j & 1U) != 0 &&
          contact.bodies[i] == contact.bodies[j] && value(i) != value(j))
        return true;
  return false;
}

}  // namespace crossloft
