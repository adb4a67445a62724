#pragma once
/// Where points inside a cell would let its solid be what it is likely to be.
///
/// R1 is without all tetrahedra that have an edge or triangle outside of a section, however little of them is
/// there: where such a tetrahedron is large the solid loses a wall, and where all ways between two sections
/// lead through these the two can't be joined. A point inside such a tetrahedron divides it, so that only the
/// parts at its external edges and triangles are lost. Points inside a cell never change its hull, so no
/// face, no section and no other cell sees them.

#include <cstdint>
#include <vector>

#include "cell_complex.h"
#include "cell_shape.h"
#include "ground.h"

namespace crossloft {

/// (1) The centroids of external tetrahedra that are large and have a confidence of 0 or more, where no point
/// is inside the cell yet; 0 was found by measuring, with confidences as they are for such tetrahedra. (2)
/// Where R1 does not connect sections that R0 does: the most confident way from each, if it is as sure as
/// `least`; the centroids of its external tetrahedra and of the facets between two of them. A way along
/// external edges takes a few rounds until R1 has it. Not between more than 64 such sets. Coordinates of the
/// shape, in no meaningful order; they do not depend on the numbers of the tetrahedra. O(n) and a confidence
/// for each large external tetrahedron; where sections are not connected those of all, and O(n log n) for
/// each set of sections that are.
std::vector<Vec3> interior_places(const CellComplex& complex, const CellShape& shape, const Ground& ground,
                                  std::int32_t least);

}  // namespace crossloft
