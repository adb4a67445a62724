#pragma once
/// The largest solid subset of a set of tetrahedra.

#include <cstdint>
#include <vector>

#include "cell_complex.h"

namespace crossloft {

/// Clears `kept` for the tetrahedra outside of the largest solid subset of the given set (prune.h).
/// REQUIRES: kept.size() == complex.mesh.size(); no kept tetrahedron is external.
///
/// Each corner (star.h) of a kept tetrahedron that must be solid has a *parent*: the facet through which its
/// path to the ground of its star leads. A forest by breadth-first search from the ground gives the first
/// parents; corners that it doesn't reach make their tetrahedra fall. When one falls, the corners whose paths
/// led through it look for another way inside their star; those that find none fall in turn. This is the
/// paper's oriented pivoting (Step 2, Figures 8-10) with the orientation pointing to the ground, and serves
/// vertices as well as edges.
///
/// Time: linear for the forest, plus the sizes of the cut-off subtrees: linear in all for edges (a star of an
/// edge is a fan; its corners change sides at most once), at most the star's size a removal for vertices.
void keep_largest_solid_subset(const CellComplex& complex, std::vector<std::uint8_t>& kept);

/// True if each vertex and each grounded edge of the kept tetrahedra has an internal triangle of the cell at
/// it. Together with good extended links (CellTopology::bad_links is 0) that makes the kept set solid,
/// without a forest: a good link is a disk or a sphere, so what is kept at a vertex hangs together across facets and
/// through the sections, and so does what is kept at an edge, a fan of the disk; each of their parts that the
/// sections separate lies at one of them, so it has ground. Not the other way round. O(n).
bool has_ground_everywhere(const CellComplex& complex, const std::vector<std::uint8_t>& kept);

}  // namespace crossloft
