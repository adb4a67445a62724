#pragma once
/// Draws one face of a cell as SVG: its section, the arcs of its branching diagram, the samples taken on
/// them.

#include <array>
#include <string>
#include <vector>

#include "../geom/result.h"
#include "arc_trace.h"

namespace crossloft {

/// What is drawn, in coordinates of the face's plane; every list may be empty.
struct FaceDrawing {
  std::string title;
  std::vector<std::vector<Vec2>> face;  ///< closed polygons, outlined
  std::vector<std::vector<Vec2>>
      section;  ///< closed polygons, filled even-odd: contours, or disjoint triangles
  std::vector<std::array<Vec2, 2>> contour;  ///< edges between inside and outside
  std::vector<ArcShape> arcs;
  std::vector<Vec2> sites;    ///< feet of the section vertices that the diagram is of
  std::vector<Vec2> samples;  ///< dots
};

/// The text of the SVG file, of 800 pixels on the longer side. It shows the section and the samples with a
/// margin, where there is neither the face, where there is no face either the unit square. Groups from bottom
/// to top: `section`, `face`, `arcs` (those that are seen, cut at the page), `contour`, `sites`, `samples`.
std::string format_face_svg(const FaceDrawing& drawing);

/// Writes the file, whole or not at all. Errors: file_not_writable.
Result<Done> write_face_svg(const std::string& path, const FaceDrawing& drawing);

}  // namespace crossloft
