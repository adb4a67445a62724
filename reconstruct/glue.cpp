#include "glue.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <numeric>
#include <utility>

#include "../delaunay/tet_mesh.h"
#include "../geom/disjoint_sets.h"
#include "../geom/parallel.h"
#include "../prune/star.h"

namespace crossloft {
namespace {

using Triple = std::array<std::uint32_t, 3>;
using Tets = std::span<const std::array<std::uint32_t, 4>>;

/// A facet, kept in the bucket of its smallest vertex; its number is 4 * tetrahedron + slot.
struct Facet {
  std::uint32_t middle, largest;  ///< its other vertices in increasing order
  std::uint32_t number;
  bool even;  ///< outward orientation is smallest, middle, largest

  bool same_vertices(const Facet& other) const { return middle == other.middle && largest == other.largest; }
  friend auto operator<=>(const Facet&, const Facet&) = default;
};

Triple outward(Tets tets, std::uint32_t facet) {
  const auto& slots = kFacetSlots[facet % 4];
  const auto& tet = tets[facet / 4];
  return {tet[slots[0]], tet[slots[1]], tet[slots[2]]};
}

/// The same orientation with the smallest vertex first.
Triple rotated(Triple t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

Error failure(ErrorCode code, const char* message) {
  Error error;
  error.code = code;
  error.message = message;
  return error;
}

/// Facets by their smallest vertex: those of v are [begin[v], begin[v + 1]).
struct FacetBuckets {
  std::vector<std::size_t> begin;
  std::vector<Facet> facets;
};

FacetBuckets fill_buckets(Tets tets, std::span<const std::uint32_t> facets) {
  std::uint32_t vertex_count = 0;
  for (const std::uint32_t f : facets)
    vertex_count = std::max(vertex_count, rotated(outward(tets, f))[0] + 1);
  FacetBuckets buckets;
  buckets.begin.assign(std::size_t{vertex_count} + 1, 0);
  for (const std::uint32_t f : facets) ++buckets.begin[rotated(outward(tets, f))[0] + std::size_t{1}];
  std::partial_sum(buckets.begin.begin(), buckets.begin.end(), buckets.begin.begin());
  buckets.facets.resize(facets.size());
  std::vector<std::size_t> next(buckets.begin);
  for (const std::uint32_t f : facets) {
    const Triple t = rotated(outward(tets, f));
    buckets.facets[next[t[0]]++] = {std::min(t[1], t[2]), std::max(t[1], t[2]), f, t[1] < t[2]};
  }
  return buckets;
}

/// Tetrahedra that are worked on together, one block a task: near each other, as they come cell by cell.
constexpr std::uint32_t kBlock = 1U << 13;

/// Calls work(first, last) for each block of tetrahedra.
template <class Work>
bool for_blocks(std::size_t tets, const Context& context, Work&& work) {
  return parallel_for((tets + kBlock - 1) / kBlock, context, "gluing", [&](std::size_t b) {
    work(static_cast<std::uint32_t>(b * kBlock),
         static_cast<std::uint32_t>(std::min(tets, (b + 1) * kBlock)));
  });
}

/// partner[f] = the facet glued to facet f, kNone on the boundary.
///
/// Most facets have their partner in the same block: a small table of its facets, which stays in the cache,
/// finds those. What is left over is sorted.
class FacetMatcher {
 public:
  explicit FacetMatcher(Tets tets) : tets_(tets), partner_(4 * tets.size(), kNone) {}

  Result<std::vector<std::uint32_t>> run(const Context& context) {
    const auto work = [&](std::uint32_t first, std::uint32_t last) { match_block(first, last); };
    if (!for_blocks(tets_.size(), context, work)) return failure(ErrorCode::cancelled, "cancelled");
    match_rest();
    if (overlap_) return failure(ErrorCode::internal, "tetrahedra overlap: they can't be glued");
    return std::move(partner_);
  }

 private:
  static constexpr std::uint32_t kSlots = 8 * kBlock;  ///< of the table, half of them used at most

  void match(std::uint32_t p, std::uint32_t q, bool same_side) {
    if (same_side || partner_[p] != kNone) overlap_ = true;
    partner_[p] = q;
    partner_[q] = p;
  }

  void match_block(std::uint32_t first, std::uint32_t last) {
    std::vector<std::uint32_t> table(kSlots, kNone);  // facets by hash
    for (std::uint32_t f = 4 * first; f < 4 * last; ++f) {
      const Triple t = rotated(outward(tets_, f));
      std::uint32_t slot = slot_for(t);
      while (table[slot] != kNone && !same_vertices(table[slot], t)) slot = (slot + 1) % kSlots;
      if (table[slot] == kNone)
        table[slot] = f;
      else
        match(table[slot], f, rotated(outward(tets_, table[slot])) == t);
    }
  }

  static std::uint32_t slot_for(const Triple& t) {
    const std::uint64_t mixed =
        (std::uint64_t{t[0]} * 0x9E3779B97F4A7C15U) ^ (std::uint64_t{t[1]} + t[2]) * 0xC2B2AE3D27D4EB4FU;
    return static_cast<std::uint32_t>(mixed >> 40) % kSlots;
  }

  /// `t` with the smallest vertex first.
  bool same_vertices(std::uint32_t facet, const Triple& t) const {
    const Triple u = rotated(outward(tets_, facet));
    return u[0] == t[0] && std::minmax(u[1], u[2]) == std::minmax(t[1], t[2]);
  }

  void match_rest() {
    std::vector<std::uint32_t> rest;
    for (std::uint32_t f = 0; f < partner_.size(); ++f)
      if (partner_[f] == kNone) rest.push_back(f);
    FacetBuckets buckets = fill_buckets(tets_, rest);
    for (std::size_t v = 0; v + 1 < buckets.begin.size(); ++v) {
      const std::span bucket(buckets.facets.data() + buckets.begin[v],
                             buckets.begin[v + 1] - buckets.begin[v]);
      std::sort(bucket.begin(), bucket.end());
      for (std::size_t i = 0; i + 1 < bucket.size(); ++i)
        if (bucket[i].same_vertices(bucket[i + 1]))
          match(bucket[i].number, bucket[i + 1].number, bucket[i].even == bucket[i + 1].even);
    }
  }

  Tets tets_;
  std::vector<std::uint32_t> partner_;
  std::atomic<bool> overlap_ = false;
};

/// What `partner` says of a boundary facet, once there are triangles: its triangle, marked.
constexpr std::uint32_t kBoundaryMark = 1U << 31;
bool is_boundary(std::uint32_t partner) { return (partner & kBoundaryMark) != 0; }

/// The boundary's triangles with the smallest vertex first, sorted.
std::vector<Triple> collect_boundary(Tets tets, std::vector<std::uint32_t>& partner) {
  std::vector<std::pair<Triple, std::uint32_t>> found;
  for (std::uint32_t f = 0; f < partner.size(); ++f) {
    if (partner[f] == kNone) found.emplace_back(rotated(outward(tets, f)), f);
  }
  std::sort(found.begin(), found.end());
  std::vector<Triple> triangles;
  triangles.reserve(found.size());
  for (const auto& [triangle, facet] : found) {
    partner[facet] = kBoundaryMark | static_cast<std::uint32_t>(triangles.size());
    triangles.push_back(triangle);
  }
  return triangles;
}

/// The boundary triangle at the other end of the solid wedge at edge (a, b): from facet to facet around the
/// edge, through the tetrahedra between them.
std::uint32_t across_wedge(Tets tets, const std::vector<std::uint32_t>& partner, std::uint32_t facet,
                           std::uint32_t a, std::uint32_t b) {
  for (;;) {
    const auto& tet = tets[facet / 4];
    const unsigned corner = kEdgeCorner[slot_of(tet, a)][slot_of(tet, b)];
    const unsigned other = static_cast<unsigned>(kCornerFacets[corner]) & ~(1U << facet % 4);
    unsigned slot = 0;
    while ((other >> slot & 1U) == 0) ++slot;
    facet = facet / 4 * 4 + slot;
    if (is_boundary(partner[facet])) return partner[facet] & ~kBoundaryMark;
    facet = partner[facet];
  }
}

/// Side i of triangle t runs from its corner i to corner (i + 1) % 3; its number is 3 * t + i, as that of
/// corner i.
std::uint32_t next_corner(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

/// mate[s] = the side paired with side s. In the order of the tetrahedra: walking around edges in the order
/// of the triangles would jump from cell to cell.
std::vector<std::uint32_t> pair_sides(Tets tets, const std::vector<std::uint32_t>& partner,
                                      std::span<const Triple> triangles, const Context& context) {
  std::vector<std::uint32_t> mate(3 * triangles.size());
  const auto pair = [&](std::uint32_t facet, std::uint32_t side) {
    const Triple& triangle = triangles[side / 3];
    const std::uint32_t a = triangle[side % 3], b = triangle[(side + 1) % 3];
    const std::uint32_t other = across_wedge(tets, partner, facet, a, b);
    const Triple& met = triangles[other];
    mate[side] = 3 * other + static_cast<std::uint32_t>(std::find(met.begin(), met.end(), b) - met.begin());
  };
  for_blocks(tets.size(), context, [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t f = 4 * first; f < 4 * last; ++f)
      for (std::uint32_t i = 0; i < 3 && is_boundary(partner[f]); ++i)
        pair(f, 3 * (partner[f] & ~kBoundaryMark) + i);
  });
  return mate;
}

/// A side by the two ends that it joins, the smaller one first.
struct Side {
  std::uint32_t a, b, number;

  friend auto operator<=>(const Side&, const Side&) = default;
};

/// Cuts the boundary apart; see the header for the rules.
class Cutter {
 public:
  Cutter(const std::vector<Triple>& triangles, const std::vector<std::uint32_t>& mate)
      : triangles_(triangles), mate_(mate), midpoint_(mate.size(), kNone), copy_(mate.size()) {}

  GluedSurface run() {
    count_pinched_edges();
    make_copies();
    split_shared_edges();
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) emit(t);
    return std::move(surface_);
  }

 private:
  std::uint32_t input_vertex(std::uint32_t corner) const { return triangles_[corner / 3][corner % 3]; }
  bool leads(std::uint32_t side) const { return side < mate_[side]; }

  /// One entry for each pair of sides, sorted by the ends that `end(corner)` gives.
  template <class End>
  std::vector<Side> sorted_edges(End end) const {
    std::vector<Side> edges;
    edges.reserve(mate_.size() / 2);
    for (std::uint32_t s = 0; s < mate_.size(); ++s) {
      if (!leads(s)) continue;
      const auto [a, b] = std::minmax({end(s), end(next_corner(s))});
      edges.push_back({a, b, s});
    }
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  /// Calls visit(first, last) for each run of two or more edges with the same ends.
  template <class Visit>
  static void for_shared(const std::vector<Side>& edges, Visit visit) {
    for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
      while (last < edges.size() && edges[last].a == edges[first].a && edges[last].b == edges[first].b)
        ++last;
      if (last - first > 1) visit(first, last);
    }
  }

  void count_pinched_edges() {
    const auto edges = sorted_edges([&](std::uint32_t corner) { return input_vertex(corner); });
    for_shared(edges, [&](std::size_t, std::size_t) { ++surface_.pinched_edges; });
  }

  /// A vertex for each umbrella, in the order of (input vertex, its first corner).
  void make_copies() {
    DisjointSets umbrellas(mate_.size());
    for (std::uint32_t s = 0; s < mate_.size(); ++s) {
      umbrellas.join(s, next_corner(mate_[s]));
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> roots;
    for (std::uint32_t c = 0; c < mate_.size(); ++c) {
      if (umbrellas.is_root(c)) roots.emplace_back(input_vertex(c), c);
    }
    std::sort(roots.begin(), roots.end());
    for (std::size_t i = 0; i < roots.size(); ++i) {
      const bool repeats = i > 0 && roots[i - 1].first == roots[i].first;
      if (repeats) ++surface_.copies;
      if (repeats && (i == 1 || roots[i - 2].first != roots[i].first)) ++surface_.pinched_vertices;
      copy_[roots[i].second] = static_cast<std::uint32_t>(i);
      surface_.vertices.push_back({roots[i].first, kNone});
    }
    for (std::uint32_t c = 0; c < mate_.size(); ++c) copy_[c] = copy_[umbrellas.find(c)];
  }

  /// A midpoint for each wedge at an edge that several wedges have in common even by copies.
  void split_shared_edges() {
    const auto edges = sorted_edges([&](std::uint32_t corner) { return copy_[corner]; });
    std::vector<Side> split;
    for_shared(edges, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const std::uint32_t s = edges[i].number;
        const auto [a, b] = std::minmax({input_vertex(s), input_vertex(next_corner(s))});
        split.push_back({a, b, s});
      }
    });
    std::sort(split.begin(), split.end());
    for (const Side& side : split) {
      const SurfaceVertex middle{side.a, side.b};
      if (surface_.vertices.back() == middle) ++surface_.copies;
      midpoint_[side.number] = midpoint_[mate_[side.number]] =
          static_cast<std::uint32_t>(surface_.vertices.size());
      surface_.vertices.push_back(middle);
    }
    surface_.split_edges = static_cast<std::uint32_t>(split.size());
  }

  /// The triangle, or its pieces: ears at corners between two split sides, then a fan from a midpoint. Each
  /// new side ends at a midpoint, which is of one wedge only: no piece meets another one by chance.
  void emit(std::uint32_t t) {
    std::array<std::uint32_t, 4> ring{};
    std::size_t size = 0;
    std::size_t start = 0;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t before = midpoint_[3 * t + (i + 2) % 3];
      const std::uint32_t vertex = copy_[3 * t + i];
      const std::uint32_t after = midpoint_[3 * t + i];
      if (before != kNone && after != kNone) {
        emit(vertex, after, before);
      } else {
        ring[size++] = vertex;
      }
      if (after == kNone) continue;
      start = size;
      ring[size++] = after;
    }
    for (std::size_t k = 1; k + 1 < size; ++k) {
      emit(ring[start], ring[(start + k) % size], ring[(start + k + 1) % size]);
    }
  }

  void emit(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    surface_.triangles.push_back(rotated({a, b, c}));
  }

  const std::vector<Triple>& triangles_;
  const std::vector<std::uint32_t>& mate_;
  std::vector<std::uint32_t> midpoint_;  ///< by side
  std::vector<std::uint32_t> copy_;      ///< by corner: its vertex of the surface
  GluedSurface surface_;
};

/// Pairs the sides; false unless each edge has exactly two, in opposite directions, between different
/// vertices.
bool has_paired_sides(std::uint32_t vertex_count, std::span<const Triple> triangles,
                      std::vector<std::uint32_t>& mate) {
  std::vector<Side> sides;
  for (std::uint32_t s = 0; s < 3 * triangles.size(); ++s) {
    const std::uint32_t a = triangles[s / 3][s % 3];
    const std::uint32_t b = triangles[s / 3][(s + 1) % 3];
    if (a == b || a >= vertex_count) return false;
    sides.push_back({std::min(a, b), std::max(a, b), s});
  }
  std::sort(sides.begin(), sides.end());
  if (sides.size() % 2 != 0) return false;
  mate.assign(sides.size(), kNone);
  for (std::size_t i = 0; i < sides.size(); i += 2) {
    const Side& p = sides[i];
    const Side& q = sides[i + 1];
    if (p.a != q.a || p.b != q.b ||
        triangles[p.number / 3][p.number % 3] == triangles[q.number / 3][q.number % 3]) {
      return false;
    }
    if (i > 0 && sides[i - 1].a == p.a && sides[i - 1].b == p.b) return false;
    mate[p.number] = q.number;
    mate[q.number] = p.number;
  }
  return true;
}

}  // namespace

Result<GluedSurface> glue(std::span<const std::array<std::uint32_t, 4>> tets, const Context& context) {
  if (tets.size() >= kBoundaryMark / 4) return failure(ErrorCode::too_large, "2^29 tetrahedra or more");
  auto partner = FacetMatcher(tets).run(context);
  if (!partner) return partner.error();
  const std::vector<Triple> triangles = collect_boundary(tets, *partner);
  const auto mate = pair_sides(tets, *partner, triangles, context);
  if (context.cancelled()) return failure(ErrorCode::cancelled, "cancelled");
  *partner = {};
  return Cutter(triangles, mate).run();
}

bool verify_surface(std::uint32_t vertex_count, std::span<const std::array<std::uint32_t, 3>> triangles) {
  std::vector<std::uint32_t> mate;
  if (!has_paired_sides(vertex_count, triangles, mate)) return false;
  DisjointSets umbrellas(mate.size());
  for (std::uint32_t s = 0; s < mate.size(); ++s) umbrellas.join(s, next_corner(mate[s]));
  // One umbrella a vertex: as many as there are vertices, and each vertex has one.
  std::vector<std::uint8_t> seen(vertex_count, 0);
  for (std::uint32_t c = 0; c < mate.size(); ++c) {
    if (!umbrellas.is_root(c)) continue;
    std::uint8_t& mark = seen[triangles[c / 3][c % 3]];
    if (mark != 0) return false;
    mark = 1;
  }
  return std::find(seen.begin(), seen.end(), std::uint8_t{0}) == seen.end();
}

}  // namespace crossloft
