#include "links.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

#include "../geom/disjoint_sets.h"
#include "star.h"

namespace crossloft {
namespace {

/// Index of the tetrahedra at each wanted vertex that bear on its link: kept ones and those with an internal
/// triangle there.
class Stars {
 public:
  Stars(const CellComplex& complex, std::span<const std::uint8_t> kept,
        const std::vector<std::uint8_t>& wanted)
      : begin_(complex.vertex_count + 1, 0) {
    for_corners(complex, kept, wanted, [&](std::uint32_t v, std::uint32_t) { ++begin_[v + 1]; });
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    tets_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for_corners(complex, kept, wanted, [&](std::uint32_t v, std::uint32_t t) { tets_[next[v]++] = t; });
  }

  std::span<const std::uint32_t> of(std::uint32_t v) const {
    return std::span(tets_).subspan(begin_[v], begin_[v + 1] - begin_[v]);
  }

 private:
  template <class Visit>
  static void for_corners(const CellComplex& complex, std::span<const std::uint8_t> kept,
                          const std::vector<std::uint8_t>& wanted, Visit visit) {
    for (std::uint32_t t = 0; t < complex.mesh.size(); ++t) {
      for (unsigned slot = 0; slot < 4; ++slot) {
        const std::uint32_t v = complex.mesh.vertices[t][slot];
        if (wanted[v] != 0 && (kept[t] != 0 || is_on_ground(complex, t, slot))) visit(v, t);
      }
    }
  }

  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> tets_;
};

/// Label of the far corner of a virtual triangle: never a vertex of the mesh.
constexpr std::uint32_t kBehind = kNone;

/// A side of a link triangle by its ends a < b as corners, 3 * triangle + 0..2: the facet (v, a, b) of a
/// tetrahedron or, for b = kBehind, the grounded edge (v, a) of a virtual triangle.
struct Side {
  std::uint64_t ends;  ///< a in the upper half, b in the lower one
  std::uint32_t corner_a, corner_b;
};

enum class LinkShape : std::uint8_t { disk, sphere, disconnected, pinched, annular };

class ExtendedLink {
 public:
  ExtendedLink(const CellComplex& complex, std::span<const std::uint8_t> kept)
      : complex_(complex), kept_(kept), seen_at_(complex.vertex_count, kNone) {}

  LinkShape shape(std::uint32_t v, std::span<const std::uint32_t> star) {
    collect(v, star);
    const auto triangle_count = static_cast<std::uint32_t>(triangles_.size());
    std::sort(sides_.begin(), sides_.end(), [](const Side& p, const Side& q) { return p.ends < q.ends; });
    corners_.reset(std::size_t{3} * triangle_count);
    components_.reset(triangle_count);
    const std::uint32_t glued = glue_sides();
    if (components_.count() > 1) return LinkShape::disconnected;
    const std::uint32_t corner_count = corners_.count();
    if (corner_count > label_count(v)) return LinkShape::pinched;
    const int chi =
        static_cast<int>(corner_count + triangle_count) - static_cast<int>(3 * triangle_count - glued);
    return chi == 2 ? LinkShape::sphere : chi == 1 ? LinkShape::disk : LinkShape::annular;
  }

 private:
  void collect(std::uint32_t v, std::span<const std::uint32_t> star) {
    triangles_.clear();
    sides_.clear();
    for (const std::uint32_t t : star) {
      const auto& vertices = complex_.mesh.vertices[t];
      const unsigned slot = slot_of(vertices, v);
      const auto& opposite = kFacetSlots[slot];
      if (kept_[t] != 0) add(vertices[opposite[0]], vertices[opposite[1]], vertices[opposite[2]]);
      for (const unsigned facet : opposite) {
        if (complex_.facets[t][facet] == FacetKind::internal) add_virtual(vertices, slot, facet);
      }
    }
  }

  void add_virtual(const std::array<std::uint32_t, 4>& vertices, unsigned slot, unsigned facet) {
    std::array<std::uint32_t, 2> ends{};
    std::size_t count = 0;
    for (unsigned i = 0; i < 4; ++i) {
      if (i != slot && i != facet) ends[count++] = vertices[i];
    }
    add(ends[0], ends[1], kBehind);
  }

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto triangle = static_cast<std::uint32_t>(triangles_.size());
    const std::array<std::uint32_t, 3> labels{a, b, c};
    triangles_.push_back(labels);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t k = (i + 1) % 3;
      const std::uint32_t low = labels[i] < labels[k] ? i : k;
      const std::uint32_t high = i + k - low;
      sides_.push_back(
          {std::uint64_t{labels[low]} << 32 | labels[high], 3 * triangle + low, 3 * triangle + high});
    }
  }

  /// Joins triangles and corners across equal sides; returns the number of glued pairs. Sides come in ones
  /// and twos: a facet has two tetrahedra or is on the hull, where a virtual triangle may take the other
  /// side, and a grounded edge is on two hull facets.
  std::uint32_t glue_sides() {
    std::uint32_t glued = 0;
    for (std::size_t i = 0; i + 1 < sides_.size(); ++i) {
      const Side& p = sides_[i];
      const Side& q = sides_[i + 1];
      if (p.ends != q.ends) continue;
      components_.join(p.corner_a / 3, q.corner_a / 3);
      corners_.join(p.corner_a, q.corner_a);
      corners_.join(p.corner_b, q.corner_b);
      ++glued;
      ++i;
    }
    return glued;
  }

  /// Different vertices of the link. The section side counts once for each of its fans around v: two wedges
  /// of a section that touch in v only are the section's own affair.
  std::uint32_t label_count(std::uint32_t v) {
    std::uint32_t count = 0;
    for (std::uint32_t c = 0; c < 3 * triangles_.size(); ++c) {
      const std::uint32_t label = triangles_[c / 3][c % 3];
      if (label == kBehind) {
        count += corners_.is_root(c) ? 1U : 0U;
      } else if (seen_at_[label] != v) {
        seen_at_[label] = v;
        ++count;
      }
    }
    return count;
  }

  const CellComplex& complex_;
  std::span<const std::uint8_t> kept_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<Side> sides_;
  std::vector<std::uint32_t> seen_at_;  ///< by vertex: the vertex in whose link it was counted last
  DisjointSets components_, corners_;
};

void count(LinkShape shape, LinkCensus& census) {
  switch (shape) {
    case LinkShape::disk:
      ++census.disks;
      break;
    case LinkShape::sphere:
      ++census.spheres;
      break;
    case LinkShape::disconnected:
      ++census.disconnected;
      break;
    case LinkShape::pinched:
      ++census.pinched;
      break;
    case LinkShape::annular:
      ++census.annular;
      break;
  }
}

}  // namespace

LinkCensus census_links(const CellComplex& complex, std::span<const std::uint8_t> kept,
                        const std::vector<std::uint8_t>& wanted) {
  const Stars stars(complex, kept, wanted);
  ExtendedLink link(complex, kept);
  LinkCensus census;
  for (std::uint32_t v = 0; v < complex.vertex_count; ++v) {
    if (wanted[v] == 0) continue;
    const auto star = stars.of(v);
    const bool bare = std::none_of(star.begin(), star.end(), [&](std::uint32_t t) { return kept[t] != 0; });
    if (bare) {
      ++census.bare;
    } else {
      count(link.shape(v, star), census);
    }
  }
  return census;
}

}  // namespace crossloft
