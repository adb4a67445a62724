#pragma once
/// Where the simplices of a cell lie. The modes `joint` and `paper` are combinatorial; `natural` measures.

#include <vector>

#include "../geom/vec3.h"

namespace crossloft {

/// The half space { normal.p + offset >= 0 } that a face bounds, the cell inside; |normal| = 1.
struct FacePlane {
  Vec3 normal;
  double offset = 0;

  double height(Vec3 p) const { return dot(normal, p) + offset; }
};

class LazySectionField;
struct CellMemory;

/// In one unit of length, any; coordinates may be rounded: they decide how good a tetrahedron is, never
/// what is next to what.
struct CellShape {
  std::vector<Vec3> points;      ///< by vertex of the complex
  std::vector<FacePlane> faces;  ///< by bit of the face masks; then faces without vertices
  /// The sections of all planes in the same coordinates, if joins in doubt may look at them.
  const LazySectionField* field = nullptr;
  /// What was measured before (confidence.h), if the cell has had other tetrahedra. Not for two threads.
  CellMemory* memory = nullptr;
};

}  // namespace crossloft
