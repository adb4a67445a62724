#pragma once
/// The part of space that a set of sections is concerned with.

#include "complex.h"
#include "framed_sections.h"

namespace crossloft {

/// The bounding box of all walls with a margin of an eighth: cells further out hold nothing. Vertices that
/// the file has so far off their planes that they leave half the margin widen it. But for those a part has
/// the box of the whole: how sure a join is depends on it. REQUIRES: a plane.
LatticeBox data_box(const FramedSections& framed);

}  // namespace crossloft
