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
///
/// Where kept tetrahedra reach the edge between two gaps they are a *wedge* that touches the section there
/// without being joined with it. A bridge fills all gaps at its edge and joins the wedges too. Its contact is
/// the triangles where the gaps end, two for each of the wedges and for the section, which come together at
/// the ends of the edge as far as wedges hang together there (prune/link_parts.h). With n of them, wedges and
/// section, and p parts in the links of both ends the contact has the Euler characteristic p - n: it is k
/// disks iff it has k parts and that is k. One disk is a simple move: bridges close a slit between a wedge
/// and the section as one zips it, from an end where both hang together. More disks in one body make a handle
/// each but the first.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "../geom/lattice.h"
#include "../prune/ground.h"
#include "cell_builder.h"

namespace crossloft {

/// Vertices of a piece from here on are bridge points; below, final numbers.
inline constexpr std::uint32_t kFirstBridgePoint = std::uint32_t{1} << 31;

/// What the solid has at an edge, by prune/link_parts.h.
struct Wedge {
  std::array<std::uint32_t, 2> parts{};  ///< of the links of the two ends
  std::uint32_t body = 0;
};

/// One broken fan of a cell.
struct Bridge {
  std::array<std::uint32_t, 2> edge{};               ///< final numbers, ascending
  std::array<GroundTriangle, 2> ground{};            ///< section triangles at its ends
  std::vector<std::array<std::uint32_t, 4>> pieces;  ///< positively oriented; none: can't be bridged
  std::vector<Wedge> wedges;                         ///< with several gaps: the section, then the others
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
  /// How many handles the cell's solid gets with the bridge; nothing if it meets other bridges elsewhere than
  /// in triangles at its own edge, or would join bodies or close a wall. O((pieces + w^2) log n) for w wedges
  std::optional<std::uint32_t> handles_of(const Bridge& bridge) const;
  void add(const Bridge& bridge);
  /// Once each.
  const std::set<std::array<std::uint32_t, 4>>& pieces() const { return pieces_; }

 private:
  bool is_apart(const Bridge& bridge) const;
  /// What the part of a link has become part of.
  std::uint32_t root_of(std::uint32_t part) const;

  std::set<std::array<std::uint32_t, 4>> pieces_;
  std::set<std::array<std::uint32_t, 3>> sides_;  ///< of the pieces, vertices ascending
  std::map<std::uint32_t, std::uint32_t> joined_;  ///< parts of links that are part of a smaller number's
};

/// By number before: the final number now, of edges and pieces. REQUIRES: the order of the numbers is kept.
void renumber(CellBridges& bridges, std::span<const std::uint32_t> number);

}  // namespace crossloft
