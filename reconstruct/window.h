#pragma once
/// A part of a stack of parallel planes, reconstructed by itself; internal to reconstruct/.
///
/// A cell of a stack, its *slab*, lies between two planes, and what becomes of it depends on a few slabs
/// above and below alone (README). So the surface of a part is that of the whole but for a few slabs at its
/// ends.

#include <cstdint>
#include <vector>

#include "reconstruct.h"

namespace crossloft {

/// Planes are numbered from the lowest to the highest along their normal, after equal ones became one; slab s
/// has s planes below it.
struct Window {
  Surface surface;
  Report report;
  std::vector<std::uint32_t> planes;  ///< first position of each in the file
  std::vector<std::uint32_t>
      vertex_plane;  ///< by vertex of the surface: the plane that it came from, or kNone
  std::vector<std::uint32_t> triangle_slab;
  std::vector<std::uint32_t> contact_slab;  ///< by pair of triangles that touch: the lower slab of the two
  std::vector<std::uint32_t>
      touching_slab;                        ///< by copy left at the place of another, for Options::separation
  std::vector<std::uint32_t> crowded_slab;  ///< by copy that touches others and has too much around it
  std::vector<std::uint32_t> unsampled;     ///< planes that go without the branching samples that were wanted
  std::vector<std::uint32_t> cell_slab;  ///< by cell of the report
  std::vector<std::uint32_t> slab_tets;  ///< by slab: tetrahedra of the solid
  std::vector<std::uint8_t> heard;       ///< by request: 1 if some cell of the window has both contours
  std::vector<std::string> framing_notes,
      framing_warnings;  ///< those of the report that are about single planes
};

/// REQUIRES: planes that are parallel, with `part_of`; `joins` of planes that are in the stack. Errors: as
/// reconstruct().
Result<Window> reconstruct_window(const Sections& sections, const Options& options, const Context& context);

}  // namespace crossloft
