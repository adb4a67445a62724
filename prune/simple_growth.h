#pragma once
/// Growth of the solid from the sections by moves that make no handle.
///
/// The solid K starts as the ground alone (ground.h). A tetrahedron t is added to K along its *contact* C,
/// the facets shared with K; two of them hang together at a vertex of t if K connects them within the
/// vertex's star. Adding t changes the Euler characteristic of K by d = 1 - euler(C):
///     d = 1 + 2 f - c - sum over the vertices of m,
/// f = facets of C, c = edges of t that become inner ones, m = parts that C has at the vertex. With k parts
/// of C, its loops are b = d - 1 + k, and the move is
///   - simple (k = 1, b = 0): C is a disk. K keeps its homotopy type.
///   - join (k > 1, b = 0, all parts in different bodies of K): bodies become one, no handle.
///   - dome (k = 1, b > 0): closes off a part of the outside, since K without handles has no tunnel to fill.
///     Not done where that part would be a void in the cell, nor over a hole in one section unless confident
///     enough; walls between wider parts of the outside are.
///   - plug (k = 1, b < 0): all of t is in contact and fills the last of a void.
///   - loop (the rest): would make a handle; not done, but where the sections ask for one.
/// So the surface of the cell keeps genus 0 (cell_topology.h), whatever tetrahedra are allowed and in
/// whatever order, but for the handles asked for. The order decides which joins and domes come about: most
/// confident first, so that the tetrahedron that joins two bodies is the bottleneck of the best way between
/// them.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "../geom/context.h"
#include "cell_complex.h"
#include "contact.h"
#include "ground.h"
#include "joins.h"

namespace crossloft {

/// What the user, or the function through the sections around (likely_joins.h), wants of two sets of section
/// vertices: that bodies with one of each are joined, whatever the confidence, or that no body gets one of
/// each by a join.
struct JoinWish {
  std::vector<std::uint32_t> a, b;  ///< vertices of the cell, ascending
  bool join = true;
};

/// Two tetrahedra of the outside between which growth builds no wall. REQUIRES: they are not allowed.
struct OpenRequest {
  TetName from{}, to{};
};

struct GrowthLimits {
  std::int32_t join = 0;  ///< confidence that a join needs
  std::int32_t dome = 0;  ///< and a dome
  std::span<const JoinWish> wishes = {};
  std::span<const OpenRequest> open = {};
  std::int32_t handle = 0;  ///< confidence that a handle needs
  /// Whether a tetrahedron, an external one too, may be solid after all. A loop that such ones fill
  /// (open_loops.h) is a gap and no handle. Nothing: no handles.
  std::function<bool(std::uint32_t)> may_fill = {};
  CancelFlag cancel = nullptr;  ///< once it is raised growth ends, wherever it is
};

struct GrowthResult {
  std::vector<std::uint8_t> kept;
  std::vector<Join> joins;          ///< in the order of growth; then those refused, the best of each pair
  std::vector<std::int32_t> domes;  ///< confidences, in the order of growth
  std::uint32_t handles = 0;        ///< that the sections ask for
};

/// Grows over the tetrahedra with allowed[t] != 0. Tetrahedra of equal confidence go by their sorted
/// vertices, so the result does not depend on their numbers. O(n log n) and a few rounds over those put off.
/// What `solid` has beside the ground stays, and growth goes on from there. REQUIRES: an allowed tetrahedron
/// has no external facet; what the solid has is allowed and makes no handle. It is what has grown then.
GrowthResult grow_simply(const CellComplex& complex, const Ground& ground,
                         const std::vector<std::uint8_t>& allowed, std::span<const std::int32_t> confidence,
                         const GrowthLimits& limits, GrowingSolid& solid);
/// The same, of which only the result is wanted.
GrowthResult grow_simply(const CellComplex& complex, const Ground& ground,
                         const std::vector<std::uint8_t>& allowed, std::span<const std::int32_t> confidence,
                         const GrowthLimits& limits);

}  // namespace crossloft
