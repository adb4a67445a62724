#pragma once
/// The part of space that a set of sections is concerned with.

#include "complex.h"
#include "framed_sections.h"

namespace crossloft {

/// The bounding box of all vertices with a margin of an eighth: cells further out hold nothing.
LatticeBox data_box(const FramedSections& framed);

}  // namespace crossloft
