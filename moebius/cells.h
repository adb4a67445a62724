#pragma once
/// The cells of a Moebius diagram: which arcs bound them, how many pieces each has, and which holes.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "../geom/ids.h"
#include "diagram.h"

namespace crossloft {

/// An arc of the diagram walked with the cell on the left: from `from` to `to`, or backwards for the cell of
/// sites[1].
struct CellStep {
  std::uint32_t arc = kNone;
  bool backwards = false;
  friend bool operator==(const CellStep&, const CellStep&) = default;
};

/// A closed walk along the border of a cell. After a step that runs to infinity it goes on counter-clockwise
/// around the circle at infinity (by at most half a turn) to the next step, which comes from there; the last
/// step is followed by the first.
struct CellLoop {
  std::uint32_t first = 0, count = 0;  ///< its steps
  std::uint32_t component = kNone;
  bool is_hole = false;  ///< it surrounds what is not of the component: clockwise, else counter-clockwise
};

/// A connected piece of a cell: its loops, the outer one first. Only the piece that surrounds the whole rest
/// of the diagram has no outer loop.
struct CellComponent {
  std::uint32_t site = kNone;
  std::uint32_t first_loop = 0, loop_count = 0;
  bool has_outer = true;
  std::uint32_t hole_count() const { return loop_count - (has_outer ? 1 : 0); }
};

/// The components in the order of their sites, the loops in the order of their components, the steps in that
/// of their loops.
struct MoebiusCells {
  std::vector<CellStep> steps;
  std::vector<CellLoop> loops;
  std::vector<CellComponent> components;
  std::vector<std::uint32_t> first_component;  ///< of each site, and the end of the last one

  std::span<const CellStep> steps_of(const CellLoop& loop) const {
    return {steps.data() + loop.first, loop.count};
  }
  std::span<const CellLoop> loops_of(const CellComponent& component) const {
    return {loops.data() + component.first_loop, component.loop_count};
  }
  /// None for a hidden site, several for a disconnected cell.
  std::span<const CellComponent> components_of(std::uint32_t site) const {
    return {components.data() + first_component[site], first_component[site + 1] - first_component[site]};
  }
};

/// The vertices where a step begins and ends; kNone at infinity and on a whole curve.
std::uint32_t begin_vertex(const MoebiusDiagram& diagram, CellStep step);
std::uint32_t end_vertex(const MoebiusDiagram& diagram, CellStep step);

/// The cells of a diagram. Loops, pieces and holes are counted by following the arcs, without a look at
/// coordinates. These decide in doubles which one loop of a connected group of arcs goes around it (that of
/// least signed area), and, only where the surrounding cell has several pieces, in which of them the group
/// lies. O(n log n), plus for each such group the arcs of those pieces. REQUIRES: verify(diagram) is empty.
MoebiusCells moebius_cells(const MoebiusDiagram& diagram);

}  // namespace crossloft
