#pragma once
/// Slow independent checks of pruning's input and output.

#include "prune.h"

namespace crossloft {

/// True iff the arrays have one size, neighbours are mutual across equal vertex triples, and grounded facets
/// and edges are what the face masks say: common face of the vertices <=> kind is not `free`. O(n).
bool verify(const CellComplex& complex);

/// True iff the counts fit, no kept tetrahedron is external and the kept set is solid at every vertex and
/// grounded edge, found by matching facets through a sort instead of the mesh's neighbours. O(n log n).
/// Holds for the modes `joint` and `paper`; `paper_literal` may break it.
bool verify(const CellComplex& complex, const PruneResult& result);

/// The same for the mode `natural`: the counts fit, no kept tetrahedron is external, the topology counted
/// anew is the one reported, and the solid has no handle but those asked for, no hole and no body that is on
/// no section. O(n log n).
bool verify_natural(const CellComplex& complex, const PruneResult& result);

}  // namespace crossloft
