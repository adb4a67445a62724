#pragma once
/// Is a point of a face inside its section? Many questions, answered from the contour cut into rows.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "cell_complex.h"
#include "cell_shape.h"
#include "ground.h"
#include "pair.h"

namespace crossloft {

/// The section of one face in the plane that drops the dominant axis of the face's normal. Rounded
/// coordinates and no ties: for confidences, not for decisions that must be exact.
class SectionRows {
 public:
  using Segment = std::array<double, 4>;  ///< u0, v0, u1, v1

  /// `contour`: every piece of the section's boundary once, in any order.
  SectionRows(int dropped_axis, std::span<const Segment> contour);

  bool empty() const { return pieces_.empty(); }
  /// Even-odd along the row of p. O(contour pieces in the row), a handful on smooth contours.
  bool contains(Vec3 p) const;
  /// The same in the plane without the dropped axis: the two others, in the order of x, y, z, x.
  bool contains(double u, double v) const;
  int dropped_axis() const { return axis_; }

 private:
  /// Two pieces, the second one perhaps at infinity, where nothing crosses it.
  struct TwoPieces {
    Pair u0, v0, u1, v1;
  };

  std::size_t row_of(double v) const;
  void fill(std::span<const Segment> contour);
  void fill_rows(std::span<const Segment> contour);

  int axis_;
  bool turned_ = false;               ///< rows go along the second coordinate
  std::vector<TwoPieces> pieces_;     ///< row by row
  std::vector<std::uint32_t> begin_;  ///< of each row in pieces_; one more at the end
  std::size_t rows_ = 0;
  double low_ = 0, high_ = 0, rows_per_unit_ = 0;
};

/// From the pieces of a contour in space, in the plane with that normal.
SectionRows rows_of_contour(Vec3 normal, std::span<const std::array<Vec3, 2>> contour);

/// The sections of all faces of a cell that have vertices, from its internal hull triangles.
/// O(n) for n internal triangles, and what of the contours is in the rows.
std::vector<SectionRows> section_rows(const CellComplex& complex, const Ground& ground,
                                      const CellShape& shape);

}  // namespace crossloft
