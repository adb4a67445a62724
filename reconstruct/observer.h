#pragma once
/// A view into every intermediate product, for study, pictures and tests.

#include <array>
#include <cstdint>
#include <span>

#include "../arrangement/section_graph.h"
#include "../prune/prune.h"
#include "branching.h"
#include "cell_builder.h"
#include "face_triangulation.h"
#include "numbering.h"

namespace crossloft {

/// Called from the calling thread, in canonical order, after the stage is complete. References are valid during the
/// call. With an observer all cells are held in memory until they have been shown.
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void on_sections(const FramedSections&, const Arrangement&, const SectionGraph&) {}
  /// One side of a face, with the triangulation and numbers from before samples came in.
  virtual void on_branching(const FaceBranching&, const FaceTriangulation&, const Numbering&) {}
  virtual void on_face(const FaceTriangulation&, const Numbering&) {}
  virtual void on_cell(CellId, const BuiltCell&, const PruneResult&) {}
  /// All kept tetrahedra by final vertex numbers.
  virtual void on_solid(std::span<const std::array<std::uint32_t, 4>>, const Numbering&) {}
};

}  // namespace crossloft
