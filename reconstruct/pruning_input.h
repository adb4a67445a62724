#pragma once
/// What pruning wants to know of a cell beside its tetrahedra: where they are, and what the user asks for.

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "../arrangement/complex.h"
#include "../arrangement/section_graph.h"
#include "../prune/cell_shape.h"
#include "../prune/natural.h"
#include "../prune/section_field.h"
#include "cell_builder.h"
#include "join_request.h"

namespace crossloft {

/// The cell in rounded lattice coordinates. `faces`: those with vertices, in the order of the masks; those of
/// the arrangement's box come after them.
CellShape cell_shape(const Arrangement& arrangement, CellId id, std::span<const FaceId> faces,
                     const BuiltCell& cell);

/// All sections in the same coordinates.
SectionField section_field(const SectionGraph& graph);

/// Requests and questions by local vertices instead of final numbers.
SecondThoughts by_local_numbers(SecondThoughts questions, const BuiltCell& cell);
CellRequests by_local_numbers(CellRequests requests, const BuiltCell& cell);
/// The other way around; faces by their numbers in the arrangement. `faces`: as in cell_shape.
Answers by_final_numbers(Answers answers, std::span<const FaceId> faces, const BuiltCell& cell);

/// A contour of the file at a vertex.
struct ContourVertex {
  std::uint32_t plane = 0, contour = 0, vertex = 0;
  friend auto operator<=>(const ContourVertex&, const ContourVertex&) = default;
};

/// The contours of a cell: those with walls on its faces, or on their borders where they bound the section.
class CellContours {
 public:
  explicit CellContours(std::span<const CellFace> faces);

  /// By final numbers, ascending. O(log n) for n vertices of walls.
  std::span<const ContourVertex> vertices(std::uint32_t plane, std::uint32_t contour) const;

 private:
  std::vector<ContourVertex> vertices_;  ///< ascending
};

/// The requests that concern a cell, by its local vertices.
std::vector<JoinWish> cell_wishes(std::span<const JoinRequest> requests, std::span<const CellFace> faces,
                                  const BuiltCell& cell);

}  // namespace crossloft
