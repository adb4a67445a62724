#pragma once
/// Bridges: where the solid would fall apart along an edge within a section, a thin piece of it is put back.
///
/// An edge inside a section has a fan of tetrahedra in each cell around it (prune/broken_fans.h). If none of
/// them is kept as a whole, the solid is pinched to the edge, though the section goes on across it: bodies
/// come apart, or a tunnel of no width opens. The tetrahedra of the gap can't be in the solid themselves,
/// most of them because another of their edges or triangles is outside of a section. They are divided: each
/// gets a *centre*, each facet between two of them a point of its own, both close to the edge, and the piece
/// at the edge, which contains nothing else of the tetrahedron, is taken. A bridge touches a cell's solid in
/// a disk, the two triangles where the gap ends, so it is a simple move: the cell's count stays as it was,
/// and what it takes for granted comes true. That holds for several as long as they meet each other in
/// triangles at their own edges only (BuiltBridges): elsewhere they would close a handle
/// or a dome.

#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "../geom/lattice.h"
#include "../prune/ground.h"
#include "cell_builder.h"

namespace crossloft {

/// Vertices of a piece from here on are bridge points; below, final numbers.
inline constexpr std::uint32_t kFirstBridgePoint = std::uint32_t{1} << 31;

/// One broken fan of a cell.
struct Bridge {
  std::array<std::uint32_t, 2> edge{};               ///< final numbers, ascending
  std::array<GroundTriangle, 2> ground{};            ///< section triangles at its ends
  std::vector<std::array<std::uint32_t, 4>> pieces;  ///< positively oriented; none: can't be bridged
};

struct CellBridges {
  /// Number kFirstBridgePoint + position; strictly inside the cell if a piece has it.
  std::vector<LatticePoint> points;
  std::vector<Bridge> bridges;
};

/// All broken fans of a cell, with the pieces that would close them. Every orientation is tested exactly: a
/// gap too thin for the grid has no pieces, and none has one that ends at a section triangle with a side
/// outside of another section. Pieces of different bridges of a cell are equal or do not overlap. O(n log n).
/// REQUIRES: the ground is that of the cell's complex.
CellBridges find_bridges(const BuiltCell& cell, const Ground& ground, const std::vector<std::uint8_t>& kept);

/// Those bridges of one cell that are built.
class BuiltBridges {
 public:
  /// Whether the bridge meets the others in triangles at its own edge only. O(pieces log n)
  bool fits(const Bridge& bridge) const;
  void add(const Bridge& bridge);
  /// Once each.
  const std::set<std::array<std::uint32_t, 4>>& pieces() const { return pieces_; }

 private:
  std::set<std::array<std::uint32_t, 4>> pieces_;
  std::set<std::array<std::uint32_t, 3>> sides_;  ///< of the pieces, vertices ascending
};

/// By number before: the final number now, of edges and pieces. REQUIRES: the order of the numbers is kept.
void renumber(CellBridges& bridges, std::span<const std::uint32_t> number);

}  // namespace crossloft
