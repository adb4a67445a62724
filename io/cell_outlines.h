#pragma once
/// The cells of a Moebius diagram as closed outlines within a rectangle: for drawing, in doubles.
///
/// Arcs are cut at the border of the rectangle; between two crossings the border belongs to one cell. Arcs
/// and stretches of the border, each with its cell on the left, chain up to closed outlines:
///
///     +---<---x---<---+     x  crossing of an arc with the border
///     |  cell  \      |     o  vertex
///     v   i     o--<--x     the outline of i runs along the border up to the lower crossing, along the arc
///     |        /      |     to the vertex, along the other arc to the upper crossing, and on along the
///     border
///     +--->---x-------+

#include <cstdint>
#include <vector>

#include "../moebius/diagram.h"
#include "curve_piece.h"

namespace crossloft {

using Outline = std::vector<CurvePiece>;

struct DiagramInBox {
  ViewBox box;
  std::vector<std::vector<CurveRun>> arcs;  ///< per arc its parts in the box
  std::vector<std::vector<Outline>>
      cells;  ///< per site the closed outlines of its cell, the cell on the left
};

/// Cuts the diagram at a rectangle a little larger than `view`, so that neither the cut nor the ends of
/// strokes are seen. Where rounding has put arcs that nearly coincide in an order that can't be, an outline
/// is closed by a segment. O((n + c) log n) for n arcs with c crossings of the border.
DiagramInBox clip_diagram(const MoebiusDiagram& diagram, const ViewBox& view);

/// The first of the sites that are nearest to a point, in doubles; kNone if there is no site. Linear time.
std::uint32_t nearest_site(const std::vector<MoebiusSite>& sites, Vec2 x);

/// Which sites have a cell; the others are hidden.
std::vector<bool> sites_with_cell(const MoebiusDiagram& diagram);

}  // namespace crossloft
