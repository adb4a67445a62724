#include "cell_topology.h"

#include <algorithm>
#include <array>

#include "../geom/disjoint_sets.h"
#include "links.h"

namespace crossloft {
namespace {

/// S as triangles with paired sides. Triangle = a facet of a kept tetrahedron, or of the bare one above a
/// ground triangle. Side 3 s + k of triangle s leads from its corner k to the next one, counter-clockwise
/// seen from outside of the solid, so that paired sides run against each other.
class CellSurface {
 public:
  CellSurface(const CellComplex& complex, const Ground& ground, const std::vector<std::uint8_t>& kept)
      : complex_(complex), ground_(ground), kept_(kept), first_(kept.size()) {
    collect();
    pair_sides();
  }

  void count(CellTopology& topology) {
    walk_umbrellas(topology);
    const auto edges = (3 * std::int64_t{size()} + ends_) / 2;
    topology.euler = std::int64_t{umbrellas_} - edges + size();
    const std::uint32_t components = count_components(topology);
    topology.genus = static_cast<std::uint32_t>(components - (topology.euler + topology.curves) / 2);
    topology.outsides = components + 1 - topology.bodies;
    topology.bare = size() - first_bare_;
    topology.bad_links = bad_links();
  }

 private:
  /// The facets of S that a tetrahedron has: the first of them, and a bit for each.
  struct FacetsOf {
    std::uint32_t first, facets;
  };
  static constexpr std::array<std::uint8_t, 8> kBits{0, 1, 1, 2, 1, 2, 2, 3};  ///< by mask: bits set

  /// Of a vertex, by rising certainty.
  enum class Link : std::uint8_t { good, doubtful, bad, counted };

  std::uint32_t size() const { return size_; }

  void collect() {
    facets_.resize(4);
    for (std::uint32_t t = 0; t < kept_.size(); ++t)
      if (kept_[t] != 0)
        add_facets(t, [&](std::uint8_t i) {
          const std::uint32_t n = complex_.mesh.neighbours[t][i];
          return n == kNone ? !ground_.is_ground(t, i) : kept_[n] == 0;
        });
    first_bare_ = size_;
    for (std::uint32_t g = 0; g < ground_.size(); ++g) {
      const std::uint32_t t = ground_.facet(g).tet;
      const bool is_first = g == 0 || ground_.facet(g - 1).tet != t;
      if (is_first && kept_[t] == 0) add_facets(t, [&](std::uint8_t i) { return ground_.is_ground(t, i); });
    }
    facets_.resize(size_);
  }

  /// Those of t that are on S. Without branches: which ones can't be predicted.
  template <class IsOnSurface>
  void add_facets(std::uint32_t t, IsOnSurface is_on_surface) {
    if (facets_.size() < size_ + std::size_t{4}) facets_.resize(2 * facets_.size());
    first_[t] = {size_, 0};
    for (std::uint8_t i = 0; i < 4; ++i) {
      const bool is_on = is_on_surface(i);
      facets_[size_] = {t, i};
      size_ += is_on ? 1U : 0U;
      first_[t].facets |= (is_on ? 1U : 0U) << i;
    }
  }

  /// Slot of corner k in the triangle's tetrahedron. From a bare one the outside is seen the other way round.
  unsigned slot(std::uint32_t s, unsigned k) const {
    return kFacetSlots[facets_[s].facet][s < first_bare_ ? k : 2 - k];
  }

  static std::uint32_t next(std::uint32_t side) { return side % 3 == 2 ? side - 2 : side + 1; }
  std::uint32_t to(std::uint32_t side) const { return from_[next(side)]; }

  /// Sides are paired through the solid, as in gluing.
  void pair_sides() {
    from_.resize(std::size_t{3} * size());
    for (std::uint32_t s = 0; s < size(); ++s)
      for (unsigned k = 0; k < 3; ++k) from_[3 * s + k] = complex_.mesh.vertices[facets_[s].tet][slot(s, k)];
    mate_.assign(from_.size(), kNone);
    for (std::uint32_t s = 0; s < size(); ++s)
      for (unsigned k = 0; k < 3; ++k) {
        const std::uint32_t side = 3 * s + k;
        if (mate_[side] != kNone) continue;
        const Facet end = across(s, slot(s, (k + 2) % 3));
        if (end.tet == kNone) {
          ++ends_;
          continue;
        }
        const std::uint32_t other = side_from(end, from_[3 * s + (k + 1) % 3]);
        mate_[side] = other;
        mate_[other] = side;
      }
  }

  /// From triangle s around its edge opposite to a slot: from within the solid, or from a bare one into the
  /// ground.
  Facet across(std::uint32_t s, unsigned opposite) const {
    const Facet& f = facets_[s];
    const bool bare = s >= first_bare_;
    return turn_through_solid(complex_, ground_, kept_,
                              bare ? Turn(f.tet, f.facet, opposite) : Turn(f.tet, opposite, f.facet));
  }

  /// The side of a facet of S that starts at vertex v.
  std::uint32_t side_from(Facet f, std::uint32_t v) const {
    const FacetsOf& of = first_[f.tet];
    const std::uint32_t s = of.first + kBits[of.facets & ((1U << f.facet) - 1)];
    return 3 * s + (from_[3 * s + 1] == v ? 1U : 0U) + (from_[3 * s + 2] == v ? 2U : 0U);
  }

  /// Open umbrellas along the boundary curves, then closed ones.
  void walk_umbrellas(CellTopology& topology) {
    seen_.assign(mate_.size(), 0);
    last_umbrella_at_.assign(complex_.vertex_count, 0);
    last_spoke_at_.assign(complex_.vertex_count, 0);
    links_.assign(complex_.vertex_count, Link::good);
    for (std::uint32_t side = 0; side < mate_.size(); ++side) {
      if (mate_[side] != kNone || seen_[side] != 0) continue;
      ++topology.curves;
      std::uint32_t end = side;
      do end = walk_open(end);
      while (end != side);
    }
    for (std::uint32_t side = 0; side < mate_.size(); ++side)
      if (seen_[side] == 0) walk_closed(side);
  }

  /// Through the umbrella at the end of an unpaired side, to the unpaired side that leaves it.
  std::uint32_t walk_open(std::uint32_t end) {
    const std::uint32_t v = to(end);
    start_umbrella(v, Link::doubtful);
    seen_[end] = 1;
    spoke(v, from_[end]);
    for (end = next(end); mate_[end] != kNone; end = next(mate_[end])) {
      seen_[end] = 1;
      spoke(v, to(end));
    }
    spoke(v, to(end));
    return end;
  }

  void walk_closed(std::uint32_t side) {
    const std::uint32_t v = from_[side];
    start_umbrella(v, Link::bad);
    for (; seen_[side] == 0; side = next(mate_[side])) {
      seen_[side] = 1;
      spoke(v, to(side));
    }
  }

  /// The extended link of a vertex is a part of a sphere, bounded by circles: one for each closed umbrella,
  /// and one for the open ones and what of the sections is between them, if that is one fan. So it is good
  /// where there is one umbrella that has every edge once. With several open ones it takes a close look.
  void start_umbrella(std::uint32_t v, Link several) {
    ++umbrellas_;
    if (last_umbrella_at_[v] != 0) worsen(v, several);
    last_umbrella_at_[v] = umbrellas_;
  }

  void spoke(std::uint32_t v, std::uint32_t to) {
    if (last_spoke_at_[to] == umbrellas_) worsen(v, Link::bad);
    last_spoke_at_[to] = umbrellas_;
  }

  void worsen(std::uint32_t v, Link link) {
    links_[v] = std::max(links_[v], link);
    all_good_ = false;
  }

  /// Where no tetrahedron is kept at a bad link, the section is bare, and that does not count.
  std::uint32_t bad_links() {
    if (all_good_) return 0;
    std::uint32_t bad = 0;
    for (std::uint32_t side = 0; side < 3 * first_bare_; ++side) {
      Link& link = links_[from_[side]];
      if (link != Link::bad) continue;
      ++bad;
      link = Link::counted;
    }
    std::vector<std::uint8_t> doubtful;
    for (const Link link : links_) doubtful.push_back(link == Link::doubtful ? 1 : 0);
    if (std::count(doubtful.begin(), doubtful.end(), 1) != 0)
      bad += census_links(complex_, kept_, doubtful).bad_links();
    return bad;
  }

  /// Counts those without boundary as voids.
  std::uint32_t count_components(CellTopology& topology) {
    std::uint32_t components = 0;
    std::vector<std::uint8_t> found(size(), 0);
    std::vector<std::uint32_t> stack;
    for (std::uint32_t start = 0; start < size(); ++start) {
      if (found[start] != 0) continue;
      ++components;
      bool has_boundary = false;
      found[start] = 1;
      for (stack.assign(1, start); !stack.empty();) {
        const std::uint32_t s = stack.back();
        stack.pop_back();
        for (unsigned k = 0; k < 3; ++k) {
          const std::uint32_t mate = mate_[3 * s + k];
          has_boundary |= mate == kNone;
          if (mate == kNone || found[mate / 3] != 0) continue;
          found[mate / 3] = 1;
          stack.push_back(mate / 3);
        }
      }
      topology.voids += has_boundary ? 0U : 1U;
    }
    return components;
  }

  const CellComplex& complex_;
  const Ground& ground_;
  const std::vector<std::uint8_t>& kept_;
  std::vector<FacetsOf> first_;  ///< by tetrahedron, if it has facets of S
  std::vector<Facet> facets_;    ///< of kept tetrahedra, then of bare ones
  std::uint32_t size_ = 0;       ///< how many
  std::uint32_t first_bare_ = 0;
  std::vector<std::uint32_t> from_;  ///< by side: the vertex where it starts
  std::vector<std::uint32_t> mate_;  ///< by side, kNone where S ends
  std::uint32_t ends_ = 0;           ///< sides without mate
  std::uint32_t umbrellas_ = 0;      ///< so far; they count from 1
  std::vector<std::uint8_t> seen_;   ///< by side: in the umbrella where it starts, or ends if it has no mate
  std::vector<std::uint32_t> last_umbrella_at_, last_spoke_at_;  ///< by vertex
  std::vector<Link> links_;                                      ///< by vertex
  bool all_good_ = true;
};

/// Numbers of the connected parts of the kept tetrahedra, across facets; kNone elsewhere.
std::uint32_t label_parts(const TetMesh& mesh, const std::vector<std::uint8_t>& kept,
                          std::vector<std::uint32_t>& part) {
  std::uint32_t parts = 0;
  part.assign(kept.size(), kNone);
  std::vector<std::uint32_t> stack;
  for (std::uint32_t start = 0; start < kept.size(); ++start) {
    if (kept[start] == 0 || part[start] != kNone) continue;
    part[start] = parts;
    for (stack.assign(1, start); !stack.empty();) {
      const std::uint32_t t = stack.back();
      stack.pop_back();
      for (const std::uint32_t n : mesh.neighbours[t]) {
        if (n == kNone || kept[n] == 0 || part[n] != kNone) continue;
        part[n] = parts;
        stack.push_back(n);
      }
    }
    ++parts;
  }
  return parts;
}

}  // namespace

CellBodies find_bodies(const CellComplex& complex, const Ground& ground,
                       const std::vector<std::uint8_t>& kept) {
  std::vector<std::uint32_t> part;
  const std::uint32_t parts = label_parts(complex.mesh, kept, part);
  DisjointSets sets(ground.size() + std::size_t{parts});
  for (std::uint32_t g = 0; g < ground.size(); ++g) {
    sets.join(g, ground.part(g));
    const std::uint32_t above = part[ground.facet(g).tet];
    if (above != kNone) sets.join(ground.size() + above, g);
  }
  CellBodies bodies{sets.count(), std::vector<std::uint32_t>(ground.size())};
  for (std::uint32_t g = 0; g < ground.size(); ++g) bodies.of_ground[g] = sets.find(g);
  return bodies;
}

CellTopology count_topology(const CellComplex& complex, const Ground& ground,
                            const std::vector<std::uint8_t>& kept) {
  return count_topology(complex, ground, kept, find_bodies(complex, ground, kept));
}

CellTopology count_topology(const CellComplex& complex, const Ground& ground,
                            const std::vector<std::uint8_t>& kept, const CellBodies& bodies) {
  CellTopology topology;
  topology.sections = ground.part_count();
  topology.bodies = bodies.count;
  CellSurface(complex, ground, kept).count(topology);
  return topology;
}

}  // namespace crossloft
