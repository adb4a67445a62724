#include "cracks.h"

#include <algorithm>
#include <span>

#include "cell_topology.h"
#include "disjoint_sets.h"
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
  return now.genus <= before.genus && now.voids <= before.voids && now.bodies == before.bodies &&
         now.outsides <= before.outsides;
}

/// Sets of cracks are tried as a whole, then by halves where that is not good: few are bad.
class Refill {
 public:
  Refill(const CellComplex& complex, const Ground& ground, std::vector<std::uint8_t>& kept)
      : complex_(complex), ground_(ground), kept_(kept), topology_(count_topology(complex, ground, kept)) {}

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

 private:
  static constexpr int kMostTrials = 40;  ///< each costs a count of the cell

  bool fill(std::span<const Crack> set) {
    ++trials_;
    mark(set, 1);
    const CellTopology now = count_topology(complex_, ground_, kept_);
    const bool good = is_as_good(now, topology_);
    if (good) {
      topology_ = now;
    } else {
      mark(set, 0);
    }
    return good;
  }

  void mark(std::span<const Crack> set, std::uint8_t flag) {
    for (const Crack& crack : set)
      for (const std::uint32_t t : crack) kept_[t] = flag;
  }

  const CellComplex& complex_;
  const Ground& ground_;
  std::vector<std::uint8_t>& kept_;
  CellTopology topology_;
  int trials_ = 0;
};

}  // namespace

void refill_cracks(const CellComplex& complex, const Ground& ground, const std::vector<std::uint8_t>& allowed,
                   std::vector<std::uint8_t>& kept) {
  Refill refill(complex, ground, kept);
  for (const bool wide : {true, false}) refill.run(find_cracks(complex, allowed, kept, wide));
}

}  // namespace crossloft
