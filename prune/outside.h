#pragma once
/// Parts of a cell outside of its solid, and what they open to.

#include <array>
#include <cstdint>
#include <vector>

#include "cell_complex.h"

namespace crossloft {

/// What the outside part behind a wall of the solid opens to.
enum class Opening : std::uint8_t {
  none,  ///< nothing: a void in the cell
  hole,  ///< a hole in the section of one face: its wall is a dome over the hole
  wide,  ///< several faces, or the space beyond the hull of the cell's vertices
};

/// Gathers what a part of the outside opens to, one tetrahedron after the other.
class OpeningOf {
 public:
  explicit OpeningOf(const CellComplex& complex) : complex_(complex) {}
  void add(std::uint32_t t);
  Opening kind() const { return kind_; }
  /// Of the hole. REQUIRES: it is one.
  std::uint32_t face() const { return face_; }

 private:
  const CellComplex& complex_;
  Opening kind_ = Opening::none;
  std::uint32_t face_ = kNone;  ///< the one face so far
};

/// A part of the outside that is a hole under a dome.
struct ClosedHole {
  std::vector<std::uint32_t> tets;  ///< ascending
  std::uint32_t face = kNone;       ///< in whose section the hole is
  Triangle name{};                  ///< its smallest hull triangle
};

/// All holes under domes. Parts of the outside hang together at facets and edges, as gluing leaves the outside
/// connected along edges. O(n log n).
std::vector<ClosedHole> closed_holes(const CellComplex& complex, const std::vector<std::uint8_t>& kept);
bool has_dome(const CellComplex& complex, const std::vector<std::uint8_t>& kept);

}  // namespace crossloft
