#pragma once
/// Small sets of sections and options, drawn from bytes: half of them degenerate.

#include <string>

#include "../../reconstruct/reconstruct.h"
#include "byte_source.h"

namespace crossloft::test {

struct SectionSet {
  const char* kind = "";  ///< how the planes lie
  Sections sections;
  Options options;
  unsigned threads = 1;
  bool told_twice = false;  ///< also to be reconstructed from a rearranged copy: the same bytes are promised
  bool consistent = false;  ///< slices of one solid: an error is a broken promise
};

/// Planes at random, parallel, through a line, through a point, on a grid, cutting a sphere, a mesh, or
/// spheres; their contours are small polygons of all sorts, or the slices of a solid. Some are then moved by
/// a hair, rotated or scaled. Every sequence of bytes is a set.
SectionSet draw_section_set(ByteSource& bytes);

}  // namespace crossloft::test
