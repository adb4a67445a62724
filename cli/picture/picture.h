#pragma once
/// A picture of a reconstruction: its sections on the left, its surface with the sections on it on the right.

#include "../../arrangement/sections.h"
#include "../../reconstruct/surface.h"
#include "canvas.h"

namespace crossloft::cli {

struct PictureOptions {
  int width = 1200, height = 675;   ///< pixels
  Vec3 from = {0.42, -0.90, 0.36};  ///< direction to the viewer, z is up
  Vec3 middle;                      ///< of what is shown if
  double reach = 0;                 ///< this is not 0: how far around it
};

/// True iff the part to be shown is away from the box of the data.
bool is_beside(const Sections& sections, const Surface& surface, const PictureOptions& options);

/// Draws, seen without perspective, standing on the ground. Depends on its arguments only.
Image draw_picture(const Sections& sections, const Surface& surface, const PictureOptions& options = {});

}  // namespace crossloft::cli
