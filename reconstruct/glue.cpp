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
#include "lists.h"
#include "resize.h"
#include "self_check.h"
#include "sort_quadruples.h"

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
Triple rotated(const Triple& t) {
  if (t[1] < t[0] && t[1] < t[2]) return {t[1], t[2], t[0]};
  if (t[2] < t[0] && t[2] < t[1]) return {t[2], t[0], t[1]};
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

/// Facets without a partner all of whose vertices are flagged, in groups of the same vertices: two of them
/// are glued. False if there are more than two, or two with the same side.
class FacetMatcher {
 public:
  FacetMatcher(Tets tets, UnsetVector<std::uint32_t>& partner) : tets_(tets), partner_(partner) {}

  bool run(const std::vector<std::uint8_t>& flagged) {
    std::vector<std::uint32_t> facets;
    for (std::uint32_t f = 0; f < partner_.size(); ++f) {
      const Triple t = outward(tets_, f);
      if (partner_[f] == kNone && (flagged[t[0]] & flagged[t[1]] & flagged[t[2]]) != 0) facets.push_back(f);
    }
    FacetBuckets buckets = fill_buckets(tets_, facets);
    for (std::size_t v = 0; v + 1 < buckets.begin.size(); ++v)
      match({buckets.facets.data() + buckets.begin[v], buckets.begin[v + 1] - buckets.begin[v]});
    return !overlap_;
  }

 private:
  void match(std::span<Facet> bucket) {
    std::sort(bucket.begin(), bucket.end());
    for (std::size_t i = 0; i + 1 < bucket.size(); ++i) {
      const Facet &f = bucket[i], &g = bucket[i + 1];
      if (!f.same_vertices(g)) continue;
      if (f.even == g.even || partner_[f.number] != kNone) overlap_ = true;
      partner_[f.number] = g.number;
      partner_[g.number] = f.number;
    }
  }

  Tets tets_;
  UnsetVector<std::uint32_t>& partner_;
  bool overlap_ = false;
};

/// Flags of the vertices of some tetrahedra.
std::vector<std::uint8_t> vertices_of(Tets tets, std::span<const std::uint32_t> some) {
  std::uint32_t largest = 0;
  for (const auto& tet : tets) largest = std::max({largest, tet[0], tet[1], tet[2], tet[3]});
  std::vector<std::uint8_t> flags(largest + std::size_t{1}, 0);
  for (const std::uint32_t t : some)
    for (const std::uint32_t v : tets[t]) flags[v] = 1;
  return flags;
}

/// Nothing known.
KnownFacets all_loose(std::size_t tets) {
  KnownFacets known{UnsetVector<std::uint32_t>(4 * tets, kNone), std::vector<std::uint32_t>(tets)};
  std::iota(known.loose.begin(), known.loose.end(), 0U);
  return known;
}

/// By vertices alone, to check what was known; empty if tetrahedra overlap.
UnsetVector<std::uint32_t> all_partners(Tets tets) {
  KnownFacets all = all_loose(tets.size());
  if (!all.loose.empty() && !FacetMatcher(tets, all.partner).run(vertices_of(tets, all.loose))) return {};
  return all.partner;
}

/// What `partner` says of a boundary facet: its number in the order of the facets, marked.
constexpr std::uint32_t kBoundaryMark = 1U << 31;
bool is_boundary(std::uint32_t partner) { return (partner & kBoundaryMark) != 0; }

/// The boundary in the order of its facets, that is of the cells: neighbours are near each other. Triangles
/// with their smallest vertex first.
struct BoundaryFacets {
  UnsetVector<Triple> triangles;
  UnsetVector<std::uint32_t> facets;
};

BoundaryFacets mark_boundary(Tets tets, UnsetVector<std::uint32_t>& partner, const Context& context) {
  BoundaryFacets boundary;
  number_kept(
      partner.size(), context, "gluing", [&](std::size_t f) { return partner[f] == kNone; },
      [&](std::size_t count) { boundary.triangles.resize(count), boundary.facets.resize(count); },
      [&](std::size_t f, std::size_t number) {
        partner[f] = kBoundaryMark | static_cast<std::uint32_t>(number);
        boundary.facets[number] = static_cast<std::uint32_t>(f);
        boundary.triangles[number] = rotated(outward(tets, static_cast<std::uint32_t>(f)));
      });
  return boundary;
}

/// The boundary facet at the other end of the solid wedge at an edge of a facet, the one without the
/// vertex `stays`: from facet to facet around the edge, through the tetrahedra between them.
std::uint32_t across_wedge(Tets tets, const UnsetVector<std::uint32_t>& partner, std::uint32_t facet,
                           std::uint32_t stays) {
  for (;;) {
    // The way out is opposite to what came in before last, the only other vertex that is not on the edge.
    const auto& tet = tets[facet / 4];
    const std::uint32_t opposite = tet[facet % 4];
    facet = partner[facet / 4 * 4 + slot_of(tet, stays)];
    if (is_boundary(facet)) return facet & ~kBoundaryMark;
    stays = opposite;
  }
}

/// Side i of triangle t runs from its corner i to corner (i + 1) % 3; its number is 3 * t + i, as that of
/// corner i.
std::uint32_t next_corner(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }

UnsetVector<std::uint32_t> all_none(std::size_t count, const Context& context) {
  UnsetVector<std::uint32_t> numbers(count);
  for_blocks(count, context, "gluing", [&](std::size_t first, std::size_t last) {
    std::fill(numbers.data() + first, numbers.data() + last, kNone);
  });
  return numbers;
}

/// mate[s] = the side paired with side s, in the order of the facets. Whoever comes first to one of two sides
/// tells both.
UnsetVector<std::uint32_t> pair_sides(Tets tets, const UnsetVector<std::uint32_t>& partner,
                                      const BoundaryFacets& boundary, const Context& context) {
  const UnsetVector<Triple>& triangles = boundary.triangles;
  UnsetVector<std::uint32_t> mate = all_none(3 * triangles.size(), context);
  if (context.cancelled()) return mate;
  const auto at = [&](std::uint32_t side) { return std::atomic_ref<std::uint32_t>(mate[side]); };
  const auto pair = [&](std::uint32_t side) {
    if (at(side).load(std::memory_order_relaxed) != kNone) return;
    const Triple& triangle = triangles[side / 3];
    const std::uint32_t end = triangle[(side + 1) % 3];
    const std::uint32_t other =
        across_wedge(tets, partner, boundary.facets[side / 3], triangle[(side + 2) % 3]);
    const Triple& met = triangles[other];
    const std::uint32_t found = 3 * other + (met[0] == end ? 0U : met[1] == end ? 1U : 2U);
    at(side).store(found, std::memory_order_relaxed);
    at(found).store(side, std::memory_order_relaxed);
  };
  for_blocks(triangles.size(), context, "gluing", [&](std::size_t first, std::size_t last) {
    for (std::size_t side = 3 * first; side < 3 * last; ++side) pair(static_cast<std::uint32_t>(side));
  });
  return mate;
}

/// The triangles in order, each with its number so far.
UnsetVector<std::array<std::uint32_t, 4>> sorted_with_numbers(const UnsetVector<Triple>& triangles,
                                                              const Context& context) {
  UnsetVector<std::array<std::uint32_t, 4>> sorted(triangles.size());
  for_blocks(triangles.size(), context, "gluing", [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t)
      sorted[t] = {triangles[t][0], triangles[t][1], triangles[t][2], static_cast<std::uint32_t>(t)};
  });
  std::size_t firsts = 0;
  for (const Triple& t : triangles) firsts = std::max(firsts, t[0] + std::size_t{1});
  if (!context.cancelled()) sort_quadruples(sorted, firsts, context);
  return sorted;
}

/// Of no use if the context has been cancelled.
PairedBoundary sorted(BoundaryFacets boundary, const UnsetVector<std::uint32_t>& mate,
                      const Context& context) {
  const std::size_t count = boundary.triangles.size();
  const auto by_place = sorted_with_numbers(boundary.triangles, context);
  boundary.triangles = {};
  PairedBoundary result;
  if (context.cancelled()) return result;
  result.triangles.resize(count), result.facets.resize(count), result.mate.resize(mate.size());
  UnsetVector<std::uint32_t> place(count);
  for_blocks(count, context, "gluing", [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) {
      const auto& [a, b, c, number] = by_place[k];
      result.triangles[k] = {a, b, c};
      result.facets[k] = boundary.facets[number];
      place[number] = static_cast<std::uint32_t>(k);
    }
  });
  if (context.cancelled()) return result;
  for_blocks(count, context, "gluing", [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t other = mate[3 * std::size_t{by_place[k][3]} + i];
        result.mate[3 * k + i] = 3 * place[other / 3] + other % 3;
      }
  });
  return result;
}

/// A side by the two ends that it joins, the smaller one first.
struct Side {
  std::uint32_t a, b, number;

  friend auto operator<=>(const Side&, const Side&) = default;
};

/// Calls visit(first, last) for each run of two or more sides with the same ends.
template <class Visit>
void for_shared(const std::vector<Side>& sides, Visit visit) {
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    while (last < sides.size() && sides[last].a == sides[first].a && sides[last].b == sides[first].b) ++last;
    if (last - first > 1) visit(first, last);
  }
}

/// Cuts the boundary apart; see the header for the rules.
class Cutter {
 public:
  Cutter(const PairedBoundary& boundary, bool with_tets, const Context& context)
      : triangles_(boundary.triangles),
        mate_(boundary.mate),
        facets_(with_tets ? &boundary.facets : nullptr),
        context_(context),
        copy_(all_none(mate_.size(), context)) {}

  GluedSurface run() {
    if (context_.cancelled()) return {};
    make_copies(find_umbrellas());
    if (context_.cancelled()) return {};
    split_shared_edges();
    if (midpoint_.empty())
      emit_whole();
    else
      emit_divided();
    return std::move(surface_);
  }

 private:
  /// By its smallest corner.
  struct UmbrellaAt {
    std::uint32_t vertex, corner;
    friend auto operator<=>(const UmbrellaAt&, const UmbrellaAt&) = default;
  };

  /// What is found at some vertices.
  struct Found {
    std::vector<Side> pinched;  ///< one of each pair, at edges with several
    std::uint32_t pinched_edges = 0, pinched_vertices = 0;
    std::vector<std::uint32_t> ends;  ///< of the spokes at one vertex
  };

  std::uint32_t input_vertex(std::uint32_t corner) const { return triangles_[corner / 3][corner % 3]; }

  /// Calls visit(corner) around the umbrella, as long as it returns true: the side that starts there is a
  /// spoke.
  template <class Visit>
  bool walk_while(std::uint32_t corner, Visit visit) const {
    std::uint32_t c = corner;
    do {
      if (!visit(c)) return false;
      c = next_corner(mate_[c]);
    } while (c != corner);
    return true;
  }
  template <class Visit>
  void walk(std::uint32_t corner, Visit visit) const {
    walk_while(corner, [&](std::uint32_t c) { return visit(c), true; });
  }

  /// Of those whose smallest corner is among first..last-1. What has been seen from a smaller corner on is
  /// passed over, and a walk that meets one ends: nobody marks the smallest corner but a walk from there.
  std::vector<UmbrellaAt> find_umbrellas_in(std::size_t first, std::size_t last) {
    constexpr std::uint32_t kSeen = 0;
    std::vector<UmbrellaAt> found;
    const auto at = [&](std::uint32_t corner) { return std::atomic_ref(copy_[corner]); };
    for (auto c = static_cast<std::uint32_t>(first); c < last; ++c) {
      if (at(c).load(std::memory_order_relaxed) == kSeen) continue;
      const bool is_smallest = walk_while(c, [&](std::uint32_t corner) {
        if (corner < c) return false;
        at(corner).store(kSeen, std::memory_order_relaxed);
        return true;
      });
      if (is_smallest) found.push_back({input_vertex(c), c});
    }
    return found;
  }

  /// In the order of (input vertex, corner).
  std::vector<UmbrellaAt> find_umbrellas() {
    std::vector<std::vector<UmbrellaAt>> found((mate_.size() + kBlock - 1) / kBlock);
    for_blocks(mate_.size(), context_, "gluing", [&](std::size_t first, std::size_t last) {
      found[first / kBlock] = find_umbrellas_in(first, last);
    });
    std::vector<UmbrellaAt> umbrellas;
    for (auto& list : found) {
      umbrellas.insert(umbrellas.end(), list.begin(), list.end());
      list = {};
    }
    sort_by_vertex(umbrellas, [](const UmbrellaAt& u) { return u.vertex; });
    return umbrellas;
  }

  /// A vertex for each umbrella.
  void make_copies(const std::vector<UmbrellaAt>& umbrellas) {
    surface_.vertices.resize(umbrellas.size());
    std::vector<Found> found((umbrellas.size() + kBlock - 1) / kBlock);
    for_blocks(umbrellas.size(), context_, "gluing", [&](std::size_t first, std::size_t last) {
      // Those at one vertex go with the first of them.
      const auto goes_on = [&](std::size_t u) {
        return u > 0 && u < umbrellas.size() && umbrellas[u].vertex == umbrellas[u - 1].vertex;
      };
      for (std::size_t u = first, end = 0; u < last; u = end) {
        for (end = u + 1; goes_on(end);) ++end;
        if (u != first || !goes_on(u))
          copy_vertex({umbrellas.data() + u, end - u}, static_cast<std::uint32_t>(u), found[first / kBlock]);
      }
    });
    std::uint32_t points = 0;
    for (std::size_t u = 0; u < umbrellas.size(); ++u)
      points += u == 0 || umbrellas[u].vertex != umbrellas[u - 1].vertex ? 1U : 0U;
    surface_.copies = static_cast<std::uint32_t>(umbrellas.size()) - points;
    for (const Found& f : found) {
      pinched_.insert(pinched_.end(), f.pinched.begin(), f.pinched.end());
      surface_.pinched_edges += f.pinched_edges;
      surface_.pinched_vertices += f.pinched_vertices;
    }
  }

  /// The umbrellas at one input vertex become the vertices from `number` on. An edge of several wedges has a
  /// spoke in each: it is met again.
  void copy_vertex(std::span<const UmbrellaAt> umbrellas, std::uint32_t number, Found& found) {
    found.ends.clear();
    std::uint64_t met = 0;  // ends by their last bits
    bool may_repeat = false;
    for (const UmbrellaAt& u : umbrellas) {
      surface_.vertices[number] = {u.vertex, kNone};
      walk(u.corner, [&](std::uint32_t corner) {
        copy_[corner] = number;
        const std::uint32_t end = input_vertex(next_corner(corner));
        found.ends.push_back(end);
        const std::uint64_t bit = std::uint64_t{1} << (end % 64);
        may_repeat |= (met & bit) != 0;
        met |= bit;
      });
      ++number;
    }
    if (umbrellas.size() > 1) ++found.pinched_vertices;
    if (!may_repeat) return;
    std::sort(found.ends.begin(), found.ends.end());
    if (std::adjacent_find(found.ends.begin(), found.ends.end()) != found.ends.end())
      find_pinched(umbrellas, found);
  }

  /// Counts edges from one input vertex to larger ones that have several pairs of sides, and lists the pairs.
  void find_pinched(std::span<const UmbrellaAt> umbrellas, Found& found) const {
    std::vector<Side> spokes;
    for (const UmbrellaAt& u : umbrellas)
      walk(u.corner, [&](std::uint32_t corner) {
        const std::uint32_t other = input_vertex(next_corner(corner));
        if (other > u.vertex) spokes.push_back({u.vertex, other, std::min(corner, mate_[corner])});
      });
    std::sort(spokes.begin(), spokes.end());
    for_shared(spokes, [&](std::size_t first, std::size_t last) {
      ++found.pinched_edges;
      for (std::size_t i = first; i < last; ++i) found.pinched.push_back(spokes[i]);
    });
  }

  /// A midpoint for each wedge at an edge that several wedges have in common even by copies: it is one of the
  /// pinched ones.
  void split_shared_edges() {
    std::vector<Side> edges;
    for (const Side& side : pinched_) {
      const auto [a, b] = std::minmax({copy_[side.number], copy_[next_corner(side.number)]});
      edges.push_back({a, b, side.number});
    }
    std::sort(edges.begin(), edges.end());
    std::vector<Side> split;
    for_shared(edges, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const std::uint32_t s = edges[i].number;
        const auto [a, b] = std::minmax({input_vertex(s), input_vertex(next_corner(s))});
        split.push_back({a, b, s});
      }
    });
    if (split.empty()) return;
    midpoint_.assign(mate_.size(), kNone);
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

  void emit_whole() {
    resize(surface_.triangles, triangles_.size(), context_);
    surface_.tets.resize(facets_ ? triangles_.size() : 0);
    for_blocks(triangles_.size(), context_, "gluing", [&](std::size_t first, std::size_t last) {
      for (std::size_t t = first; t < last; ++t) {
        surface_.triangles[t] = rotated({copy_[3 * t], copy_[3 * t + 1], copy_[3 * t + 2]});
        if (facets_) surface_.tets[t] = (*facets_)[t] / 4;
      }
    });
  }

  void emit_divided() {
    surface_.triangles.reserve(triangles_.size());
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      emit(t);
      if (facets_) surface_.tets.resize(surface_.triangles.size(), (*facets_)[t] / 4);
    }
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

  const UnsetVector<Triple>& triangles_;
  const UnsetVector<std::uint32_t>& mate_;
  const UnsetVector<std::uint32_t>* facets_;  ///< null if nobody wants to know
  const Context& context_;
  std::vector<Side> pinched_;            ///< at edges with several: one of each pair
  UnsetVector<std::uint32_t> copy_;      ///< by corner: its vertex of the surface
  std::vector<std::uint32_t> midpoint_;  ///< by side; empty if there are none
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

Result<PairedBoundary> pair_boundary(Tets tets, KnownFacets known, const Context& context) {
  if (tets.size() >= kBoundaryMark / 4) return failure(ErrorCode::too_large, "2^29 tetrahedra or more");
  if (context.cancelled()) return failure(ErrorCode::cancelled, "cancelled");
  UnsetVector<std::uint32_t>& partner = known.partner;
  if (!known.loose.empty() && !FacetMatcher(tets, partner).run(vertices_of(tets, known.loose)))
    return failure(ErrorCode::internal, "tetrahedra overlap: they can't be glued");
  const auto good = self_check("gluing", [&] {
    return partner == all_partners(tets) ? "" : "facets are not matched as their vertices say";
  });
  if (!good) return good.error();
  if (context.cancelled()) return failure(ErrorCode::cancelled, "cancelled");
  BoundaryFacets boundary = mark_boundary(tets, partner, context);
  if (context.cancelled()) return failure(ErrorCode::cancelled, "cancelled");
  if (boundary.facets.size() >= kNone / 3) return failure(ErrorCode::too_large, "2^32 / 3 triangles or more");
  const UnsetVector<std::uint32_t> mate = pair_sides(tets, partner, boundary, context);
  if (context.cancelled()) return failure(ErrorCode::cancelled, "cancelled");
  partner = {};
  PairedBoundary paired = sorted(std::move(boundary), mate, context);
  if (context.cancelled()) return failure(ErrorCode::cancelled, "cancelled");
  return paired;
}

Result<GluedSurface> cut_apart(const PairedBoundary& boundary, const Context& context, bool with_tets) {
  GluedSurface surface = Cutter(boundary, with_tets, context).run();
  if (context.cancelled()) return failure(ErrorCode::cancelled, "cancelled");
  return surface;
}

Result<GluedSurface> glue(Tets tets, KnownFacets known, const Context& context, bool with_tets) {
  const auto boundary = pair_boundary(tets, std::move(known), context);
  if (!boundary) return boundary.error();
  return cut_apart(*boundary, context, with_tets);
}

Result<GluedSurface> glue(Tets tets, const Context& context) {
  if (tets.size() >= kBoundaryMark / 4) return failure(ErrorCode::too_large, "2^29 tetrahedra or more");
  return glue(tets, all_loose(tets.size()), context);
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
