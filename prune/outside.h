#pragma once
/// Parts of a cell outside of its solid, and what they open to.

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
  explicit OpeningOf(const CellComplex& complex) : complex_(&complex) {}
  void add(std::uint32_t t);
  /// A single facet, as far as it is on the hull and not within a section.
  void add(std::uint32_t t, unsigned facet);
  /// Another part that belongs to this one.
  void add(const OpeningOf& other);
  Opening kind() const { return kind_; }
  /// Of the hole, if it is one; else any of the faces or kNone.
  std::uint32_t face() const { return face_; }

 private:
  void add_hole(std::uint32_t face);

  const CellComplex* complex_;
  Opening kind_ = Opening::none;
  std::uint32_t face_ = kNone;  ///< the one face so far
};

/// A part of the outside, hanging together at facets and edges.
struct OutsidePart {
  std::vector<std::uint32_t> tets;  ///< in no meaningful order
  OpeningOf opening;
};

/// The part that a tetrahedron outside is in. O(its size and the degrees of its edges).
OutsidePart outside_part(const CellComplex& complex, const std::vector<std::uint8_t>& kept,
                         std::uint32_t start);

/// True iff some part of the outside is a hole under a dome. Parts hang together at facets and edges, as
/// gluing leaves the outside connected along edges. O(n) and the degrees of edges at parts that are not wide.
bool has_dome(const CellComplex& complex, const std::vector<std::uint8_t>& kept);

}  // namespace crossloft
