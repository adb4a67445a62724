#pragma once
/// Draws Moebius diagrams as SVG: coloured cells, arcs as true circular arcs, sites.

#include <optional>
#include <string>

#include "../geom/result.h"
#include "../moebius/cells.h"
#include "../moebius/diagram.h"
#include "svg.h"

namespace crossloft {

struct DiagramDrawing {
  std::optional<ViewBox> box;  ///< what is shown; without it view_of() the diagram
  double width = 800;          ///< of the page [pixels]
  bool sites = true;           ///< a dot at each site: a square if lambda <= 0, hollow if it has no cell
  bool labels = false;         ///< the number of each site, from 0
  const MoebiusCells* cells =
      nullptr;  ///< those of the diagram, if tooltips are to tell their pieces and holes
};

/// A box with all sites, and the vertices and whole circles near them, with a margin; not empty for any
/// diagram.
ViewBox view_of(const MoebiusDiagram& diagram);

/// The text of the SVG file. Groups: `cells`, one path for each cell that is seen, with a tooltip; `arcs`,
/// one circle or path for each arc that is seen, `data-arc` its number; `sites`, `labels`. The bytes depend
/// on the arguments alone. Errors: usage for a box or width that is empty or not finite, and for a page
/// higher than 100 times its width or wider than 100 times its height.
Result<std::string> format_diagram_svg(const MoebiusDiagram& diagram, const DiagramDrawing& drawing = {});

/// Writes the file, whole or not at all. Errors: those of format_diagram_svg, file_not_writable.
Result<Done> write_diagram_svg(const std::string& path, const MoebiusDiagram& diagram,
                               const DiagramDrawing& drawing = {});

}  // namespace crossloft
