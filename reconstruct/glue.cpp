#include "glue.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "../delaunay/tet_mesh.h"
#include "../prune/disjoint_sets.h"
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

/// All facets by their smallest vertex: those of v are [begin[v], begin[v + 1]).
struct FacetBuckets {
  std::vector<std::size_t> begin;
  std::vector<Facet> facets;
};

FacetBuckets fill_buckets(Tets tets) {
  std::uint32_t vertex_count = 0;
  for (const auto& tet : tets)
    vertex_count = std::max(vertex_count, *std::max_element(tet.begin(), tet.end()) + 1);
  FacetBuckets buckets;
  buckets.begin.assign(std::size_t{vertex_count} + 1, 0);
  for (std::uint32_t f = 0; f < 4 * tets.size(); ++f)
    ++buckets.begin[rotated(outward(tets, f))[0] + std::size_t{1}];
  std::partial_sum(buckets.begin.begin(), buckets.begin.end(), buckets.begin.begin());
  buckets.facets.resize(4 * tets.size());
  std::vector<std::size_t> next(buckets.begin);
  for (std::uint32_t f = 0; f < 4 * tets.size(); ++f) {
    const Triple t = rotated(outward(tets, f));
    buckets.facets[next[t[0]]++] = {std::min(t[1], t[2]), std::max(t[1], t[2]), f, t[1] < t[2]};
  }
  return buckets;
}

/// partner[f] = the facet glued to facet f, kNone on the boundary.
Result<std::vector<std::uint32_t>> match_facets(Tets tets) {
  FacetBuckets buckets = fill_buckets(tets);
  std::vector<std::uint32_t> partner(4 * tets.size(), kNone);
  for (std::size_t v = 0; v + 1 < buckets.begin.size(); ++v) {
    const std::span bucket(buckets.facets.data() + buckets.begin[v], buckets.begin[v + 1] - buckets.begin[v]);
    std::sort(bucket.begin(), bucket.end());
    for (std::size_t i = 0; i + 1 < bucket.size(); ++i) {
      const Facet& p = bucket[i];
      const Facet& q = bucket[i + 1];
      if (!p.same_vertices(q)) continue;
      if (p.even == q.even || partner[p.number] != kNone) {
        return failure(ErrorCode::internal, "tetrahedra overlap: they can't be glued");
      }
      partner[p.number] = q.number;
      partner[q.number] = p.number;
    }
  }
  return partner;
}

/// The boundary: triangles with the smallest vertex first, sorted, and the facet of each.
struct Boundary {
  std::vector<Triple> triangles;
  std::vector<std::uint32_t> facets;
  std::vector<std::uint32_t> triangle_of;  ///< by facet, kNone inside
};

Boundary collect_boundary(Tets tets, const std::vector<std::uint32_t>& partner) {
  std::vector<std::pair<Triple, std::uint32_t>> found;
  for (std::uint32_t f = 0; f < partner.size(); ++f) {
    if (partner[f] == kNone) found.emplace_back(rotated(outward(tets, f)), f);
  }
  std::sort(found.begin(), found.end());
  Boundary boundary;
  boundary.triangle_of.assign(partner.size(), kNone);
  for (const auto& [triangle, facet] : found) {
    boundary.triangle_of[facet] = static_cast<std::uint32_t>(boundary.triangles.size());
    boundary.triangles.push_back(triangle);
    boundary.facets.push_back(facet);
  }
  return boundary;
}

/// The boundary facet at the other end of the solid wedge at edge (a, b): from facet to facet around the
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
    if (partner[facet] == kNone) return facet;
    facet = partner[facet];
  }
}

/// Side i of triangle t runs from its corner i to corner (i + 1) % 3; its number is 3 * t + i, as that of
/// corner i.
std::uint32_t next_corner(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

/// mate[s] = the side paired with side s.
std::vector<std::uint32_t> pair_sides(Tets tets, const std::vector<std::uint32_t>& partner,
                                      const Boundary& boundary) {
  std::vector<std::uint32_t> mate(3 * boundary.triangles.size());
  for (std::uint32_t s = 0; s < mate.size(); ++s) {
    const Triple& triangle = boundary.triangles[s / 3];
    const std::uint32_t a = triangle[s % 3];
    const std::uint32_t b = triangle[(s + 1) % 3];
    const std::uint32_t t = boundary.triangle_of[across_wedge(tets, partner, boundary.facets[s / 3], a, b)];
    const Triple& met = boundary.triangles[t];
    mate[s] = 3 * t + static_cast<std::uint32_t>(std::find(met.begin(), met.end(), b) - met.begin());
  }
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
  Cutter(const Boundary& boundary, const std::vector<std::uint32_t>& mate)
      : triangles_(boundary.triangles), mate_(mate), midpoint_(mate.size(), kNone), copy_(mate.size()) {}

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

Result<GluedSurface> glue(std::span<const std::array<std::uint32_t, 4>> tets) {
  if (tets.size() >= std::size_t{1} << 30) return failure(ErrorCode::too_large, "more than 2^30 tetrahedra");
  const auto partner = match_facets(tets);
  if (!partner) return partner.error();
  const Boundary boundary = collect_boundary(tets, *partner);
  const auto mate = pair_sides(tets, *partner, boundary);
  return Cutter(boundary, mate).run();
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
