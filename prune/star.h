#pragma once
/// Walking around a vertex or an edge of the tetrahedra.
///
/// A tetrahedron has ten *corners*: its vertex slots 0..3 and its edges 4..9 (edge e is corner 4 + e). The
/// star of a simplex is walked across facets, from a corner of one tetrahedron to the same simplex's corner
/// of the next.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "cell_complex.h"

namespace crossloft {

inline constexpr unsigned kCorners = 10;

/// Corner of the edge between two different vertex slots.
inline constexpr std::array<std::array<std::uint8_t, 4>, 4> kEdgeCorner{
    {{0, 4, 5, 6}, {4, 0, 7, 8}, {5, 7, 0, 9}, {6, 8, 9, 0}}};

/// Corner of the edge opposite to the one between slots i and j, in the facets opposite to both.
inline unsigned opposite_edge(unsigned i, unsigned j) { return 13U - kEdgeCorner[i][j]; }

/// Bit i: the facet opposite slot i contains the corner, that is, slot i is not one of its vertices.
inline constexpr std::array<std::uint8_t, kCorners> kCornerFacets{
    {0b1110, 0b1101, 0b1011, 0b0111, 0b1100, 0b1010, 0b0110, 0b1001, 0b0101, 0b0011}};

inline bool facet_contains(unsigned facet, unsigned corner) {
  return (kCornerFacets[corner] >> facet & 1U) != 0;
}

/// Slot of vertex v in the tetrahedron. REQUIRES: v is one of its vertices.
inline unsigned slot_of(const std::array<std::uint32_t, 4>& tet, std::uint32_t v) {
  // Without branches: which slot it is can't be predicted.
  const unsigned low = tet[1] == v ? 1U : 0U;
  const unsigned high = (tet[2] == v ? 2U : 0U) | (tet[3] == v ? 3U : 0U);
  return low | high;
}

/// The vertices of a tetrahedron as its name: independent of its number and the order of its slots.
inline TetName sorted_vertices(const TetMesh& mesh, std::uint32_t t) {
  std::array<std::uint32_t, 4> v = mesh.vertices[t];
  const auto order = [&](unsigned i, unsigned j) {
    const std::uint32_t low = std::min(v[i], v[j]), high = std::max(v[i], v[j]);
    v[i] = low, v[j] = high;
  };
  order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
  return v;
}

/// The tetrahedron of that name, kNone if there is none. O(n).
inline std::uint32_t tet_of_name(const TetMesh& mesh, const TetName& name) {
  for (std::uint32_t t = 0; t < mesh.size(); ++t)
    if (sorted_vertices(mesh, t) == name) return t;
  return kNone;
}

/// The vertices of a facet, ascending.
inline Triangle facet_vertices(const TetMesh& mesh, std::uint32_t t, unsigned facet) {
  Triangle v{};
  for (std::size_t k = 0; k < 3; ++k) v[k] = mesh.vertices[t][kFacetSlots[facet][k]];
  std::sort(v.begin(), v.end());
  return v;
}

/// The other one of the two facets of a tetrahedron at an edge. REQUIRES: the facet contains it.
inline std::uint8_t other_facet(unsigned facet, unsigned corner) {
  return static_cast<std::uint8_t>(__builtin_ctz(kCornerFacets[corner] & ~(1U << facet)));
}

/// Facet of tetrahedron t that leads to its neighbour n. REQUIRES: they are neighbours.
inline unsigned facet_towards(const TetMesh& mesh, std::uint32_t t, std::uint32_t n) {
  return slot_of(mesh.neighbours[t], n);
}

/// The corner of tetrahedron n that is the same simplex as the given corner of t. REQUIRES: n has that
/// simplex.
inline unsigned same_corner(const TetMesh& mesh, std::uint32_t t, unsigned corner, std::uint32_t n) {
  const auto& from = mesh.vertices[t];
  const auto& to = mesh.vertices[n];
  if (corner < 4) return slot_of(to, from[corner]);
  const auto& ends = kEdgeSlots[corner - 4];
  return kEdgeCorner[slot_of(to, from[ends[0]])][slot_of(to, from[ends[1]])];
}

/// A place on the way around an edge: in a tetrahedron, from one of its facets at the edge to the other one.
/// Facets are also the slots opposite to them, whose vertices are not on the edge.
class Turn {
 public:
  Turn(std::uint32_t tet, unsigned out, unsigned in) : tet_(tet), out_(out), in_(in) {}

  std::uint32_t tet() const { return tet_; }
  std::uint8_t out() const { return static_cast<std::uint8_t>(out_); }
  std::uint8_t in() const { return static_cast<std::uint8_t>(in_); }
  unsigned corner() const { return opposite_edge(out_, in_); }
  std::uint32_t next(const TetMesh& mesh) const { return mesh.neighbours[tet_][out_]; }

  /// The vertex opposite to where it came in stays; what is opposite to that is the way out.
  void enter(const TetMesh& mesh, std::uint32_t n) {
    const std::uint32_t stays = mesh.vertices[tet_][in_];
    in_ = facet_towards(mesh, n, tet_);
    out_ = slot_of(mesh.vertices[n], stays);
    tet_ = n;
  }

 private:
  std::uint32_t tet_;
  unsigned out_, in_;
};

/// Calls visit(n, corner of n that is the edge) for the other tetrahedra n around an edge of `start`, once
/// each: around once, or on both sides as far as the hull. O(degree of the edge).
template <class Visit>
void visit_around_edge(const TetMesh& mesh, std::uint32_t start, unsigned corner, Visit&& visit) {
  const unsigned both = kCornerFacets[corner];
  const auto low = static_cast<unsigned>(__builtin_ctz(both)),
             high = 31U - static_cast<unsigned>(__builtin_clz(both));
  for (const Turn& side : {Turn(start, low, high), Turn(start, high, low)}) {
    Turn turn = side;
    for (std::uint32_t n; (n = turn.next(mesh)) != kNone;) {
      if (n == start) return;
      turn.enter(mesh, n);
      visit(n, turn.corner());
    }
  }
}

/// Solidity is asked at vertices and grounded edges only.
inline bool is_grounded(const CellComplex& complex, std::uint32_t t, unsigned corner) {
  return corner < 4 || complex.edges[t][corner - 4] != EdgeKind::free;
}

/// True iff an internal grounded triangle of t contains the corner.
inline bool is_on_ground(const CellComplex& complex, std::uint32_t t, unsigned corner) {
  for (unsigned i = 0; i < 4; ++i) {
    if (facet_contains(i, corner) && complex.facets[t][i] == FacetKind::internal) return true;
  }
  return false;
}

/// Kinds side by side, a byte for each: all of a tetrahedron are asked at once, as nearly all are asked
/// often.
template <class Kind, std::size_t n>
std::uint64_t bytes_of(const std::array<Kind, n>& kinds) {
  static_assert(sizeof(Kind) == 1 && n <= 8);
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, kinds.data(), n);
  return bytes;
}
inline constexpr std::uint64_t kEachByte = 0x0101010101010101;
static_assert(static_cast<int>(FacetKind::internal) == 1 && static_cast<int>(FacetKind::external) == 2);
static_assert(static_cast<int>(EdgeKind::contour) == 1 && static_cast<int>(EdgeKind::internal) == 2 &&
              static_cast<int>(EdgeKind::external) == 3);

/// True iff a triangle of t is within a section.
inline bool stands_on_section(const CellComplex& complex, std::uint32_t t) {
  return (bytes_of(complex.facets[t]) & kEachByte) != 0;
}

/// True iff an edge of t is within a section, not on a contour.
inline bool has_inner_edge(const CellComplex& complex, std::uint32_t t) {
  const std::uint64_t kinds = bytes_of(complex.edges[t]);
  return (kinds >> 1 & ~kinds & kEachByte) != 0;
}

/// True iff a triangle or an edge of t is outside of a section.
inline bool is_external(const CellComplex& complex, std::uint32_t t) {
  const std::uint64_t kinds = bytes_of(complex.edges[t]);
  return ((bytes_of(complex.facets[t]) >> 1 | (kinds >> 1 & kinds)) & kEachByte) != 0;
}

}  // namespace crossloft
