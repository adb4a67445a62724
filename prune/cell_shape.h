#pragma once
/// Where the simplices of a cell lie. The modes `joint` and `paper` are combinatorial; `natural` measures.

#include <vector>

#include "../geom/unit_plane.h"

namespace crossloft {

/// Bounds the half space of heights >= 0, the cell inside.
using FacePlane = UnitPlane;

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
