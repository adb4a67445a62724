#pragma once
/// Conforming edge recovery: splits segments until each piece is an edge of the Delaunay triangulation.

#include <array>
#include <cstdint>
#include <vector>

#include "conform_plan.h"
#include "delaunay2.h"

namespace crossloft {

/// Makes every segment a chain of edges of `tri` by adding points. Segments may share ends and have no other
/// point in common; ends are vertices of `tri`, not points that another stands for.
///
/// `split(const SplitRequest&) -> std::uint32_t` makes a point near request.from + t (request.to -
/// request.from), adds it to the predicates object of `tri` and returns its index, or kNone if it can't. The
/// point may lie off the segment by a hair; nothing here assumes that pieces are collinear. It may also be an
/// existing vertex. A split that is not closer to both ends than they are to each other is no progress: the
/// piece is given up. At most `limit` splits are made.
///
/// On return `segments` holds the pieces, those of one segment in a row and in its direction, and the result
/// says where they came from and which failed. The splits depend on the geometry alone, not on indices or
/// the order or direction of the segments, if `split` does so too.
///
/// Time: O(rounds + pieces log pieces) and the insertions; rounds are about log2 of the deepest subdivision.
/// Source: splitting at shells around acute corners after Ruppert, A Delaunay Refinement Algorithm (1995).
template <MetricPredicates2 P, class Split>
ConformResult conform(Delaunay2<P>& tri, std::vector<std::array<std::uint32_t, 2>>& segments, Split&& split,
                      std::uint32_t limit);

}  // namespace crossloft

#include "conform_impl.h"
