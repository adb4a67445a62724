#pragma once
/// A Moebius diagram as JSON; keys and their meaning are in docs/formats.md.

#include <string>

#include "../moebius/cells.h"
#include "../moebius/diagram.h"

namespace crossloft::cli {

/// Grows by one with every change that an old reader would stumble over.
inline constexpr int kDiagramVersion = 1;

/// One site, vertex or arc a line, with a line break at the end. `file` is where the sites are from.
std::string diagram_json(const MoebiusDiagram& diagram, const MoebiusCells& cells, const std::string& file);

}  // namespace crossloft::cli
