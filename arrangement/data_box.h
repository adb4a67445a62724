#pragma once
/// The part of space that a set of sections is concerned with.

#include "complex.h"
#include "framed_sections.h"

namespace crossloft {

/// The bounding box of all vertices with a margin of an eighth: cells further out hold nothing. The box of a
/// part is that of the whole, up to how far vertices move to the lattice: how sure a join is depends on it.
LatticeBox data_box(const FramedSections& framed);

}  // namespace crossloft
