#pragma once
/// Gluing: the boundary of a set of tetrahedra as a closed oriented 2-manifold.
///
/// Where the solid touches itself the surface is cut apart by index: the facets around a singular edge (four
/// or more boundary facets) are paired through the solid wedge between them, and a vertex is copied once for
/// each of its umbrellas, the cycles of triangles across paired edges. Two wedges may still share both ends;
/// their edge is then split at a midpoint of its own for each wedge. The result is a 2-manifold by index for
/// any set of tetrahedra; copies share coordinates. Umbrellas as in Gueziec, Taubin, Lazarus, Horn: Cutting
/// and Stitching.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "../geom/context.h"
#include "../geom/ids.h"
#include "../geom/result.h"
#include "../geom/unset_vector.h"

namespace crossloft {

/// A vertex of the surface: the input vertex `a`, or the midpoint of the input vertices a < b.
struct SurfaceVertex {
  std::uint32_t a = kNone, b = kNone;

  bool is_midpoint() const { return b != kNone; }
  friend auto operator<=>(const SurfaceVertex&, const SurfaceVertex&) = default;
};

struct GluedSurface {
  /// Input vertices in increasing order, then midpoints by (a, b); copies of one point stand together.
  std::vector<SurfaceVertex> vertices;
  /// Counter-clockwise seen from outside.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> tets;     ///< by triangle: the tetrahedron that it bounds; only if asked for
  std::uint32_t pinched_vertices = 0;  ///< input vertices with more than one copy
  std::uint32_t pinched_edges = 0;     ///< edges of input vertices with four or more boundary facets
  std::uint32_t split_edges = 0;       ///< edges split at a midpoint, counted once for each wedge
  std::uint32_t copies = 0;            ///< vertices beyond one for each point
};

/// Glues. Tetrahedra are given by input vertices a, b, c, d with det(b-a, c-a, d-a) > 0 and match by vertex
/// triples; those without a partner are the boundary. Without overlaps the result depends on the set of
/// tetrahedra only, not on their order nor on which even permutation of its vertices each is given by.
/// Errors: internal, if three facets share a triple, or two have the same side (overlapping tetrahedra);
/// too_large from 2^29 tetrahedra or 2^32 / 3 boundary triangles on. O(n log n + largest vertex), arrays
/// only. The context lends threads.
Result<GluedSurface> glue(std::span<const std::array<std::uint32_t, 4>> tets, const Context& context = {});

/// What is known before: the triangulations of the cells say what is next to what.
struct KnownFacets {
  /// By facet, that is by 4 * tetrahedron + slot: the facet glued to it, else kNone.
  UnsetVector<std::uint32_t> partner;
  /// Tetrahedra whose facets may match others although `partner` does not say so.
  std::vector<std::uint32_t> loose;
};

/// The same; what is known is taken on trust, so that only what is loose has to be matched. O(n + b log b + m
/// log m) for a boundary of b triangles and m facets at the vertices of what is loose.
Result<GluedSurface> glue(std::span<const std::array<std::uint32_t, 4>> tets, KnownFacets known,
                          const Context& context = {}, bool with_tets = false);

/// The boundary before it is cut apart: triangles with the smallest vertex first, sorted; side 3 t + i leads
/// from corner i of triangle t to the next one, and mate[side] is the side across its edge, through the
/// solid.
struct PairedBoundary {
  UnsetVector<std::array<std::uint32_t, 3>> triangles;
  UnsetVector<std::uint32_t> facets;  ///< by triangle: 4 * its tetrahedron + slot
  UnsetVector<std::uint32_t> mate;
};

/// Both halves of glue(): between them the tetrahedra may go, which are most of the memory.
Result<PairedBoundary> pair_boundary(std::span<const std::array<std::uint32_t, 4>> tets, KnownFacets known,
                                     const Context& context = {});
Result<GluedSurface> cut_apart(const PairedBoundary& boundary, const Context& context = {},
                               bool with_tets = false);

/// True iff the triangles form a closed oriented 2-manifold on exactly the vertices 0..vertex_count-1: three
/// different vertices each, every directed edge once and its reverse once, one cycle of triangles around each
/// vertex.
bool verify_surface(std::uint32_t vertex_count, std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace crossloft
