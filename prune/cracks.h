#pragma once
/// What growth left open without need.

#include <cstdint>
#include <vector>

#include "cell_complex.h"
#include "cell_topology.h"
#include "contact.h"
#include "ground.h"

namespace crossloft {

/// Growth by single moves can stop at a crack: its first tetrahedron would make a handle that the last one
/// fills again. Adds each connected part of `allowed` outside of the solid as a whole where the solid keeps
/// the number of its bodies and handles, gets no hole, and closes off nothing that was open. At most 40
/// sets of parts are tried, in canonical order: their contact with the solid rules most of them out, for the
/// rest the cell is counted. Returns the count of the result.
CellTopology refill_cracks(const CellComplex& complex, const Ground& ground,
                           const std::vector<std::uint8_t>& allowed, GrowingSolid& solid);

}  // namespace crossloft
